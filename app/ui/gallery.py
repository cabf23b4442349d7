"""The gallery: bundled models, and PyVista's to download."""

from collections.abc import Iterator
from functools import partial
from typing import TYPE_CHECKING

from PySide6.QtCore import QSettings, QSize, Qt
from PySide6.QtGui import QIcon, QPalette
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QLabel,
    QListView,
    QListWidget,
    QListWidgetItem,
    QProgressBar,
    QVBoxLayout,
)

from app.session import Job, Task
from app.ui.controls import FaintLabel
from app.ui.downloads import EXAMPLES, DownloadError, Meter, download_beside
from app.ui.icons import font_icon
from app.ui.tasks import Poster
from app.ui.thumbnails import draw_thumbnail, thumbnail
from core.io import bundled_samples, load_sample
from core.study import SAMPLE_PREFIX

if TYPE_CHECKING:
    from app.ui.main_window import MainWindow

_EXAMPLE = "example:"
_PLACES = "downloaded"
_PICTURE = QSize(112, 84)
_CELL = QSize(132, 118)


class GalleryDialog(QDialog):
    """Shows models to open; a download runs beside the window, and goes on when this closes.

    Parameters
    ----------
    window : MainWindow
        Opens what is chosen.
    """

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle("Gallery")
        self.resize(760, 620)
        self._window = window
        self._poster = Poster(window)
        self._alive = True
        self.bundled = self._list({SAMPLE_PREFIX + s.id: s.title for s in bundled_samples()})
        self.examples = self._list(
            {_EXAMPLE + id_: example.title for id_, example in EXAMPLES.items()}
        )
        self.message = FaintLabel("Models of pyvista.examples are downloaded once, then kept.")
        self.progress = QProgressBar(maximum=0, textVisible=False, visible=False)
        self.progress.setFixedHeight(8)
        policy = self.progress.sizePolicy()
        policy.setRetainSizeWhenHidden(True)  # the models above do not move
        self.progress.setSizePolicy(policy)
        self._lay_out()
        self.finished.connect(self._leave)
        items = [self.bundled.item(row) for row in range(self.bundled.count())]
        undrawn = [i for i in items if _picture(i.data(Qt.ItemDataRole.UserRole)) is None]
        if undrawn:
            self._draw({item.data(Qt.ItemDataRole.UserRole): item for item in undrawn})

    def _list(self, entries: dict[str, str]) -> QListWidget:
        shown = QListWidget(
            viewMode=QListView.ViewMode.IconMode, movement=QListView.Movement.Static
        )
        shown.setResizeMode(QListView.ResizeMode.Adjust)
        shown.setIconSize(_PICTURE)
        shown.setGridSize(_CELL)
        ink = self.palette().color(QPalette.ColorRole.Mid)
        blank = font_icon("mdi6.cube-outline", color=ink, color_disabled=ink)
        for model, title in entries.items():
            item = QListWidgetItem(_picture(model) or blank, title, shown)
            item.setData(Qt.ItemDataRole.UserRole, model)
        shown.itemActivated.connect(self._choose)
        shown.currentItemChanged.connect(lambda item, _: self._deselect_other(shown, item))
        return shown

    def _lay_out(self) -> None:
        self.buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Open | QDialogButtonBox.StandardButton.Close
        )
        self.buttons.accepted.connect(self._choose_current)
        self.buttons.rejected.connect(self.reject)
        rows = self.bundled.count() * _CELL.width() // (self.width() - 40) + 1
        self.bundled.setFixedHeight(rows * _CELL.height() + 8)
        layout = QVBoxLayout(self)
        layout.addWidget(QLabel("<b>Bundled with Burnish</b>"))
        layout.addWidget(self.bundled)
        layout.addWidget(QLabel("<b>From pyvista.examples</b>"))
        layout.addWidget(self.examples, 1)
        for widget in (self.message, self.progress, self.buttons):
            layout.addWidget(widget)

    def _deselect_other(self, shown: QListWidget, item: QListWidgetItem | None) -> None:
        other = self.examples if shown is self.bundled else self.bundled
        if item is not None:
            other.setCurrentItem(None)

    def _choose_current(self) -> None:
        item = self.bundled.currentItem() or self.examples.currentItem()
        if item is not None:
            self._choose(item)

    def _choose(self, item: QListWidgetItem) -> None:
        model = item.data(Qt.ItemDataRole.UserRole)
        if model.startswith(SAMPLE_PREFIX):
            self._open(model)
            return
        title = f"Downloading {item.text()}"
        self.message.setText(f"{title} …")
        self._set_busy(True)
        meter = Meter()
        task = Task(
            title=title, share=meter.share, on_cancel=lambda: self._cancelled(task, meter)
        )  # fmt: skip
        self._window.session.tasks.begin(task)
        done, failed = partial(self._downloaded, task, model), partial(self._failed, task)
        download_beside(self._poster, model.removeprefix(_EXAMPLE), meter, done, failed)

    def _downloaded(self, task: Task, model: str, path: str) -> None:
        """Open a model that has come, unless the dialog was left meanwhile."""
        self._window.session.tasks.end(task)
        QSettings().setValue(f"{_PLACES}/{model}", path)
        if self._alive and not task.cancelled:
            self._open(path)
        else:
            self._window.session.notified.emit(f"Downloaded to {path}.")

    def _failed(self, task: Task, error: DownloadError) -> None:
        self._window.session.tasks.end(task)
        if task.cancelled:
            return
        if self._alive:
            self._set_busy(False)
            self.message.setText(str(error))
        else:
            self._window.session.notified.emit(str(error))

    def _cancelled(self, task: Task, meter: Meter) -> None:
        """Stop the download; a server that is silent at the moment is not waited for."""
        meter.cancel()
        self._window.session.tasks.end(task)
        if self._alive:
            self._set_busy(False)
            self.message.setText("The download was cancelled.")

    def _set_busy(self, busy: bool) -> None:
        self.progress.setVisible(busy)
        self.buttons.button(QDialogButtonBox.StandardButton.Open).setDisabled(busy)
        self.examples.setDisabled(busy)

    def _open(self, model: str) -> None:
        self.accept()
        self._window.files.open(model)

    def _leave(self, _: int) -> None:
        self._alive = False

    def _draw(self, items: dict[str, QListWidgetItem]) -> None:
        """Draw bundled models that have no pictures yet, beside the window."""

        def steps() -> Iterator[str]:
            for model in items:
                draw_thumbnail(load_sample(model.removeprefix(SAMPLE_PREFIX)), [thumbnail(model)])
                yield model

        def show(model: str) -> None:
            if self._alive:
                items[model].setIcon(_picture(model) or items[model].icon())

        job = Job(steps(), show, title="Small pictures of the bundled models")
        self._window.session.jobs.start(job)


def _picture(model: str) -> QIcon | None:
    """Picture of a model; an example that was downloaded has it under its path."""
    file = thumbnail(str(QSettings().value(f"{_PLACES}/{model}", model)))
    return QIcon(str(file)) if file.exists() else None
