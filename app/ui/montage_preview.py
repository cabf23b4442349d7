"""The preview of a figure: the figure itself, at the resolution of the screen."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import closing
from dataclasses import replace
from functools import partial

from PySide6.QtCore import QRect, QSize, Qt, Signal
from PySide6.QtGui import QBrush, QColor, QImage, QPainter, QPaintEvent, QPalette, QResizeEvent
from PySide6.QtWidgets import QWidget

from app.export.montage import layout_of, montage_figure, montage_pictures
from app.export.montage_files import montage_pixels
from app.export.montage_plan import INCH, Ground, Montage
from app.export.montage_source import Drawn, PictureSource
from app.export.pictures import Picture, PictureError
from app.scene.panes import Look
from app.session import Session
from app.session.jobs import progress_job
from app.ui.controls import Coalesced
from app.ui.exporting import Drawer
from core.statistics import Progress

_WAIT_MS = 120
_SPACE = 16
_LEAST_DPI = 30.0


class MontagePreview(QWidget):
    """Shows a figure as large as there is room; the last one stays until the next is drawn.

    Parameters
    ----------
    source : PictureSource
        Where the pictures come from.
    session : Session
        Runs functions on the window's thread, which draws the pictures; the rest has its own.

    Signals
    -------
    told(str, bool) : the size of the figure, or why there is none, and whether there is one.
    """

    told = Signal(str, bool)

    def __init__(self, source: PictureSource, session: Session) -> None:
        super().__init__()
        self._source, self._session = source, session
        self._montage: Montage | None = None
        self._image: QImage | None = None
        self._words = ""
        self._ground: Ground = "white"
        self._pictures: dict[tuple, Drawn] = {}
        self._jobs = session.previews
        self._soon = Coalesced(self._draw, _WAIT_MS, self)
        self.setMinimumSize(360, 300)

    @property
    def image(self) -> QImage | None:
        """The preview as it was drawn last."""
        return self._image

    def show_montage(self, montage: Montage) -> None:
        """Draw a figure soon."""
        self._montage, self._words = montage, "Drawing the figure…"
        self._soon.request()

    def close_work(self) -> None:
        """Draw nothing more, and wait for nothing."""
        self._soon.stop()
        self._jobs.tasks.cancel_all()

    def paintEvent(self, _: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), self.palette().color(QPalette.ColorRole.Mid))
        if self._image is None:
            painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter, self._words)
            return
        ratio = self._image.devicePixelRatio()
        size = QSize(round(self._image.width() / ratio), round(self._image.height() / ratio))
        place = QRect(
            self.rect().center() - QRect(0, 0, size.width(), size.height()).center(), size
        )
        if self._ground == "transparent":
            painter.fillRect(place, QColor("#ffffff"))
            painter.fillRect(place, QBrush(QColor("#d8dde3"), Qt.BrushStyle.Dense4Pattern))
        painter.drawImage(place, self._image)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if self._montage:
            self._soon.request()

    def _draw(self) -> None:
        montage = self._montage
        self._jobs.tasks.cancel_all()
        try:
            fitting = replace(montage, dpi=self._fitting_dpi(montage))
            pictures = montage_pictures(fitting, self._source, self._kept_pictures)
        except PictureError as error:
            self._fail(error)
        else:
            self._compose(fitting, pictures, partial(self._show, montage))

    def _compose(
        self, montage: Montage, pictures: Iterator[Drawn], use: Callable[[Picture], None]
    ) -> None:
        """Compose a figure beside the window, which draws the pictures, one a turn of its loop."""
        drawer = Drawer(self._session.post)
        steps = _composed(montage, self._source, drawer(pictures))
        job = progress_job(steps, use, self._fail, title="Preview of the figure")
        job.on_cancel = drawer.close
        self._jobs.start(job)

    def _show(self, montage: Montage, picture: Picture) -> None:
        self._image, self._ground = _image(picture, self.devicePixelRatioF()), montage.ground
        self.update()
        layout = layout_of(montage, self._source)
        wide, high = layout.pixels(montage.dpi)
        size = f"{layout.width:.1f} × {layout.height:.1f} cm, {wide:,} × {high:,} pixels"
        self.told.emit(size, True)

    def _fail(self, error: Exception) -> None:
        if not isinstance(error, PictureError):
            self._session.report(error)
            return
        self._image, self._words = None, ""
        self.update()
        self.told.emit(str(error), False)

    def _fitting_dpi(self, montage: Montage) -> float:
        """Resolution at which the figure fills the widget."""
        layout = layout_of(montage, self._source)
        across = (self.width() - _SPACE) / layout.width
        down = (self.height() - _SPACE) / layout.height
        return max(min(across, down) * self.devicePixelRatioF() * INCH, _LEAST_DPI)

    def _kept_pictures(
        self, look: Look, chosen: Sequence[str], size: tuple[int, int], dpi: float,
        *, transparent: bool,
    ) -> Iterator[Drawn]:  # fmt: skip
        """Draw only what was not drawn in this size and on this ground before."""
        ground = (size, look.theme.ground, transparent)
        self._pictures = {key: kept for key, kept in self._pictures.items() if key[1] == ground}
        missing = [pane for pane in chosen if (pane, ground) not in self._pictures]
        with closing(
            self._source.pictures(look, missing, size, dpi, transparent=transparent)
        ) as drawn:
            for pane in chosen:
                if pane in missing:
                    self._pictures[pane, ground] = next(drawn)
                yield self._pictures[pane, ground]


def _composed(
    montage: Montage, source: PictureSource, pictures: Iterable[Drawn]
) -> Iterator[Progress[Picture]]:
    figure = montage_figure(montage, source, pictures)
    yield Progress(None, 0.5)
    yield Progress(montage_pixels(figure), 1.0)


def _image(picture: Picture, ratio: float) -> QImage:
    height, width, _ = picture.shape
    image = QImage(picture.data, width, height, 4 * width, QImage.Format.Format_RGBA8888).copy()
    image.setDevicePixelRatio(ratio)
    return image
