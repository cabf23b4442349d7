"""The mesh doctor: what was found in the model, what it means, and repairs."""

from typing import Any

from PySide6.QtCore import QPoint, QSize, Qt
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QFrame,
    QLabel,
    QPushButton,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from app.export.doctor_reports import headline
from app.ui.controls import FaintLabel
from app.ui.doctor_checks import DoctorChecks
from app.ui.doctor_finding import FindingCard

_SIZE = QSize(460, 620)
"""The largest; where there is less to say the dialog is less high."""


class DoctorDialog(QDialog):
    """Shows the doctor's report beside the window, which stays usable.

    Parameters
    ----------
    window : MainWindow
        The window whose model is looked over.
    """

    def __init__(self, window: Any) -> None:
        super().__init__(window)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle("Mesh doctor")
        self._window, self._doctor = window, window.denoise.model.doctor
        self.name = QLabel()
        self.headline = QLabel(wordWrap=True)
        self.loading = FaintLabel()
        self.verdict = QLabel(wordWrap=True)
        self.done_title = QLabel("Repaired so far")
        self.done_title.setContentsMargins(0, 8, 0, 0)
        self.changes = QLabel(wordWrap=True)
        self.outcome = FaintLabel()
        self.checks = DoctorChecks()
        self.cards: list[FindingCard] = []
        self._list = QVBoxLayout()
        self.repair_all = QPushButton("Repair &all", autoDefault=False)
        self.repair_all.setToolTip(
            "Remove every defect. What changes the shape, as filling holes does, has its own button"
        )
        self.repair_all.clicked.connect(self._doctor.repair_all)
        self._lay_out()
        # Else the keys of undo and redo would do nothing while the dialog has the focus.
        self.addActions([window.actions_[command] for command in ("undo", "redo")])
        self._report: object = None
        self._model = ""
        self._doctor.changed.connect(self.refresh)
        self.headline.setText("Examining the model …")
        self.resize(_SIZE.boundedTo(window.size()))
        self.refresh()

    @classmethod
    def open_for(cls, window: Any) -> "DoctorDialog":
        """Show the dialog of a window; there is one at a time."""
        dialog = window.findChild(cls)
        if dialog is None:
            dialog = cls(window)
            dialog._stand_at_the_right()
        dialog._doctor.resume()
        dialog.show()
        dialog.raise_()
        dialog.activateWindow()
        return dialog

    def _stand_at_the_right(self) -> None:
        """Leave the panes in sight."""
        tabs = self._window.tabs
        place = tabs.mapToGlobal(QPoint(tabs.width() - self.width(), tabs.tabBar().height()))
        self.move(place)

    def refresh(self) -> None:
        """Show the report, and what has been done."""
        doctor = self._doctor
        meshes = self._window.session.meshes
        self.name.setText(meshes.name if meshes else "No model yet")
        loading = "; ".join(doctor.loading)
        self.loading.setText(f"Changed when loading: {loading}.")
        self.loading.setVisible(bool(loading))
        self.changes.setText("\n".join(doctor.changes))
        for widget in (self.done_title, self.changes):
            widget.setVisible(bool(doctor.changes))
        if doctor.report is not None and doctor.report is not self._report:
            self._report = doctor.report
            self._show_report()
            self._fit(self._window.session.study.model)
        self.outcome.setText("Repairing …" if doctor.is_repairing else doctor.outcome)
        busy = doctor.is_busy
        sound = doctor.report is None or doctor.report.is_sound
        self.repair_all.setDisabled(busy or sound)
        for card in self.cards:
            card.set_busy(busy)

    def _lay_out(self) -> None:
        for label in (self.name, self.done_title):
            font = label.font()
            font.setBold(True)
            label.setFont(font)
        inside = QWidget()
        column = QVBoxLayout(inside)
        column.setContentsMargins(0, 0, 8, 0)
        column.addWidget(self.verdict)
        column.addLayout(self._list)
        for widget in (self.done_title, self.changes, self.checks):
            column.addWidget(widget)
        column.addStretch()
        area = self._area = QScrollArea(frameShape=QFrame.Shape.NoFrame, widgetResizable=True)
        area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        area.setWidget(inside)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.addButton(self.repair_all, QDialogButtonBox.ButtonRole.ActionRole)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        for widget in (self.name, self.headline, self.loading):
            layout.addWidget(widget)
        layout.addWidget(area, 1)
        layout.addWidget(self.outcome)
        layout.addWidget(buttons)

    def _show_report(self) -> None:
        """Make the cards anew."""
        report = self._doctor.report
        self.headline.setText(f"{headline(report)[:1].upper()}{headline(report)[1:]}")
        worth = " Worth knowing:" if report.findings else ""
        self.verdict.setText(f"Nothing is wrong with this mesh.{worth}")
        self.verdict.setVisible(report.is_sound)
        for card in self.cards:
            self._list.removeWidget(card)
            card.deleteLater()
        self.cards = [FindingCard(finding) for finding in report.findings]
        self.checks.show_absent(report.absent)
        for card in self.cards:
            self._list.addWidget(card)
            card.repair_requested.connect(self._doctor.repair)
            card.place_requested.connect(
                lambda vertices, card=card: self._point_out(card, vertices)
            )

    def _fit(self, model: str) -> None:
        """Be no higher than there is something to say of a model that was just opened."""
        if model == self._model:
            return  # it would jump under the pointer
        self._model = model
        self.resize(_SIZE.boundedTo(self._window.size()))
        self.layout().activate()
        page = self._area.viewport()
        needed = self._area.widget().layout().totalHeightForWidth(page.width())
        self.resize(self.width(), self.height() - max(page.height() - needed, 0))

    def _point_out(self, shown: FindingCard, vertices: Any) -> None:
        """Show one place at a time."""
        for card in self.cards:
            if card is not shown and card.show_button.isChecked():
                card.show_button.blockSignals(True)
                card.show_button.setChecked(False)
                card.show_button.blockSignals(False)
        self._window.tabs.setCurrentWidget(self._window.denoise)
        self._window.denoise.show_marks(vertices)

    def done(self, result: int) -> None:
        self._doctor.changed.disconnect(self.refresh)
        self._window.denoise.show_marks(None)
        super().done(result)
