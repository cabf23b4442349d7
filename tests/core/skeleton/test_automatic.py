"""The automatic resolution shows what the Reeb graph says is long enough."""

import pytest

from core.fields import scalar_field
from core.mesh import primitives
from core.parameters import ParameterError
from core.skeleton import (
    automatic_resolution,
    automatic_resolution_steps,
    band_levels,
    graph_of,
    reeb_graph,
)

MODELS = [
    "cow_2904.off",
    "double_torus_eight_766.off",
    "elephant_2775.off",
    "fertility_4494.off",
    "octopus_7130.off",
    "awkward/many_small_holes.ply",
]


@pytest.mark.parametrize("name", MODELS)
@pytest.mark.parametrize("spacing", ["value", "distance", "area"])
def test_all_long_loops_and_branches_are_shown(model, name, spacing):
    mesh = model(name)
    field = scalar_field(mesh, "mixture")
    reeb = reeb_graph(mesh, field)
    for share in (0.04, 0.1, 0.3):
        chosen = automatic_resolution(mesh, field, share, spacing, reeb)
        graph = graph_of(mesh, field, band_levels(mesh, field, chosen.resolution, spacing))
        less = reeb.simplified(share)
        assert chosen.loops == less.loops
        assert chosen.is_complete or spacing == "area"
        if chosen.is_complete:
            assert graph.loops >= less.loops
            is_end = (less.down_degrees + less.up_degrees) == 1
            long = less.arcs[is_end[less.arcs].any(axis=1) & (less.lengths > share)]
            nodes = graph.pieces.vertex_nodes[less.vertices]
            assert (nodes[long[:, 0]] != nodes[long[:, 1]]).all()
            ends = {end for arc in long for end in arc if is_end[end]}
            assert len(set(nodes[list(ends)])) == len(ends)


def test_a_torus_on_its_side_needs_a_level_through_its_hole_and_one_band_within():
    mesh = primitives.torus(48, 16)
    field = scalar_field(mesh, "height", x=1, y=0.001, z=0.0001)
    chosen = automatic_resolution(mesh, field, 0.1)
    # The hole spans 0.286 to 0.714. Of five bands, 0.4 to 0.6 is the first that fits within.
    assert (chosen.resolution, chosen.loops, chosen.branches) == (5, 1, 2)
    assert chosen.is_complete
    assert graph_of(mesh, field, band_levels(mesh, field, 5)).loops == 1


def test_every_share_from_two_bands_on_is_complete(model):
    mesh = model("awkward/elephant_with_holes.off")
    field = scalar_field(mesh, "euclidean")
    assert automatic_resolution(mesh, field, 2 / 64).is_complete
    short = automatic_resolution(mesh, field, 0)
    assert (short.resolution, short.is_complete) == (64, False)


def test_it_may_be_left_after_every_resolution():
    mesh = primitives.torus(40, 24)
    field = scalar_field(mesh, "height")
    steps = automatic_resolution_steps(mesh, field)
    chosen = automatic_resolution(mesh, field)
    assert chosen.resolution > 2
    assert [next(steps) for _ in range(chosen.resolution)] == [None] * chosen.resolution
    with pytest.raises(StopIteration) as end:
        next(steps)
    assert end.value.value == chosen


def test_errors_say_what_is_allowed():
    mesh = primitives.torus()
    with pytest.raises(ParameterError, match=r"share=1\.5 is not allowed; use 0 to 1"):
        automatic_resolution(mesh, scalar_field(mesh, "height"), 1.5)
