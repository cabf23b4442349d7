"""Cameras that are saved by name, copied and pasted."""

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QInputDialog, QLineEdit, QMenu

from app.scene.camera import CameraPose
from app.scene.camera_text import CameraTextError, named, pose_of, pose_text, read_pose
from app.ui.dialogs import tell


class Cameras:
    """What the camera commands do, in the tab that is shown.

    Parameters
    ----------
    window : MainWindow
        The window.
    """

    def __init__(self, window: Any) -> None:
        self._window = window

    def look_from(self, preset: str) -> None:
        """Show the whole model from a preset direction."""
        self._window.desk.stage.look_from(preset)

    def copy(self) -> None:
        """Put the camera on the clipboard as text."""
        QApplication.clipboard().setText(pose_text(self._pose()))
        self._window.session.notified.emit("The camera is on the clipboard, as JSON.")

    def paste(self) -> None:
        """Take the camera from the clipboard."""
        try:
            self._place(read_pose(QApplication.clipboard().text()))
        except CameraTextError as error:
            tell(self._window, str(error))

    def ask_for_name(self) -> None:
        """Ask for a name and keep the camera under it, with the study."""
        view = self._window.session.study.view
        dialog = self._dialog("Save the camera", "Save")
        dialog.setTextValue(f"Camera {len(view.cameras) + 1}")
        dialog.textValueSelected.connect(self._save)
        dialog.open()
        dialog.findChild(QLineEdit).selectAll()

    def ask_which_to_restore(self) -> None:
        """Ask for the name of a saved camera and go there."""
        self._ask_which("Restore a camera", "Restore", self._restore)

    def ask_which_to_forget(self) -> None:
        """Ask for the name of a saved camera and forget it."""
        self._ask_which("Forget a camera", "Forget", self._forget)

    def fill(self, menu: QMenu, first: int) -> None:
        """List the saved cameras in a menu, after its first entries."""
        for action in menu.actions()[first:]:
            menu.removeAction(action)
            action.deleteLater()
        cameras = self._window.session.study.view.cameras
        if not cameras:
            return
        menu.addSeparator()
        for camera in cameras:
            action = menu.addAction(camera.name)
            action.setStatusTip("Put the camera back to where it was saved")
            action.triggered.connect(lambda *_, camera=camera: self._place(pose_of(camera)))

    def _ask_which(self, title: str, verb: str, use: Callable[[str], None]) -> None:
        """Ask for one of the saved cameras by its name."""
        cameras = self._window.session.study.view.cameras
        dialog = self._dialog(title, verb)
        dialog.setComboBoxItems([camera.name for camera in cameras])
        dialog.textValueSelected.connect(use)
        dialog.open()

    def _dialog(self, title: str, verb: str) -> QInputDialog:
        dialog = QInputDialog(self._window)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.setWindowTitle(title)
        dialog.setLabelText("Name")
        dialog.setOkButtonText(verb)
        return dialog

    def _save(self, name: str) -> None:
        if not name.strip():
            return
        try:
            camera = named(name.strip(), self._pose())
        except CameraTextError as error:
            tell(self._window, str(error))
            return
        view = self._window.session.study.view.with_camera(camera)
        self._window.change_view("Save camera", view)
        self._window.session.notified.emit(f"“{camera.name}” stands in View → Cameras now.")

    def _restore(self, name: str) -> None:
        for camera in self._window.session.study.view.cameras:
            if camera.name == name:
                self._place(pose_of(camera))

    def _forget(self, name: str) -> None:
        view = self._window.session.study.view.without_camera(name)
        self._window.change_view("Forget camera", view)

    def _pose(self) -> CameraPose:
        return self._window.desk.stage.pose

    def _place(self, pose: CameraPose) -> None:
        self._window.desk.stage.set_pose(pose)
