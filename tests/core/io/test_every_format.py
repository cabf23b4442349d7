"""What holds for every format: the square, the same square cut short, and damaged bytes."""

import random
import re

import numpy as np
import pytest

from core.io import SUPPORTED_READ, LoadError, load_mesh, read_mesh

NAMES = [
    *("text.ply", "little.ply", "big.ply", "text.obj", "text.off", "binary.off", "text.stl"),
    *("binary.stl", "binary.glb", "archive.3mf", "old.vtk", "new.vtp"),
]
QUICK = [name for name in NAMES if not name.endswith((".vtk", ".vtp"))]
SQUARE = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]


def test_every_supported_suffix_has_a_square(squares):
    assert set(squares) == set(NAMES)
    assert {f".{name.partition('.')[2]}" for name in NAMES} | {".gltf"} == set(SUPPORTED_READ)


@pytest.mark.parametrize("name", NAMES)
def test_the_square_is_read(name, squares, write):
    mesh = load_mesh(write(name, squares[name]))
    assert mesh.vertices.tolist() == SQUARE
    assert mesh.faces.tolist() == [[0, 1, 2], [0, 2, 3]]


@pytest.mark.parametrize("name", QUICK)
def test_the_suffix_may_be_in_capitals(name, squares, write):
    assert len(load_mesh(write(name.upper(), squares[name])).faces) == 2


@pytest.mark.parametrize("name", NAMES)
def test_a_file_cut_short_is_refused_in_one_sentence(name, squares, write):
    content = squares[name]
    steps = 60 if name in QUICK else 6
    for length in range(1, len(content), max(1, len(content) // steps)):
        path = write(name, content[:length])
        try:
            mesh = load_mesh(path)
        except LoadError as error:
            assert_one_sentence(str(error), name)
        else:
            # Nothing is missing but the end of the last number or the newline; an OBJ file
            # announces nothing, so that it may also end after its first face.
            assert len(mesh.faces) == 2 or name.endswith(".obj")


@pytest.mark.parametrize("name", QUICK)
def test_damaged_bytes_give_a_mesh_or_one_sentence(name, squares, write):
    rng = random.Random(name)
    for _ in range(60):
        content = bytearray(squares[name])
        for _ in range(rng.choice([1, 1, 2, 8])):
            content[rng.randrange(len(content))] = rng.randrange(256)
        try:
            mesh = load_mesh(write(name, bytes(content)))
        except LoadError as error:
            assert_one_sentence(str(error), name)
        else:
            assert np.isfinite(mesh.vertices).all()


@pytest.mark.parametrize("name", NAMES)
def test_a_file_of_another_kind_is_refused(name, write):
    message = refused(write(name, b"\x89PNG\r\n\x1a\n" + bytes(range(256)) * 4))
    assert re.search("it is no|it begins|it does not begin|it has no|cut short", message), message


@pytest.mark.parametrize("name", NAMES)
def test_an_empty_file_is_refused(name, write):
    assert refused(write(name, b"")) == f"{name}: the file is empty."


@pytest.mark.parametrize("name", NAMES)
def test_names_may_have_spaces_and_any_letters(name, squares, write):
    path = write(f"Kuh mit Hörnern 牛 {name}", squares[name])
    assert read_mesh(path).name == path.name


def refused(path) -> str:
    with pytest.raises(LoadError) as caught:
        load_mesh(path)
    return str(caught.value)


def assert_one_sentence(message: str, name: str) -> None:
    assert message.startswith(f"{name}: ")
    assert message.endswith(".")
    assert "\n" not in message
    assert len(message) < 260
