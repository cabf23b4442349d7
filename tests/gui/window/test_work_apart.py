"""Long work in C beside the window: the window goes on, and takes the work with it when it goes."""

import threading

import pytest
from PySide6.QtCore import QTimer

from app.ui.statistics_work import Model
from core.io import load_mesh
from core.statistics import GeodesicParams, SpectrumParams, geodesic_sources


@pytest.fixture
def heat(monkeypatch):
    """What the other process of the heat method has come to."""
    events = {name: threading.Event() for name in ("begun", "ready", "ended")}
    run_apart = geodesic_sources.run_apart

    def watched(*work):
        events["begun"].set()
        try:
            for item in run_apart(*work):
                if item is not None:
                    events["ready"].set()
                yield item
        finally:
            events["ended"].set()

    monkeypatch.setattr(geodesic_sources, "run_apart", watched)
    return events


@pytest.fixture
def ticks(qtbot, heat):
    """Turns of the event loop while the heat method is set up."""
    turns = []
    timer = QTimer(interval=10)
    timer.timeout.connect(lambda: heat["ready"].is_set() or turns.append(heat["begun"].is_set()))
    timer.start()
    yield lambda: turns.count(True)
    timer.stop()


def test_the_window_lives_while_the_heat_method_is_set_up(user, shared_models, heat, ticks):
    work = user.window.statistics.work
    work.set_params(GeodesicParams(along="surface"), SpectrumParams())
    work.show((Model("bunny", load_mesh(shared_models / "bunny_34834.ply")),))
    user.wait(heat["ready"].is_set)
    # It takes a second or more; with the interpreter locked the loop would turn once or twice.
    assert ticks() > 15
    assert not heat["ended"].is_set()
    user.window.close()
    user.wait(heat["ended"].is_set)
    assert not user.window.isVisible()


def test_cancelling_ends_the_other_process(user, shared_models, heat):
    work = user.window.statistics.work
    work.set_params(GeodesicParams(along="surface"), SpectrumParams())
    work.show((Model("bunny", load_mesh(shared_models / "bunny_34834.ply")),))
    user.wait(heat["begun"].is_set)
    user.window.session.tasks.cancel_all()
    user.wait(heat["ended"].is_set)
    assert not heat["ready"].is_set()
