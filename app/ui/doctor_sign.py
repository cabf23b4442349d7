"""A quiet line in the model panel that says whether the doctor found something."""

from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QSizePolicy, QToolButton

from app.session.doctor import Doctor
from app.ui.icons import font_icon

DEFECT_ICON, SOUND_ICON, NOTE_ICON = "mdi6.alert", "mdi6.check-circle", "mdi6.information-outline"
DEFECT_COLOUR, SOUND_COLOUR = "#d97706", "#2e9d63"
_ICON_SIZE = QSize(16, 16)


class DoctorSign(QToolButton):
    """Flat button: the number of defects in words; a click opens the doctor.

    Parameters
    ----------
    doctor : Doctor
        What to listen to.
    """

    def __init__(self, doctor: Doctor) -> None:
        super().__init__(autoRaise=True)
        self._doctor = doctor
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.setIconSize(_ICON_SIZE)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        doctor.changed.connect(self.refresh)
        self.refresh()

    def refresh(self) -> None:
        """Show the report."""
        report = self._doctor.report
        self.setVisible(self._doctor.patient is not None)
        if self._doctor.is_cancelled:
            self._show(
                "Not examined …", NOTE_ICON, self._ink(), "It was cancelled; click to do it."
            )
        elif report is None:
            self._show("Examining …", NOTE_ICON, self._ink(), "The model is being looked over.")
        elif report.is_sound:
            notes = "\n".join(finding.found.text for finding in report.findings)
            self._show(_sound_text(len(report.findings)), SOUND_ICON, SOUND_COLOUR, notes)
        else:
            first, *others = report.defects
            text = f"{len(others) + 1} kinds of defects" if others else first.spec.title
            found = "\n".join(finding.found.text for finding in report.defects)
            self._show(f"{text} …", DEFECT_ICON, DEFECT_COLOUR, found)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self.refresh()

    def _show(self, text: str, icon: str, colour: str, tip: str) -> None:
        self.setText(text)
        self.setIcon(font_icon(icon, color=colour))
        self.setToolTip(tip)
        self.setAccessibleName(f"Mesh doctor: {text}")

    def _ink(self) -> str:
        return self.palette().color(QPalette.ColorRole.PlaceholderText).name()


def _sound_text(notes: int) -> str:
    if not notes:
        return "No defects"
    return f"No defects, {notes} {'note' if notes == 1 else 'notes'} …"
