"""Two viewports that show the parts of one picture."""

import numpy as np
import pytest
import pyvista as pv

from app.scene.camera import CameraPose
from app.scene.parted_camera import PartedCamera, parted, window_centres

POSE = CameraPose((0.0, 0.0, 6.0), (0.0, 0.0, 0.0), (0.0, 1.0, 0.0))


def picture(share):
    """An ellipsoid in a window of 120 by 60 pixels, whole or in two parts."""
    plotter = pv.Plotter(shape=(1, 2), border=False, off_screen=True, window_size=[120, 60])
    camera = PartedCamera()
    camera.part(share)
    camera.set_pose(POSE)
    places = parted(1.0 if share is None else share)
    for renderer, place, each in zip(plotter.renderers, places, camera.shown, strict=True):
        renderer.AddActor(pv.Actor(mapper=pv.DataSetMapper(pv.ParametricEllipsoid(2, 0.8, 0.5))))
        renderer.SetViewport(place)
        renderer.SetDraw(place.right > place.left)
        renderer.SetActiveCamera(each)
        renderer.camera.is_set = True
        renderer.ResetCameraClippingRange()
    plotter.render()
    drawn = plotter.screenshot(return_img=True).astype(int)
    plotter.close()
    return drawn


@pytest.mark.parametrize("share", [0.5, 0.25, 0.8])
def test_two_parts_make_the_whole_picture(share):
    whole, parts = picture(None), picture(share)
    assert whole.std() > 10
    assert (np.abs(whole - parts).max(axis=2) > 12).mean() < 0.01


def test_the_camera_that_was_moved_leads():
    camera = PartedCamera()
    camera.part(0.3)
    camera.set_pose(POSE)
    camera.shown[1].Azimuth(30)
    moved = CameraPose.of(camera.shown[1])
    assert camera.pose == moved
    camera.shown[0].Dolly(2)
    nearer = camera.pose
    assert nearer != moved
    assert CameraPose.of(camera.shown[1]) == nearer


def test_parting_and_joining_keep_the_pose():
    camera = PartedCamera()
    camera.set_pose(POSE)
    camera.part(0.4)
    camera.shown[1].Elevation(20)
    pose = camera.pose
    camera.part(None)
    assert camera.shown[0] is camera.shown[1]
    assert camera.pose == pose
    assert camera.shown[0].GetWindowCenter() == (0.0, 0.0)


def test_the_middles_are_mirrored():
    assert window_centres(0.5) == (-1.0, 1.0)
    left, right = window_centres(0.2)
    assert (left, right) == pytest.approx((-4.0, 0.25))
