"""The settings of one view: its surface, its field, its levels and bands."""

from typing import Any

from PySide6.QtCore import QSignalBlocker
from PySide6.QtWidgets import QCheckBox, QComboBox, QFormLayout, QHBoxLayout, QVBoxLayout, QWidget

from app.session import Session
from app.ui.controls import FaintLabel, WheelGuard
from app.ui.help import HelpButton
from app.ui.parameter_form import ParameterForm
from app.ui.skeleton_changes import change_view, current_view
from app.ui.skeleton_share import ShareControl
from core.fields import FIELDS
from core.parameters import describe
from core.smoothing import METHODS
from core.study import SkeletonView

_SPACINGS = {
    "value": "equal steps of the field",
    "distance": "equal steps of the distance",
    "area": "bands of equal area",
}
_BANDS = {"exact": "exact: faces are cut", "vertices": "vertices, as printed"}
_NAMES = {
    "source": "Surface", "keep": "Faces", "field": "Field", "spacing": "Levels", "bands": "Bands",
    "root": "Root",
}  # fmt: skip
"""What a person reads before a control, and in the Edit menu once it was changed."""

_HELP = {parameter.name: parameter.help for parameter in describe(SkeletonView)}


class ViewPanel(QWidget):
    """Controls of one view.

    Parameters
    ----------
    session : Session
        The state; the panel listens and pushes studies.
    index : int
        The view.
    """

    def __init__(self, session: Session, index: int) -> None:
        super().__init__()
        self._session, self._index = session, index
        self.source = _combo({"original": "Original", "noisy": "Noisy input"})
        self.keep = ShareControl()
        self.field = _combo({id_: spec.title for id_, spec in FIELDS.items()})
        self.formula = FaintLabel()
        self.forms = {id_: ParameterForm(spec.params) for id_, spec in FIELDS.items()}
        self.spacing = _combo(_SPACINGS)
        self.bands = _combo(_BANDS)
        self.root = QCheckBox("Join the centroid (root)")
        self._guard = WheelGuard(self)
        self._guard.guard(self.source, self.field, self.spacing, self.bands)
        self._lay_out()
        self._connect()
        self._refresh()

    def _lay_out(self) -> None:
        top, below = _form(), _form()
        top.addRow(_NAMES["source"], self.source)
        top.addRow(_NAMES["keep"], self.keep)
        field = QHBoxLayout()
        field.addWidget(self.field, 1)
        field.addWidget(HelpButton(self.field.currentData, "Reference of this field"))
        top.addRow(_NAMES["field"], field)
        below.addRow(_NAMES["spacing"], self.spacing)
        below.addRow(_NAMES["bands"], self.bands)
        below.addRow("", self.root)
        _align(top, below)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 6, 0, 0)
        layout.addLayout(top)
        layout.addWidget(self.formula)
        for form in self.forms.values():
            layout.addWidget(form)
        layout.addLayout(below)
        for name, shown in _NAMES.items():
            getattr(self, name).setToolTip(_HELP[name])
            getattr(self, name).setAccessibleName(shown)

    def _connect(self) -> None:
        for name in ("source", "field", "spacing", "bands"):
            box: QComboBox = getattr(self, name)
            box.activated.connect(lambda _, name=name, box=box: self._on_choice(name, box))
        self.keep.changed.connect(lambda share: self._change("Decimation", keep=share))
        self.root.toggled.connect(lambda on: self._change("Root", root=on))
        for form in self.forms.values():
            form.changed.connect(lambda values: self._change("Field parameters", params=values))
        self._session.study_changed.connect(self._refresh)

    def _on_choice(self, name: str, box: QComboBox) -> None:
        update: dict[str, Any] = {name: box.currentData()}
        if name == "field":
            update["params"] = {}
        self._change(_NAMES[name], **update)

    def _change(self, step: str, **update: Any) -> None:
        view = current_view(self._session, self._index)
        if any(getattr(view, name) != value for name, value in update.items()):
            change_view(self._session, self._index, step, **update)

    def _refresh(self, *_: object) -> None:
        view = current_view(self._session, self._index)
        self._list_sources()
        for name in ("source", "field", "spacing", "bands"):
            box: QComboBox = getattr(self, name)
            box.setCurrentIndex(box.findData(getattr(view, name)))
        self.keep.set_share(view.keep)
        with QSignalBlocker(self.root):
            self.root.setChecked(view.root)
        spec = FIELDS[view.field]
        self.formula.setText(spec.formula)
        self.formula.setToolTip(f"{spec.summary}\n{spec.departure}\n{spec.reference}")
        for id_, form in self.forms.items():
            form.setVisible(id_ == view.field and bool(form.fields))
        self.forms[view.field].set_values(view.params)

    def _list_sources(self) -> None:
        """Offer the surface of every method that runs, and of the one that is chosen."""
        chosen = current_view(self._session, self._index).source
        methods = [
            choice.method
            for choice in self._session.study.methods
            if choice.enabled or choice.method == chosen
        ]
        wanted = ["original", "noisy", *methods]
        if wanted == [self.source.itemData(i) for i in range(self.source.count())]:
            return
        while self.source.count() > 2:
            self.source.removeItem(2)
        for method in methods:
            self.source.addItem(METHODS[method].title, method)


def _combo(names: dict[str, str]) -> QComboBox:
    box = QComboBox()
    for key, name in names.items():
        box.addItem(name, key)
    box.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
    box.setMinimumContentsLength(8)
    return box


def _form() -> QFormLayout:
    form = QFormLayout()
    form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
    form.setVerticalSpacing(4)
    return form


def _align(*forms: QFormLayout) -> None:
    """Let the fields of several forms begin at the same place."""
    role = QFormLayout.ItemRole.LabelRole
    items = [form.itemAt(row, role) for form in forms for row in range(form.rowCount())]
    labels = [item.widget() for item in items if item]
    width = max(label.sizeHint().width() for label in labels)
    for label in labels:
        label.setMinimumWidth(width)
