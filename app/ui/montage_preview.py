"""The preview of a figure: the figure itself, at the resolution of the screen."""

from collections.abc import Sequence
from dataclasses import replace

from PySide6.QtCore import QRect, QSize, Qt, Signal
from PySide6.QtGui import QBrush, QColor, QImage, QPainter, QPaintEvent, QPalette, QResizeEvent
from PySide6.QtWidgets import QWidget

from app.export.montage import (
    PictureSource,
    finished,
    montage_figure,
    montage_pictures,
    montage_pixels,
)
from app.export.montage_plan import INCH, Montage, montage_layout
from app.export.pictures import Picture, PictureError
from app.scene.panes import Look
from app.ui.controls import Coalesced

_WAIT_MS = 120
_SPACE = 16
_LEAST_DPI = 30.0


class MontagePreview(QWidget):
    """Draws a figure as large as there is room.

    Parameters
    ----------
    source : PictureSource
        Where the pictures come from.

    Signals
    -------
    told(str, bool) : the size of the figure, or why there is none, and whether there is one.
    """

    told = Signal(str, bool)

    def __init__(self, source: PictureSource) -> None:
        super().__init__()
        self._source = source
        self._montage: Montage | None = None
        self._image: QImage | None = None
        self._pictures: dict[tuple, Picture] = {}
        self._soon = Coalesced(self._draw, _WAIT_MS, self)
        self.setMinimumSize(360, 300)

    @property
    def image(self) -> QImage | None:
        """The preview as it was drawn last."""
        return self._image

    def show_montage(self, montage: Montage) -> None:
        """Draw a figure soon."""
        self._montage = montage
        self._soon.request()

    def paintEvent(self, _: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), self.palette().color(QPalette.ColorRole.Mid))
        if self._image is None:
            return
        ratio = self._image.devicePixelRatio()
        size = QSize(round(self._image.width() / ratio), round(self._image.height() / ratio))
        place = QRect(
            self.rect().center() - QRect(0, 0, size.width(), size.height()).center(), size
        )
        if self._montage and self._montage.ground == "transparent":
            painter.fillRect(place, QColor("#ffffff"))
            painter.fillRect(place, QBrush(QColor("#d8dde3"), Qt.BrushStyle.Dense4Pattern))
        painter.drawImage(place, self._image)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if self._montage:
            self._soon.request()

    def _draw(self) -> None:
        montage = self._montage
        try:
            fitting = replace(montage, dpi=self._fitting_dpi(montage))
            pictures = montage_pictures(fitting, self._source, self._kept_pictures)
            figure = montage_figure(fitting, self._source, pictures)
        except PictureError as error:
            self._image = None
            self.told.emit(str(error), False)
        else:
            self._image = _image(montage_pixels(figure), self.devicePixelRatioF())
            self._tell_size(montage, figure.get_size_inches())
        self.update()

    def _fitting_dpi(self, montage: Montage) -> float:
        """Resolution at which the figure fills the widget."""
        with_bar = montage.bar and bool(self._source.look.colour_title)
        layout = montage_layout(montage, with_bar=with_bar)
        across = (self.width() - _SPACE) / layout.width
        down = (self.height() - _SPACE) / layout.height
        return max(min(across, down) * self.devicePixelRatioF() * INCH, _LEAST_DPI)

    def _kept_pictures(
        self, look: Look, chosen: Sequence[str], size: tuple[int, int], dpi: float,
        *, transparent: bool,
    ) -> list[Picture]:  # fmt: skip
        """Draw only what was not drawn in this size and on this ground before."""
        ground = (size, look.theme.ground, transparent)
        missing = [pane for pane in chosen if (pane, ground) not in self._pictures]
        if missing:
            drawn = self._source.pictures(look, missing, size, dpi, transparent=transparent)
            self._pictures = {key: p for key, p in self._pictures.items() if key[1] == ground}
            self._pictures |= {
                (pane, ground): finished(p) for pane, p in zip(missing, drawn, strict=True)
            }
        return [self._pictures[pane, ground] for pane in chosen]

    def _tell_size(self, montage: Montage, inches: tuple[float, float]) -> None:
        wide, high = inches
        self.told.emit(
            f"{wide * INCH:.1f} × {high * INCH:.1f} cm, "
            f"{round(wide * montage.dpi):,} × {round(high * montage.dpi):,} pixels",
            True,
        )


def _image(picture: Picture, ratio: float) -> QImage:
    height, width, _ = picture.shape
    image = QImage(picture.data, width, height, 4 * width, QImage.Format.Format_RGBA8888).copy()
    image.setDevicePixelRatio(ratio)
    return image
