"""Files that are whole, and whose parts are anything: glTF's tree, 3MF's XML, large headers."""

import copy
import json
import random
import struct
import zipfile
from pathlib import Path

import pytest

VALUES = [
    *(None, True, False, 0, -1, 1.5, 1e308, 2**31, 2**53, 2**62, 2**63, 2**64, 10**400),
    *("", "x", "\0", "../../x", "9" * 5000, [], [[]], [-1], [0, 0], {}, {"a": {}}, [None] * 3),
]


def places(tree, path=()):
    """Every place in a tree of JSON."""
    items = tree.items() if isinstance(tree, dict) else enumerate(tree)
    for key, value in items:
        yield (*path, key)
        if isinstance(value, dict | list):
            yield from places(value, (*path, key))


def changed(tree, path, value):
    """Return a tree with another value at a place, or without the place."""
    tree = copy.deepcopy(tree)
    *way, last = path
    place = tree
    for key in way:
        place = place[key]
    if value is places:
        del place[last]
    else:
        place[last] = value
    return tree


@pytest.fixture
def full_tree(describe_gltf):
    """Description that uses all that is read: offsets, strides, modes, nodes below nodes."""
    tree = describe_gltf()
    tree["nodes"] = [{"children": [1], "scale": [1, 2, 1]}, {"mesh": 0, "matrix": [1.0] * 16}]
    tree["bufferViews"][0].update(byteOffset=0, byteStride=12)
    tree["accessors"][0].update(byteOffset=0, min=[0, 0, 0], max=[1, 1, 0])
    tree["meshes"][0]["primitives"][0].update(mode=4)
    return tree


def test_every_value_of_a_gltf_may_be_any_other(full_tree, gltf_numbers, attempt, tmp_path):
    (tmp_path / "numbers.bin").write_bytes(gltf_numbers)
    full_tree["buffers"][0]["uri"] = "numbers.bin"
    rng = random.Random("gltf")
    for place in list(places(full_tree)):
        for value in (places, *rng.sample(VALUES, 10)):
            attempt("a.gltf", json.dumps(changed(full_tree, place, value)).encode())


def test_nodes_may_be_nested_deep(describe_gltf, gltf_numbers, attempt, tmp_path):
    (tmp_path / "numbers.bin").write_bytes(gltf_numbers)
    depth = 5_000
    nodes = [*({"children": [i + 1]} for i in range(depth)), {"mesh": 0}]
    tree = describe_gltf(nodes=nodes, buffers=[{"uri": "numbers.bin", "byteLength": 60}])
    assert not attempt("a.gltf", json.dumps(tree).encode())


@pytest.mark.parametrize("name", ["a.gltf", "a.glb"])
@pytest.mark.parametrize("text", [b"[" * 200_000, b'{"a":' * 100_000, b'{"a":1}'])
def test_json_of_another_shape_is_refused(name, text, attempt):
    head = struct.pack("<4sIII4s", b"glTF", 2, 20 + len(text), len(text), b"JSON")
    assert attempt(name, text if name == "a.gltf" else head + text)


XML = ["v1", "x", "id", "objectid", "vertex", "triangle", "transform", "<", ">", '"', "&", "/>"]


def test_every_word_of_a_3mf_may_be_any_other(make_3mf, attempt, tmp_path):
    whole = make_3mf(
        '<object id="1">{square}</object><object id="2"><components><component objectid="1" '
        'transform="1 0 0 0 1 0 0 0 1 5 5 5"/></components></object>',
        '<item objectid="2"/>',
    )
    (tmp_path / "whole.3mf").write_bytes(whole)
    with zipfile.ZipFile(tmp_path / "whole.3mf") as archive:
        parts = {name: archive.read(name).decode() for name in archive.namelist()}
    model = parts["3D/3dmodel.model"]
    rng = random.Random("3mf")
    for _ in range(600):
        start = rng.randrange(len(model))
        new = rng.choice([*XML, "", "-1", "nan", "9" * 400, "1e400", "&lt;", "\ufffe", "&x;"])
        text = model[:start] + new + model[start + rng.choice([0, 1, 4, 40]) :]
        attempt("a.3mf", packed({**parts, "3D/3dmodel.model": text}, tmp_path))


def packed(parts: dict[str, str], folder: Path) -> bytes:
    with zipfile.ZipFile(folder / "packed", "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in parts.items():
            archive.writestr(name, text)
    return (folder / "packed").read_bytes()


@pytest.mark.parametrize(
    ("entities", "use"),
    [
        ('<!ENTITY a SYSTEM "file:///etc/passwd">', "&a;"),
        ('<!ENTITY % a SYSTEM "file:///etc/passwd">%a;', "x"),
        ('<!ENTITY a "' + "x" * 50_000 + '">', "&a;" * 20_000),
        ("".join(f'<!ENTITY a{i} "{f"&a{i - 1};" * 10}">' for i in range(1, 12)), "&a11;"),
    ],
)
def test_entities_of_xml_neither_read_nor_swell(entities, use, attempt, tmp_path):
    text = f'<?xml version="1.0"?><!DOCTYPE m [<!ENTITY a0 "x">{entities}]><m a="{use}">{use}</m>'
    sentence = attempt("a.3mf", packed({"3D/3dmodel.model": text}, tmp_path))
    assert "root:" not in sentence


@pytest.mark.parametrize("depth", [10_000, 1_000_000])
def test_xml_may_be_nested_deep(depth, attempt, tmp_path):
    text = "<a>" * depth + "</a>" * depth
    attempt("a.3mf", packed({"3D/3dmodel.model": text}, tmp_path))


def test_an_archive_that_is_packed_in_another_way_is_refused(attempt, tmp_path):
    path = tmp_path / "lzma"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_LZMA) as archive:
        archive.writestr("3D/3dmodel.model", "<model/>")
    assert "packed in a way that 3MF does not allow" in attempt("a.3mf", path.read_bytes())


def head(*lines: str, count: int = 4) -> str:
    vertex = f"element vertex {count}\nproperty float x\nproperty float y\nproperty float z\n"
    return "ply\nformat {} 1.0\n" + vertex + "\n".join(lines) + "\nend_header\n"


LIST = "property list uchar int vertex_indices"


@pytest.mark.parametrize("encoding", ["ascii", "binary_little_endian", "binary_big_endian"])
@pytest.mark.parametrize(
    "header",
    [
        head("element face 1", LIST, count=4_000_000_000),
        head("element face 4000000000", LIST),
        head("element face 1", LIST.replace("uchar", "uint")),
        head("element face 1", LIST.replace("uchar", "double")),
        head("element face 1", LIST, count=10**30),
        head("element face 1", LIST, count=2**63 - 1),
        head("element face -1", LIST),
        head("element face 0", LIST),
        head(*[f"property float p{i}" for i in range(2_000)], "element face 1", LIST),
        head(*[f"property list int int p{i}" for i in range(2_000)], "element face 1", LIST),
        head(*[f"element e{i} 0" for i in range(5_000)]),
        head(*[f"element e{i} 1\nproperty char a" for i in range(2_000)]),
        head("element nothing 4000000000", "element face 1", LIST),
        head("element tristrips 1", LIST.replace("uchar", "int")),
        head("element vertex 4", "property float x"),
    ],
    ids=range(15),
)
def test_a_ply_may_announce_anything(encoding, header, attempt):
    for body in (
        b"",
        b"0 0 0 " * 4 + b"3 0 1 2\n",
        bytes(60_000),
        b"\xff" * 60_000,
        b"1 " * 30_000,
    ):
        attempt("a.ply", header.format(encoding).encode() + body)


def test_a_ply_may_have_very_many_properties(attempt):
    entries = [f"property float p{i}" for i in range(20_000)]
    assert "no list of vertex_indices" in attempt(
        "a.ply", head("element face 1", *entries).format("ascii").encode() + b"0 0 0 " * 99
    )


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("a.off", b"OFF\n4000000000 4000000000 0\n0 0 0\n"),
        ("a.off", b"OFF BINARY\n" + struct.pack(">3i", 2**31 - 1, 2**31 - 1, 0) + bytes(100)),
        ("a.off", b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n"),
        ("a.stl", bytes(80) + struct.pack("<I", 4_000_000_000) + bytes(5000)),
        ("a.obj", b"v 0 0 0\nf 1 -9223372036854775808 9223372036854775807\n"),
        ("a.obj", b"\\\n" * 500_000),
        ("a.obj", b"f " + b"1 " * 500_000 + b"\nv 0 0 0\n"),
        ("a.obj", b"f 1 2 3\n" * 100_000),
        ("a.obj", b"v 1 1 1\n" * 100_000),
        ("a.off", b"A" * 1_000_000),
        ("a.off", b"#" * 1_000_000),
        ("a.off", b"OFF\n" + b" " * 1_000_000 + b"\n"),
        ("a.stl", b"solid\n" + b"vertex 0 0 0\n" * 100_000),
        ("a.ply", b"ply\nformat ascii 1.0\n" + b"comment\n" * 200_000),
    ],
)
def test_long_and_lying_files_are_refused(name, content, attempt):
    assert attempt(name, content)
