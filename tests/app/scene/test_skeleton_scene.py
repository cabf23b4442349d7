"""Values and actors of the Skeleton tab: layout, colours, text, shells, camera, picking."""

import numpy as np
import pytest
import pyvista as pv

from app.export.pictures import prefer_headless_graphics
from app.scene.colours import DARK, LIGHT
from app.scene.skeleton_camera import fitting_pose
from app.scene.skeleton_colours import KIND_COLOURS, band_colours, band_table, node_colours
from app.scene.skeleton_grid import SHAPE, SkeletonGrid
from app.scene.skeleton_layout import flat_places
from app.scene.skeleton_panes import SkeletonLook, build_pane, counts_text, view_title
from app.scene.skeleton_shells import shell_levels, shell_surfaces
from app.session.skeleton_maker import SkeletonMaker, SkeletonSource
from core.fields.affine import squared_affine_norms
from core.mesh import TriangleMesh, primitives
from core.skeleton import skeletal_graph
from core.study import SkeletonSettings, SkeletonView

SIZE = (600, 300)


def draw(mesh, **settings):
    source = SkeletonSource("mesh", lambda: mesh)
    return SkeletonMaker().make(source, SkeletonView(**settings))


@pytest.fixture(scope="module")
def torus():
    return draw(primitives.torus(40, 20), resolution=12)


def test_a_path_lies_in_one_row():
    graph = skeletal_graph(primitives.sphere(3), "height", 6)
    assert np.array_equal(flat_places(graph), [[band, 0] for band in range(6)])


def test_branches_lie_in_rows_of_their_own():
    graph = skeletal_graph(primitives.torus(), "height", 8, x=1, z=0)
    places = flat_places(graph)
    assert len(np.unique(places, axis=0)) == len(graph.nodes)
    assert np.array_equal(places[:, 0], graph.band)


def test_components_do_not_overlap_and_the_root_comes_first():
    ball = primitives.sphere(2)
    two = TriangleMesh(
        np.vstack([ball.vertices, ball.vertices + 5]), np.vstack([ball.faces, ball.faces + 162])
    )
    places = flat_places(skeletal_graph(two, "height", 5, root=True))
    assert len(np.unique(places, axis=0)) == len(places)
    assert places[-1, 0] == -1


def test_bands_have_different_colours_and_a_table_shows_them_at_the_levels():
    colours = band_colours(3)
    assert len(np.unique(colours, axis=0)) == 3
    table = band_table(np.array([0.25, 0.5]), colours)
    for value, band in ((0.1, 0), (0.3, 1), (0.6, 2), (1.0, 2)):
        shown = np.array(table.map_value(value)[:3]) * 255
        assert np.allclose(shown, colours[band], atol=1)


def test_node_colours_by_kind(torus):
    colours = node_colours(torus.graph, "kind", LIGHT)
    ends = colours[torus.graph.kinds == "branch"]
    assert (ends == np.array([int(KIND_COLOURS["branch"][i : i + 2], 16) for i in (1, 3, 5)])).all()


def test_the_text_counts_and_tells_why_there_is_no_genus(torus):
    assert counts_text(torus).endswith("1 loops / genus 1")
    pane = build_pane(draw(primitives.grid(4, 4), field="height", params={"x": 1.0}), np.zeros(3))
    assert pane.caption.endswith("genus –")
    assert pane.note.startswith("genus –: ")


def test_the_title_names_what_differs():
    view = SkeletonView(params={"weight": 0.3}, keep=0.25, source="noisy", resolution=9)
    title = view_title(view)
    assert title == "Mixture distance (λ = 0.3), R = 9 · noisy · 25% of the faces"


def test_a_picked_node_tells_what_it_is_once_it_has_grown(torus):
    last = len(torus.graph.nodes) - 1
    assert build_pane(torus, np.zeros(3), picked=last).note.startswith(f"node {last}, regular")
    assert build_pane(torus, np.zeros(3), step=3, picked=last).picked is None


def test_euclidean_shells_are_spheres_through_the_levels():
    skeleton = draw(primitives.torus(40, 20), field="euclidean", resolution=4)
    shells = shell_surfaces(skeleton, shell_levels(skeleton, None))
    radii = [np.linalg.norm(points, axis=1) for points, _ in shells]
    for radius, value in zip(radii, skeleton.field.raw([0.25, 0.5, 0.75, 1.0]), strict=True):
        assert np.allclose(radius, np.sqrt(value))


def test_mixture_shells_lie_where_the_field_has_their_value():
    skeleton = draw(primitives.torus(40, 20), field="affine", resolution=3)
    ((points, _),) = shell_surfaces(skeleton, np.array([0.5]))
    mesh = skeleton.mesh
    joined = TriangleMesh(np.vstack([mesh.vertices, points]), mesh.faces)
    values = squared_affine_norms(joined)[len(mesh.vertices) :]
    assert np.allclose(values, skeleton.field.raw(0.5))


def test_shells_of_the_height_are_planes():
    skeleton = draw(primitives.torus(40, 20), field="height", resolution=3)
    ((points, faces),) = shell_surfaces(skeleton, shell_levels(skeleton, 1))
    assert np.allclose(points[:, 2], skeleton.field.raw(1 / 3))
    assert len(faces) == 2


@pytest.mark.parametrize("aspect", [0.5, 1.0, 2.0])
def test_the_fitting_camera_sees_every_point(aspect):
    points = primitives.torus(40, 20).vertices * (1, 3, 1)
    pose = fitting_pose("Front (+Z)", points, aspect)
    seen = points - np.array(pose.position)
    slope = np.tan(np.radians(15)) * -seen[:, 2]
    assert (np.abs(seen[:, 0]) <= slope * aspect).all()
    assert (np.abs(seen[:, 1]) <= slope).all()
    assert max(np.abs(seen[:, 0] / slope / aspect).max(), np.abs(seen[:, 1] / slope).max()) > 0.8


@pytest.fixture
def grid():
    prefer_headless_graphics()
    plotter = pv.Plotter(shape=SHAPE, border=False, off_screen=True, window_size=list(SIZE))
    yield SkeletonGrid(plotter)
    plotter.close()


def test_nodes_are_found_where_they_are_drawn(grid, torus):
    lying = draw(primitives.torus(40, 20), field="height", params={"x": 1.0, "z": 0.0})
    panes = [build_pane(torus, np.zeros(3)), build_pane(lying, np.zeros(3))]
    grid.show(panes, SkeletonLook(SkeletonSettings(node_colour="kind"), DARK), SIZE)
    grid.look_from("Front (+Z)", SIZE)
    places, _, _ = grid._project(1, SIZE)
    for node in (0, len(places) - 1):
        x, y = places[node] / SIZE
        assert grid.pane_at(x, y) == 1
        assert grid.node_at(1, x, y, SIZE) == node
    assert grid.node_at(1, 0.51, 0.02, SIZE) is None


def test_only_what_is_new_is_built_again(grid, torus):
    look = SkeletonLook(SkeletonSettings(), LIGHT, selected=0)
    pane, other = build_pane(torus, np.zeros(3)), build_pane(torus, np.zeros(3), step=4)
    versions = []
    for panes in ([pane, pane], [pane, other]):
        grid.show(panes, look, SIZE)
        versions.append([view.version for view in grid.seen()])
    assert [b > a for a, b in zip(*versions, strict=True)] == [False, True]
