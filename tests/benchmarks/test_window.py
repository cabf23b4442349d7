"""The window: start-up, how long it keeps a person waiting, sliders, compilation in its process.

A gap is the time between two ticks of a timer of 5 ms in the window. Drawing is what VTK and Qt
paint, with software OpenGL where there is no other; the plot is matplotlib's drawing; the rest is
ours and has to stay below 50 ms.
"""

import gc
import os
import subprocess
import sys
import time
from statistics import median
from types import SimpleNamespace

import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QSettings, Qt, QTimer
from PySide6.QtWidgets import QMainWindow

from app.ui.controls import JumpSlider
from core.smoothing import METHODS
from core.study import MethodChoice, Study
from core.view import ViewSettings

pytestmark = pytest.mark.skipif(
    sys.platform.startswith("linux") and not os.environ.get("DISPLAY"), reason="there is no display"
)

_TICK = 5
_END = object()
_STARTS = 5
# numba measures coverage if it finds the package, which is there only for the tests.
_PLAIN = "import sys; sys.modules['coverage'] = None; "
_BASE = f"{_PLAIN}import PySide6.QtWidgets, pyvista, pyvistaqt"
_WINDOW = f"""{_PLAIN}
import os
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication
wait = QApplication.exec

def leave_when_idle(*_):
    QTimer.singleShot(0, lambda: QTimer.singleShot(0, lambda: os._exit(0)))
    return wait()

QApplication.exec = leave_when_idle
from app.ui.application import start
start("sample:creature")
"""


class Watch:
    """Ticks of a timer in the window, and when it drew.

    Panes are drawn in turns of their own, or when the window is painted: that event also holds what
    Qt paints and what the surfaces need to be shown.
    """

    def __init__(self, monkeypatch):
        from app.ui.main_window import MainWindow
        from app.ui.plot_canvas import PlotCanvas
        from app.ui.viewport import Viewport

        self.ticks, self.drawings, self.plots = [], [], []
        self._note_steps(monkeypatch, Viewport, "_draw", self.drawings)
        self._note_steps(monkeypatch, PlotCanvas, "show_chart", self.plots)
        self._note(monkeypatch, PlotCanvas, "draw", self.plots)
        self._note_painting(monkeypatch, MainWindow)
        self._timer = QTimer(interval=_TICK, timerType=Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(lambda: self.ticks.append(time.perf_counter()))
        self._timer.start()

    def _note_painting(self, monkeypatch, window):
        plain = window.event

        def event(self_, event):
            begun = time.perf_counter()
            answer = plain(self_, event)
            if event.type() == QEvent.Type.UpdateRequest:
                self.drawings.append((begun, time.perf_counter()))
            return answer

        monkeypatch.setattr(window, "event", event, raising=False)

    @staticmethod
    def _note(monkeypatch, owner, name, times):
        plain = getattr(owner, name)

        def timed(widget, *arguments):
            begun = time.perf_counter()
            answer = plain(widget, *arguments)
            times.append((begun, time.perf_counter()))
            return answer

        monkeypatch.setattr(owner, name, timed)

    @staticmethod
    def _note_steps(monkeypatch, owner, name, times):
        plain = getattr(owner, name)

        def timed(widget, *arguments):
            steps = plain(widget, *arguments)
            while True:
                begun = time.perf_counter()
                more = next(steps, _END)
                times.append((begun, time.perf_counter()))
                if more is _END:
                    return
                yield

        monkeypatch.setattr(owner, name, timed)

    def clear(self):
        for times in (self.ticks, self.drawings, self.plots):
            times.clear()

    def gaps(self):
        """Milliseconds of each gap: all of it, drawing in it, the plot in it, and the rest."""
        rows = []
        for begin, end in zip(self.ticks, self.ticks[1:], strict=False):
            drawing = _covered(self.drawings, begin, end)
            painted = _covered([*self.drawings, *self.plots], begin, end)
            rows.append((end - begin, drawing, painted - drawing, end - begin - painted))
        return [tuple(1000 * part for part in row) for row in rows]


def _covered(spans, begin, end):
    """Seconds between two moments that lie in any of some spans."""
    covered, reached = 0.0, begin
    for first, last in sorted(spans):
        covered += max(0.0, min(last, end) - max(first, reached))
        reached = max(reached, last)
    return covered


@pytest.fixture
def watch(monkeypatch):
    return Watch(monkeypatch)


@pytest.fixture
def window(qtbot, tmp_path, watch):
    QCoreApplication.setOrganizationName("BurnishTests")
    QSettings.setDefaultFormat(QSettings.Format.IniFormat)
    QSettings.setPath(QSettings.Format.IniFormat, QSettings.Scope.UserScope, str(tmp_path))
    from app.ui.main_window import MainWindow

    window = MainWindow()
    window.resize(1600, 950)
    window.show()
    gc.freeze()  # as the program does
    yield window
    gc.unfreeze()
    window.files.discard_changes()
    window.close()
    window.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


@pytest.fixture
def opened(qtbot, window, shared_models):
    """Open a study on a model and wait until everything is computed and drawn."""

    def open_study(model, methods, iterations):
        choices = tuple(
            MethodChoice(method=id_, iterations=iterations, enabled=id_ in methods)
            for id_ in METHODS
        )
        study = Study(model=str(shared_models / model), methods=choices, view=ViewSettings())
        window.session.apply(study, "Open")
        _rest(qtbot, window)

    return open_study


def _rest(qtbot, window):
    session = window.session
    qtbot.waitUntil(
        lambda: session.meshes is not None and not session.tasks.states(), timeout=300_000
    )
    qtbot.wait(500)
    qtbot.waitUntil(lambda: not session.tasks.states() and window.denoise.is_drawn, timeout=300_000)


def _wait(condition):
    """Process events until a condition holds, without a pause in which nobody would see it."""
    while not condition():
        QCoreApplication.processEvents()


def _note_worst(benchmark, watch):
    for word, part in (("gap", 0), ("drawing", 1), ("plot", 2), ("rest", 3)):
        benchmark.extra_info[f"worst {word} ms"] = round(max(row[part] for row in watch.gaps()))
    over = sum(row[3] > 50 for row in watch.gaps())
    benchmark.extra_info["gaps with a rest over 50 ms"] = over


def test_start(benchmark, tmp_path):
    """From the start of the process to a window that answers while its model is loading."""
    if os.environ.get("QT_QPA_PLATFORM") == "offscreen":
        pytest.skip("there is no OpenGL without a display")
    times = {code: [] for code in (_BASE, _WINDOW)}
    folders = {f"XDG_{kind}_HOME": str(tmp_path / kind) for kind in ("STATE", "CONFIG", "CACHE")}

    def start(code):
        begun = time.perf_counter()
        subprocess.run(
            [sys.executable, "-c", code], check=True, stderr=subprocess.DEVNULL,
            env=os.environ | folders,
        )  # fmt: skip
        times[code].append(time.perf_counter() - begun)

    start(_BASE)
    start(_WINDOW)
    benchmark.pedantic(lambda: start(_WINDOW), setup=lambda: start(_BASE), rounds=_STARTS)
    for word, of in (("least", min), ("median", median)):
        benchmark.extra_info[f"{word} ratio"] = round(of(times[_WINDOW]) / of(times[_BASE]), 2)


@pytest.mark.parametrize("model", ["horse_19851.off", "rocker_arm_40177.obj", "cow_92864.ply"])
def test_gaps_while_six_methods_run(benchmark, qtbot, window, opened, watch, model):
    opened(model, METHODS, 0)
    session = window.session

    def run():
        study = session.study
        for choice in study.methods:
            study = study.with_choice(choice.model_copy(update={"iterations": 10}))
        watch.clear()
        session.apply(study, "Run")
        qtbot.waitUntil(lambda: session.activity is None, timeout=300_000)

    benchmark.pedantic(run, rounds=1)
    _note_worst(benchmark, watch)


def test_iterations_dragged_on_three_panes(benchmark, qtbot, window, opened, watch):
    """A step of the slider over computed iterations, and the share of it that is drawing."""
    opened("cow_92864.ply", ("diffusion",), 12)
    slider = window.denoise.methods.blocks["diffusion"].iterations.slider
    grid = window.denoise.viewport.grid
    steps, drawn = [], []

    def is_shown(place):
        caption = next(pane.caption for pane in grid.panes if pane.id == "diffusion")
        return caption.startswith(f"k = {place} ") and window.denoise.is_drawn

    def step(place):
        watch.clear()
        begun = time.perf_counter()
        slider.setValue(place)
        _wait(lambda: is_shown(place))
        steps.append(time.perf_counter() - begun)
        drawn.append(_covered(watch.drawings, begun, time.perf_counter()))

    benchmark.pedantic(lambda: [step(place) for place in (*range(11, 0, -1), *range(1, 13))])
    benchmark.extra_info["step ms"] = round(1000 * median(steps))
    benchmark.extra_info["share of drawing %"] = round(100 * median(drawn) / median(steps))


def test_resolution_dragged(benchmark, qtbot, window, opened, watch, monkeypatch):
    """R from 1 to 64 as fast as it is drawn, with the button held down."""
    held = SimpleNamespace(mouseButtons=lambda: Qt.MouseButton.LeftButton)
    monkeypatch.setattr("app.ui.skeleton_viewport.QGuiApplication", held)
    opened("cow_92864.ply", ("diffusion",), 0)
    window.tabs.setCurrentWidget(window.skeleton)
    _rest(qtbot, window)
    frames, drawn = [], []

    def step(resolution):
        study = window.session.study
        view = study.skeleton.views[1].model_copy(update={"resolution": resolution})
        skeleton = study.skeleton.with_view(1, view)
        watch.clear()
        begun = time.perf_counter()
        window.session.apply(study.model_copy(update={"skeleton": skeleton}), "R")
        there = window.skeleton.views.skeleton
        qtbot.waitUntil(lambda: there(1).view == view and bool(watch.drawings), timeout=30_000)
        frames.append(time.perf_counter() - begun)
        drawn.append(_covered(watch.drawings, begun, time.perf_counter()))

    def drag():
        for resolution in range(1, 65):
            step(resolution)

    benchmark.pedantic(drag, rounds=1)
    benchmark.extra_info["median frame ms"] = round(1000 * median(frames))
    benchmark.extra_info["share of drawing %"] = round(100 * median(drawn) / median(frames))
    benchmark.extra_info["longest frame ms"] = round(1000 * max(frames))


def test_painting_beside_the_drawing_area(benchmark, qtbot, window, opened):
    """A control that is painted again, against the same control in a window without OpenGL."""
    opened("horse_19851.off", ("diffusion",), 0)
    alone = QMainWindow()
    qtbot.addWidget(alone)
    alone.resize(window.size())
    alone.setCentralWidget(JumpSlider())
    alone.show()
    qtbot.waitExposed(alone)
    beside = window.denoise.methods.blocks["diffusion"].iterations.slider

    def paint(control):
        begun = time.perf_counter()
        control.update()
        QCoreApplication.processEvents()
        return time.perf_counter() - begun

    times = [(paint(beside), paint(alone.centralWidget())) for _ in range(50)]
    benchmark.pedantic(lambda: paint(beside), rounds=50)
    here, plain = (1000 * median(column) for column in zip(*times, strict=True))
    benchmark.extra_info.update({"ms": round(here, 1), "without OpenGL ms": round(plain, 1)})


def test_nothing_is_compiled(benchmark, qtbot, window, opened):
    """Kernels come from the disk: as fast after `make run` as ever."""
    from numba.core import event

    with event.install_recorder("numba:compile") as compiled:
        opened("horse_19851.off", METHODS, 2)
        for place in (1, 2, 0):
            window.tabs.setCurrentIndex(place)
            _rest(qtbot, window)
        benchmark.pedantic(lambda: None)
    benchmark.extra_info["compiled"] = len(compiled.buffer)
    assert not compiled.buffer
