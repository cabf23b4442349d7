"""The status bar: what runs, how far it is, and a button that stops it."""

from PySide6.QtGui import QAction
from PySide6.QtWidgets import QLabel, QProgressBar, QStatusBar, QToolButton

from app.session import Session
from app.ui.controls import Coalesced

_MESSAGE_MS = 12_000
_UPDATE_MS = 120


class StatusBar(QStatusBar):
    """Shows the session's activity.

    Parameters
    ----------
    session : Session
        What to listen to.
    cancel : QAction
        The command that stops the work.
    """

    def __init__(self, session: Session, cancel: QAction) -> None:
        super().__init__()
        self._session = session
        self._place = QLabel()
        self.addWidget(self._place, 1)
        self._text = QLabel()
        self._bar = QProgressBar(maximum=100, textVisible=False)
        self._bar.setFixedSize(140, 12)
        self._button = QToolButton(autoRaise=True)
        self._button.setDefaultAction(cancel)
        for widget in (self._text, self._bar, self._button):
            self.addPermanentWidget(widget)
        # A progress bar repaints the whole window at once, so it may not follow every iteration.
        self._update_soon = Coalesced(self._update, _UPDATE_MS, self)
        session.activity_changed.connect(self._update_soon.request)
        session.notified.connect(lambda text: self.showMessage(text, _MESSAGE_MS))
        self._update()

    def show_place(self, text: str) -> None:
        """Tell what is under the cursor."""
        self._place.setText(text)

    def _update(self) -> None:
        activity = self._session.activity
        for widget in (self._text, self._bar, self._button):
            widget.setVisible(activity is not None)
        if activity is None:
            return
        self._text.setText(f"{activity.text} …")
        self._bar.setMaximum(0 if activity.share is None else 100)
        self._bar.setValue(round(100 * (activity.share or 0)))
