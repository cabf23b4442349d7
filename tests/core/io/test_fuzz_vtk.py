"""Broken files for VTK's readers, which run in a process of their own and may die there."""

import os
import random
import struct
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from core.io import LoadError, load_mesh

AT_ONCE = os.cpu_count() or 1


def binary_vtk() -> bytes:
    head = b"# vtk DataFile Version 3.0\na square\nBINARY\nDATASET POLYDATA\nPOINTS 4 float\n"
    points = struct.pack(">12f", 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0)
    return head + points + b"\nPOLYGONS 1 5\n" + struct.pack(">5i", 4, 0, 1, 2, 3) + b"\n"


def broken(content: bytes, rng: random.Random) -> bytes:
    """Cut, flip, double or replace something."""
    place, length = rng.randrange(len(content)), rng.choice([1, 4, 12, 60])
    change = rng.choice(["cut", "without", "flip", "number", "word", "double"])
    before, piece, after = content[:place], content[place:][:length], content[place + length :]
    match change:
        case "cut":
            return before
        case "without":
            return before + after
        case "flip":
            return before + bytes(byte ^ 1 << rng.randrange(8) for byte in piece) + after
        case "number":
            return before + rng.choice([b"\xff" * 4, b"\x7f\xff\xff\xff", bytes(4)]) + after
        case "word":
            words = [b" -1 ", b" 4000000000 ", b" nan ", b"9" * 300, b" 1e400 ", b"<", b'"']
            return before + rng.choice(words) + content[place:]
        case _:
            return before + piece * 50 + after


@pytest.mark.parametrize("name", ["old.vtk", "binary.vtk", "new.vtp"])
def test_broken_files_give_a_mesh_or_one_sentence(name, squares, tmp_path):
    rng, whole = random.Random(name), {**squares, "binary.vtk": binary_vtk()}
    suffix = name.partition(".")[2]
    paths = [tmp_path / f"{number}.{suffix}" for number in range(16)]
    for path in paths:
        path.write_bytes(broken(whole[name], rng))
    with ThreadPoolExecutor(AT_ONCE) as pool:
        for path, sentence in zip(paths, pool.map(outcome, paths), strict=True):
            assert "\n" not in sentence
            assert not sentence or (sentence.startswith(f"{path.name}: ") and len(sentence) < 240)


def outcome(path) -> str:
    try:
        mesh = load_mesh(path)
    except LoadError as error:
        return str(error)
    assert np.isfinite(mesh.vertices).all()
    return ""
