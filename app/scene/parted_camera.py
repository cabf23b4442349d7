"""One camera for two viewports side by side, or for two parts of one picture."""

import pyvista as pv

from app.scene.camera import CameraPose
from app.scene.layout import Viewport


def window_centres(share: float) -> tuple[float, float]:
    """Middles of two cameras that draw the parts of one picture left and right of a line.

    A picture whose middle is at 0 reaches from −1 to 1. The left part is `share` wide, so its
    middle lies at −(1 − share) in the whole, and at −(1 − share)/share in half-widths of its own.

    Examples
    --------
    >>> window_centres(0.5)
    (-1.0, 1.0)
    """
    return -(1 - share) / share, share / (1 - share)


def parted(share: float, right: float = 1.0) -> list[Viewport]:
    """Viewports left and right of a line at a share of the width up to `right`."""
    line = right * share
    return [Viewport(0.0, 0.0, line, 1.0), Viewport(line, 0.0, right, 1.0)]


class PartedCamera:
    """The camera of two viewports.

    As long as the picture is whole, both look through the same one. Parted by a line, each draws
    its part through a camera of its own; :meth:`follow` keeps them together.
    """

    def __init__(self) -> None:
        self._cameras = pv.Camera(), pv.Camera()
        self._poses = [CameraPose.of(camera) for camera in self._cameras]
        self.share: float | None = None

    @property
    def shown(self) -> tuple[pv.Camera, pv.Camera]:
        """Cameras of the left and of the right viewport."""
        first = self._cameras[0]
        return (first, first) if self.share is None else self._cameras

    @property
    def pose(self) -> CameraPose:
        """Where the camera stands."""
        self.follow()
        return CameraPose.of(self._cameras[0])

    def set_pose(self, pose: CameraPose) -> None:
        """Put the camera into a pose."""
        for camera in self._cameras:
            pose.apply(camera)
        self._poses = [CameraPose.of(camera) for camera in self._cameras]

    def part(self, share: float | None) -> None:
        """Part the picture at a share of its width, or make it whole again."""
        self.set_pose(self.pose)
        self.share = share
        centres = (0.0, 0.0) if share is None else window_centres(share)
        for camera, centre in zip(self._cameras, centres, strict=True):
            camera.SetWindowCenter(centre, 0.0)

    def follow(self) -> None:
        """Let the camera that was moved lead the other one."""
        now = [CameraPose.of(camera) for camera in self._cameras]
        pairs = zip(now, self._poses, strict=True)
        moved = [pose for pose, before in pairs if pose != before]
        if moved and self.share is not None:
            self.set_pose(moved[0])
        elif now[0] != now[1]:
            self.set_pose(now[0])
