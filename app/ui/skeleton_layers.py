"""What is drawn in both views, and how."""

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import QCheckBox, QComboBox, QFormLayout, QGridLayout, QLabel, QWidget

from app.scene.skeleton_colours import KIND_COLOURS
from app.session import Session
from app.ui.controls import JumpSlider, WheelGuard
from app.ui.skeleton_changes import change_settings
from core.parameters import Parameter, describe
from core.study import SkeletonSettings

_LAYERS = {
    "show_bands": "Bands",
    "show_curves": "Level curves",
    "show_graph": "Graph",
    "show_shells": "Spheres",
}
_COLOURS = {"band": "by band", "kind": "by kind"}
_DECLARED = {parameter.name: parameter for parameter in describe(SkeletonSettings)}


class LayersPanel(QWidget):
    """Layers, opacity, node size and node colours."""

    def __init__(self, session: Session) -> None:
        super().__init__()
        self._session = session
        self.layers = {name: QCheckBox(title) for name, title in _LAYERS.items()}
        self.opacity = _slider(_DECLARED["opacity"])
        self.node_size = _slider(_DECLARED["node_size"])
        self.node_colour = QComboBox()
        for key, name in _COLOURS.items():
            self.node_colour.addItem(name, key)
        self.legend = QLabel(_legend_text(), textFormat=Qt.TextFormat.RichText)
        self._guard = WheelGuard(self)
        self._guard.guard(self.opacity, self.node_size, self.node_colour)
        self._lay_out()
        self._connect()
        self._refresh()

    def _lay_out(self) -> None:
        form = QFormLayout(self)
        form.setContentsMargins(0, 0, 0, 0)
        form.setVerticalSpacing(4)
        boxes = QGridLayout()
        for place, (name, box) in enumerate(self.layers.items()):
            box.setToolTip(_DECLARED[name].help)
            boxes.addWidget(box, place // 2, place % 2)
        form.addRow(boxes)
        form.addRow("Surface", self.opacity)
        form.addRow("Node size", self.node_size)
        form.addRow("Nodes", self.node_colour)
        form.addRow(self.legend)
        for name in ("opacity", "node_size", "node_colour"):
            getattr(self, name).setToolTip(_DECLARED[name].help)
            getattr(self, name).setAccessibleName(_DECLARED[name].label.capitalize())

    def _connect(self) -> None:
        for name, box in self.layers.items():
            box.toggled.connect(lambda on, name=name: self._change(name, on))
        for name in ("opacity", "node_size"):
            step = _DECLARED[name].step
            getattr(self, name).valueChanged.connect(
                lambda value, name=name, step=step: self._change(name, round(value * step, 3))
            )
        self.node_colour.activated.connect(
            lambda _: self._change("node_colour", self.node_colour.currentData())
        )
        self._session.study_changed.connect(self._refresh)

    def _change(self, name: str, value: object) -> None:
        change_settings(self._session, _DECLARED[name].label.capitalize(), **{name: value})

    def _refresh(self, *_: object) -> None:
        settings = self._session.study.skeleton
        for name, box in self.layers.items():
            with QSignalBlocker(box):
                box.setChecked(getattr(settings, name))
        for name in ("opacity", "node_size"):
            slider: JumpSlider = getattr(self, name)
            with QSignalBlocker(slider):
                slider.setValue(round(getattr(settings, name) / _DECLARED[name].step))
        self.node_colour.setCurrentIndex(self.node_colour.findData(settings.node_colour))
        self.legend.setVisible(settings.node_colour == "kind")


def _slider(declared: Parameter) -> JumpSlider:
    slider = JumpSlider()
    slider.setRange(round(declared.low / declared.step), round(declared.high / declared.step))
    return slider


def _legend_text() -> str:
    dots = (f'<span style="color:{c}">●</span> {kind}' for kind, c in KIND_COLOURS.items())
    return "&nbsp;&nbsp; ".join(dots)
