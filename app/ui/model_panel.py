"""The model panel: what was opened, and the noise that is added to it."""

from collections.abc import Iterator

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QFrame, QGridLayout, QLabel, QScrollArea, QVBoxLayout, QWidget

from app.session import Job, Session
from app.session.doctor import Doctor
from app.ui.controls import FaintLabel
from app.ui.doctor_sign import DoctorSign
from app.ui.mesh_facts import MeshFacts, mesh_facts
from app.ui.noise_controls import NoiseControls
from core.mesh import TriangleMesh

_FACTS = {
    "vertices": "Vertices",
    "edges": "Edges",
    "faces": "Faces",
    "components": "Components",
    "genus": "Genus",
    "boundary": "Boundary",
    "mean_edge_length": "Mean edge ℓ̄",
}


class ModelPanel(QWidget):
    """Name and counts of the model, and its noise.

    `noisy_file_requested` asks for a file that holds the noisy version of the model,
    `doctor_requested` for the mesh doctor.

    Parameters
    ----------
    session : Session
        The state; the panel listens and pushes studies.
    """

    noisy_file_requested = Signal()
    doctor_requested = Signal()

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        self._measured: TriangleMesh | None = None
        self.name = QLabel()
        self.report = FaintLabel()
        self.facts = {name: QLabel() for name in _FACTS}
        self.doctor = Doctor(session)
        self.sign = DoctorSign(self.doctor)
        self.sign.clicked.connect(self.doctor_requested)
        self.noise = NoiseControls(session)
        self.noise.file_requested.connect(self.noisy_file_requested)
        self._lay_out()
        session.meshes_changed.connect(self._refresh)
        self._refresh()

    def _lay_out(self) -> None:
        self.name.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.name.setWordWrap(True)
        font = self.name.font()
        font.setBold(True)
        self.name.setFont(font)
        inside = QWidget()
        column = QVBoxLayout(inside)
        column.setContentsMargins(10, 8, 10, 8)
        column.setSpacing(6)
        column.addWidget(self.name)
        column.addLayout(self._fact_grid())
        column.addWidget(self.sign)
        column.addWidget(self.report)
        column.addSpacing(8)
        column.addWidget(self.noise)
        column.addStretch()
        area = QScrollArea(frameShape=QFrame.Shape.NoFrame, widgetResizable=True)
        area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        area.setWidget(inside)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(area)
        self.setMinimumWidth(220)

    def _fact_grid(self) -> QGridLayout:
        grid = QGridLayout()
        grid.setVerticalSpacing(3)
        grid.setColumnStretch(1, 1)
        for row, (name, title) in enumerate(_FACTS.items()):
            value = self.facts[name]
            value.setAlignment(Qt.AlignmentFlag.AlignRight)
            value.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
            grid.addWidget(QLabel(title), row, 0)
            grid.addWidget(value, row, 1)
        self.facts["mean_edge_length"].setToolTip("Mean edge length, in the units of the file.")
        return grid

    def _refresh(self) -> None:
        meshes = self._session.meshes
        self.name.setText(meshes.name if meshes else "No model yet")
        self.name.setToolTip(self._session.study.model if meshes else "")
        report = "; ".join(meshes.report) if meshes else ""
        self.report.setText(f"Changed when loading: {report}." if report else "")
        self.report.setVisible(bool(report))
        mesh = meshes.comparison.original if meshes else None
        if mesh is not None and mesh is not self._measured:
            self._measured = mesh
            self._measure(mesh)

    def _measure(self, mesh: TriangleMesh) -> None:
        """Gather the facts beside the window: on a large model they take a while."""
        for label in self.facts.values():
            label.setText("…")

        def steps() -> Iterator[MeshFacts]:
            yield mesh_facts(mesh)

        def show(facts: MeshFacts) -> None:
            if mesh is self._measured:
                self._show(facts)

        self._session.jobs.start(Job(steps(), show, title="Measuring the model"), urgent=True)

    def _show(self, facts: MeshFacts) -> None:
        boundary = f"{facts.boundary_edges:,} edges" if facts.boundary_edges else "none (closed)"
        texts = {
            "vertices": f"{facts.vertices:,}",
            "edges": f"{facts.edges:,}",
            "faces": f"{facts.faces:,}",
            "components": f"{facts.components:,}",
            "genus": "–" if facts.genus is None else f"{facts.genus:,}",
            "boundary": boundary,
            "mean_edge_length": f"{facts.mean_edge_length:.4g}",
        }
        for name, text in texts.items():
            self.facts[name].setText(text)
        self.facts["genus"].setToolTip(facts.genus_reason)
