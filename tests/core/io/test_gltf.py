"""glTF and GLB: parts with their transforms, and everything trimesh would get wrong."""

import base64
import json

import numpy as np
import pytest

from core.io import LoadError, load_mesh, read_mesh

SQUARE = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
HALF_TURN = [0, 0, 1, 0]  # about z


def test_numbers_may_lie_in_a_file_beside_it(describe_gltf, gltf_numbers, write):
    write("the numbers.bin", gltf_numbers)
    tree = describe_gltf(buffers=[{"byteLength": 60, "uri": "the%20numbers.bin"}])
    mesh = load_mesh(write("square.gltf", json.dumps(tree)))
    assert mesh.vertices.tolist() == SQUARE


def test_numbers_may_be_written_into_the_description(describe_gltf, gltf_numbers, write):
    uri = "data:application/octet-stream;base64," + base64.b64encode(gltf_numbers).decode()
    tree = describe_gltf(buffers=[{"byteLength": 60, "uri": uri}])
    assert load_mesh(write("square.gltf", json.dumps(tree))).vertices.tolist() == SQUARE


def test_parts_are_moved_to_their_places_and_joined(make_glb, write):
    """A parent moves by (10, 0, 0); one child turns by half a turn, the other doubles in size."""
    nodes = [
        {"translation": [10, 0, 0], "children": [1, 2]},
        {"mesh": 0, "rotation": HALF_TURN},
        {"mesh": 0, "scale": [2, 2, 2], "translation": [0, 0, 5]},
    ]
    result = read_mesh(write("parts.glb", make_glb(nodes=nodes)))
    turned = [[10, 0, 0], [9, 0, 0], [9, -1, 0], [10, -1, 0]]
    doubled = [[10, 0, 5], [12, 0, 5], [12, 2, 5], [10, 2, 5]]
    found = result.mesh.vertices.reshape(2, 4, 3)
    order = np.argsort(found[:, 0, 2])
    assert found[order] == pytest.approx(np.array([turned, doubled]), abs=1e-12)
    assert result.report == ("2 parts joined",)


def test_a_mirrored_part_keeps_its_outside(make_glb, write):
    mesh = load_mesh(write("m.glb", make_glb(nodes=[{"mesh": 0, "scale": [-1, 1, 1]}])))
    corners = mesh.vertices[mesh.faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert (normals[:, 2] > 0).all()


def test_cameras_points_and_lines_are_left_out_and_what_hangs_below_them_is_kept(make_glb, write):
    surface = {"attributes": {"POSITION": 0}, "indices": 1}
    nodes = [{"camera": 0, "mesh": 1, "children": [1]}, {"mesh": 0}]
    meshes = [
        {"primitives": [surface, {**surface, "mode": 1}, {**surface, "mode": 0}]},
        {"primitives": [{**surface, "mode": 3}]},
    ]
    cameras = [{"type": "perspective", "perspective": {"yfov": 1, "znear": 1}}]
    content = make_glb(nodes=nodes, meshes=meshes, cameras=cameras)
    result = read_mesh(write("mixed.glb", content))
    assert result.mesh.vertices.tolist() == SQUARE
    assert result.report == ("3 parts of points or lines left out",)


def test_strips_and_faces_without_numbers(make_glb, write):
    numbers = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]], "<f4").tobytes() + bytes(12)
    meshes = [{"primitives": [{"attributes": {"POSITION": 0}, "mode": 5}]}]
    mesh = load_mesh(write("strip.glb", make_glb(numbers, meshes=meshes)))
    assert len(mesh.faces) == 2
    assert mesh.topology.is_consistently_wound


def test_a_deep_tree_takes_no_quadratic_time(make_glb, write):
    nodes = [{"mesh": 0, "children": [i + 1], "translation": [1, 0, 0]} for i in range(1999)]
    content = make_glb(nodes=[*nodes, {"mesh": 0, "translation": [1, 0, 0]}])
    mesh = load_mesh(write("deep.glb", content))
    assert len(mesh.faces) == 4000
    assert mesh.vertices[:, 0].max() == pytest.approx(2001)


ACCESSOR = {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"}
NUMBERS = {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}
FAN = {"attributes": {"POSITION": 0}, "indices": 1, "mode": 6}


@pytest.mark.parametrize(
    ("changes", "reason"),
    [
        ({"extensionsUsed": ["KHR_draco_mesh_compression"]}, "it uses KHR_draco_mesh_compression"),
        ({"accessors": [{**ACCESSOR, "sparse": {}}, NUMBERS]}, "it uses sparse or missing data"),
        ({"accessors": [{**ACCESSOR, "count": 4_000_000_000}, NUMBERS]}, "far more numbers"),
        ({"accessors": [{**ACCESSOR, "count": 5}, NUMBERS]}, "not well-formed"),
        ({"accessors": [{**ACCESSOR, "count": -1}, NUMBERS]}, "an array without entries"),
        ({"accessors": [{**ACCESSOR, "componentType": 5122}, NUMBERS]}, "are not 32-bit numbers"),
        ({"accessors": [{"componentType": 5126, "count": 4, "type": "VEC3"}, NUMBERS]}, "missing"),
        ({"accessors": [ACCESSOR, {**NUMBERS, "bufferView": 0, "count": 24}]}, "names vertex"),
        ({"meshes": [{"primitives": [FAN]}]}, "it uses triangle fans"),
        ({"nodes": [{"mesh": 0, "children": [0]}]}, "its nodes do not form a tree"),
        ({"nodes": [{"children": [1, 1]}, {"mesh": 0}]}, "its nodes do not form a tree"),
        ({"nodes": [{"mesh": 7}]}, "not well-formed"),
        ({"nodes": [{}]}, "it has no faces, only 0 points"),
        ({"asset": {"version": "1.0"}}, "only GLTF 2 is supported"),
        ({"buffers": [{"byteLength": 60, "uri": "none.bin"}]}, "'none.bin', which is not beside"),
        ({"buffers": [{"byteLength": 9, "uri": "../../secret"}]}, "secret', which is not beside"),
    ],
)
def test_what_would_give_a_wrong_mesh_is_refused(changes, reason, make_glb, write):
    with pytest.raises(LoadError, match=reason):
        load_mesh(write("bad.glb", make_glb(**changes)))


@pytest.mark.parametrize("content", ["[]", "{}", '{"meshes": 3}', "[" * 100_000, "hello", "null"])
def test_other_json_is_refused(content, write):
    with pytest.raises(LoadError, match=r"it is no glTF file|not well-formed|it has no faces"):
        load_mesh(write("other.gltf", content))
