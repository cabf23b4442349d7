"""3MF: objects, components, the build plate, and archives that are traps."""

import numpy as np
import pytest

from core.io import LoadError, load_mesh, read_mesh

SQUARE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
MESH = '<object id="1">{square}</object>'


def test_items_of_the_build_are_moved_to_their_places(make_3mf, write):
    """The second item has its x axis along y: rows of the transform are the images of the axes."""
    build = '<item objectid="1"/><item objectid="1" transform="0 1 0 -1 0 0 0 0 1 10 20 30"/>'
    result = read_mesh(write("two.3mf", make_3mf(MESH, build)))
    turned = np.array([[10, 20, 30], [10, 21, 30], [9, 21, 30], [9, 20, 30]])
    assert np.array_equal(result.mesh.vertices, np.vstack([SQUARE, turned]))
    assert result.mesh.faces[2:].tolist() == [[4, 5, 6], [4, 6, 7]]
    assert result.report == ("2 parts joined",)


def test_components_are_placed_inside_their_object(make_3mf, write):
    components = (
        MESH + '<object id="2"><components>'
        '<component objectid="1" transform="2 0 0 0 2 0 0 0 2 0 0 0"/></components></object>'
    )
    build = '<item objectid="2" transform="1 0 0 0 1 0 0 0 1 5 0 0"/>'
    mesh = load_mesh(write("parts.3mf", make_3mf(components, build)))
    assert np.array_equal(mesh.vertices, 2 * SQUARE + [5, 0, 0])


def test_components_may_lie_in_other_parts_of_the_archive(make_3mf, write):
    components = (
        '<object id="1"><components><component p:path="/3D/other.model" objectid="1"/>'
        "</components></object>"
    )
    content = make_3mf(components, '<item objectid="1"/>', other=MESH)
    assert np.array_equal(load_mesh(write("other.3mf", content)).vertices, SQUARE)


def test_only_what_is_on_the_build_plate_counts(make_3mf, write):
    with pytest.raises(LoadError, match="it has no faces"):
        load_mesh(write("empty.3mf", make_3mf(MESH, "")))


def component_tower(levels: int) -> str:
    """Objects of which each uses the one before ten times."""
    uses = '<component objectid="{}"/>' * 10
    objects = [
        f'<object id="{n}"><components>{uses.replace("{}", str(n - 1))}</components></object>'
        for n in range(2, levels + 2)
    ]
    return "".join(objects)


@pytest.mark.parametrize(
    ("resources", "build", "reason"),
    [
        (MESH, '<item objectid="2"/>', "it uses object '2', which is not in 3D/3dmodel.model"),
        (MESH, "<item/>", "an element of its model has no attribute 'objectid'"),
        (MESH, '<item objectid="1" transform="1 2"/>', "not well-formed"),
        ('<object id="1">{square}', "", "its model is not whole XML"),
        ('<object id="1"><mesh><vertices><vertex x="a" y="0" z="0"/>', "", "could not convert"),
        (MESH + component_tower(12), '<item objectid="13"/>', "repeated more often"),
        ('<object id="1"/>' + component_tower(12), '<item objectid="13"/>', "repeated more often"),
        (
            '<object id="1"><components><component objectid="1"/></components></object>',
            '<item objectid="1"/>',
            "nested more than 32 deep",
        ),
        (
            '<object id="1"><mesh><vertices><vertex x="0" y="0" z="0"/></vertices><triangles>'
            '<triangle v1="0" v2="1" v3="2"/></triangles></mesh></object>',
            '<item objectid="1"/>',
            "a face names vertex 1; its part has 0 to 0",
        ),
    ],
)
def test_bad_models_are_refused(resources, build, reason, make_3mf, write):
    with pytest.raises(LoadError, match=reason):
        load_mesh(write("bad.3mf", make_3mf(resources, build)))


def test_an_archive_that_unpacks_to_far_too_much_is_refused(make_3mf, write):
    content = make_3mf(MESH + " " * 20_000_000, '<item objectid="1"/>')
    assert len(content) < 100_000
    with pytest.raises(LoadError, match="it unpacks to far more"):
        load_mesh(write("bomb.3mf", content))


def test_an_archive_without_a_model_is_refused(make_3mf, write):
    content = make_3mf(MESH, "").replace(b".model", b".mo_el")
    with pytest.raises(LoadError, match="its archive holds no model"):
        load_mesh(write("none.3mf", content))
