"""Which panes are compared, and how one is cut against the other."""

import numpy as np
import pytest
import pyvista as pv

from app.export.pictures import prefer_headless_graphics
from app.scene.camera import preset_pose
from app.scene.colouring import colour_map, colour_range, shares_between
from app.scene.comparing import pair, swapped
from app.scene.grid import GRID_SHAPE, PaneGrid
from app.scene.panes import Look, Pane
from app.scene.swipe import Swipe, cutting_normal
from core.mesh import primitives
from core.view import NamedCamera, ViewSettings

IDS = ["original", "noisy", "mean"]
BALL = primitives.sphere(3)
POINTS = BALL.vertices.astype(np.float32)


@pytest.mark.parametrize(
    ("ids", "selected", "other", "expected"),
    [
        (IDS, "noisy", "original", ("noisy", "original")),
        (IDS, "mean", "noisy", ("mean", "noisy")),
        (IDS, None, "original", ("mean", "original")),
        (IDS, "gone", "gone too", ("mean", "noisy")),
        (IDS, "original", "original", ("original", "noisy")),
        (IDS[:1], "original", "original", None),
        ([], None, "original", None),
    ],
)
def test_two_different_panes_are_compared(ids, selected, other, expected):
    assert pair(ids, selected, other) == expected


def test_a_swapped_pane_shows_the_other_under_its_own_id():
    panes = [Pane(id_, id_.title(), "", "#000000", POINTS + i) for i, id_ in enumerate(IDS)]
    shown = swapped(panes, "mean", "original")
    assert [pane.id for pane in shown] == IDS
    assert shown[2].title == "Original"
    assert shown[2].points is panes[0].points


@pytest.mark.parametrize("share", [0.0, 0.3, 0.5, 1.0])
@pytest.mark.parametrize("aspect", [0.5, 2.0])
def test_the_cutting_plane_is_seen_as_the_vertical_line(share, aspect):
    camera = pv.Camera()
    preset_pose("Oblique", np.eye(3), 1.0).apply(camera)
    camera.SetClippingRange(0.1, 10)
    normal = cutting_normal(camera, share, aspect)
    eye = np.array(camera.GetPosition())
    matrix = camera.GetCompositeProjectionTransformMatrix(aspect, -1, 1)
    rows = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    points = np.random.default_rng(0).uniform(-0.5, 0.5, (200, 3))
    clip = np.c_[points, np.ones(200)] @ rows.T
    seen_right = clip[:, 0] / clip[:, 3] > 2 * share - 1
    assert np.array_equal((points - eye) @ normal > 0, seen_right)


def test_each_side_of_the_line_shows_its_own_mesh():
    size = (400, 400)
    small = Pane("noisy", "", "", "#000000", POINTS, np.zeros(len(POINTS)))
    other = Pane("mean", "", "", "#000000", POINTS, np.ones(len(POINTS)))
    look = Look(BALL.topology, colour_title="Error", bar=False, framed=False)
    prefer_headless_graphics()
    plotter = pv.Plotter(shape=GRID_SHAPE, border=False, off_screen=True, window_size=list(size))
    grid = PaneGrid(plotter)
    grid.show([small, other], look, size)
    grid.swipe = Swipe("noisy", "mean", 0.5)
    grid.show([small, other], look, size)
    grid.look_from("Front (+Z)")
    plotter.render()
    picture = plotter.screenshot(return_img=True).astype(int)
    assert picture[200, 150, 2] > picture[200, 150, 1]  # violet, the lower end
    assert picture[200, 250, 1] > picture[200, 250, 2]  # yellow, the upper end
    assert grid.mesh_at(0.4, 0.5) == "noisy"
    assert grid.mesh_at(0.6, 0.5) == "mean"

    grid.swipe = None
    grid.show([small, other], look, size)
    plotter.render()
    whole = plotter.screenshot(return_img=True).astype(int)
    assert whole[200, 120, 2] > whole[200, 120, 1]
    assert whole[200, 320, 1] > whole[200, 320, 2]
    plotter.close()


def coloured(id_, values):
    return Pane(id_, "", "", "#000000", POINTS[: len(values)], np.asarray(values, float))


def test_the_range_of_the_bar_follows_the_settings():
    panes = [coloured("mean", np.linspace(1, 2, 101)), coloured("median", np.linspace(3, 9, 101))]
    percentile = (1.98 + 8.88) / 2
    assert colour_range(ViewSettings(), panes) == pytest.approx((0, percentile))
    assert colour_range(ViewSettings(colour_range="full"), panes) == (1, 9)
    by_hand = ViewSettings(colour_range="manual", colour_low=-1, colour_high=5)
    assert colour_range(by_hand, panes) == (-1, 5)
    crossed = ViewSettings(colour_range="manual", colour_low=5, colour_high=5)
    low, high = colour_range(crossed, panes)
    assert low == 5 < high


def test_a_reversed_map_runs_the_other_way():
    assert colour_map(ViewSettings(colour_map="cividis")) == "cividis"
    assert colour_map(ViewSettings(colour_map="cividis", colour_reversed=True)) == "cividis_r"


def test_the_histogram_is_the_selected_pane_or_all():
    low, high = coloured("mean", np.zeros(10)), coloured("median", np.full(30, 0.999))
    plain = Pane("original", "", "", "#000000", POINTS)
    one = shares_between([plain, low, high], "mean", (0, 1))
    assert (one[0], one[-1]) == (1, 0)
    both = shares_between([plain, low, high], "original", (0, 1))
    assert (both[0], both[-1]) == (pytest.approx(1 / 3), 1)
    assert not shares_between([plain], None, (0, 1)).any()


def test_another_metric_lets_go_of_ends_set_by_hand():
    view = ViewSettings(colour="normal_angle", colour_range="manual", colour_high=30)
    assert view.coloured_by("vertex_rms").colour_range == "percentile"
    assert view.coloured_by("normal_angle").colour_range == "manual"


def test_a_camera_of_the_same_name_replaces_the_old_one():
    first = NamedCamera(name="a", position=(0, 0, 1), focal_point=(0, 0, 0), view_up=(0, 1, 0))
    second = first.model_copy(update={"position": (0, 0, 2)})
    view = ViewSettings().with_camera(first).with_camera(second)
    assert view.cameras == (second,)
    assert view.without_camera("a").cameras == ()
