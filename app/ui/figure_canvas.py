"""A matplotlib canvas in a window where no error is lost: matplotlib prints them and goes on."""

import sys
from collections.abc import Iterator
from contextlib import contextmanager

from matplotlib.backends.backend_qtagg import FigureCanvasQTAgg
from matplotlib.figure import Figure
from PySide6.QtCore import Qt
from PySide6.QtGui import QPainter, QPaintEvent, QPalette

NOT_DRAWN = "This plot could not be drawn.\nThe numbers are as they were."


class FigureCanvas(FigureCanvasQTAgg):
    """Shows a figure, or says that it could not be drawn; every error comes to `sys.excepthook`.

    Parameters
    ----------
    figure : Figure
        What is shown.
    """

    def __init__(self, figure: Figure) -> None:
        self._is_made = self._is_drawn = True
        super().__init__(figure)
        self.setPalette(QPalette())  # matplotlib's is white in every theme
        self.callbacks.exception_handler = _tell

    @property
    def words(self) -> str:
        """What is to be read in place of the figure, empty where that is shown."""
        return "" if self._is_made and self._is_drawn else NOT_DRAWN

    @contextmanager
    def making(self) -> Iterator[None]:
        """Enclose what changes the figure: where that fails, a half of it is not shown."""
        self._is_made = False
        self.update()
        with _telling():
            yield
            self._is_made = True

    def draw(self) -> None:
        """Draw the figure, if it is whole."""
        if self._is_made:
            self._is_drawn = False
            # What listens to the drawing takes part in it.
            self.callbacks.exception_handler = _raise
            with _telling():
                super().draw()
                self._is_drawn = True
            self.callbacks.exception_handler = _tell

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self.words:
            self._paint_words()

    def _paint_words(self) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), self.palette().color(QPalette.ColorRole.Window))
        painter.setPen(self.palette().color(QPalette.ColorRole.WindowText))
        wrapped = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
        painter.drawText(self.rect(), wrapped, self.words)
        painter.end()


@contextmanager
def _telling() -> Iterator[None]:
    """Give an error to whoever tells of unexpected ones, and go on."""
    try:
        yield
    except Exception as error:  # noqa: BLE001 - whoever tells of errors is to hear of it
        _tell(error)


def _tell(error: Exception) -> None:
    sys.excepthook(type(error), error, error.__traceback__)


def _raise(error: Exception) -> None:
    raise error
