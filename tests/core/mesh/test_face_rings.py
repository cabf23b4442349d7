"""The rings of all faces in parts: the same rows as the whole table, whatever the limits."""

import time

import numpy as np
import pytest

from core.mesh import MeshError, TriangleMesh, face_rings, primitives, topology
from core.mesh.face_rings import FaceRings


def fan(faces):
    after = np.arange(1, faces + 1)
    corners = np.stack([np.zeros_like(after), after, after % faces + 1], axis=1)
    return TriangleMesh(np.random.default_rng(0).standard_normal((faces + 1, 3)), corners)


MESHES = {
    "fan": fan(40),
    "torus": primitives.torus(),
    "one": fan(3),
    "none": TriangleMesh(np.zeros((2, 3)), np.zeros((0, 3), int)),
}


def rows(parts):
    table = {}
    for first, starts, items in parts:
        for i in range(len(starts) - 1):
            assert first + i not in table
            table[first + i] = items[starts[i] : starts[i + 1]].tolist()
    return table


@pytest.mark.parametrize("kept", [0, 10**9])
@pytest.mark.parametrize("few", [1, 130, 10**9])
@pytest.mark.parametrize("name", MESHES)
def test_parts_have_the_rows_of_the_table(name, few, kept, monkeypatch):
    mesh = MESHES[name]
    whole = mesh.topology.face_ring
    monkeypatch.setattr(face_rings, "MOST_NEIGHBOURS", kept)
    monkeypatch.setattr(face_rings, "_FEW_NEIGHBOURS", few)
    parts = list(FaceRings(mesh.topology).parts())
    assert rows(parts) == {t: whole.row(t).tolist() for t in range(len(mesh.faces))}
    assert few > 1 or len(parts) == len(mesh.faces)
    assert few < 10**9 or len(parts) == min(len(mesh.faces), 1)


def test_a_table_that_would_be_too_large_is_refused(monkeypatch):
    monkeypatch.setattr(topology, "MOST_NEIGHBOURS", 1000)
    with pytest.raises(MeshError, match=r"^40 faces meet in one vertex, and each would be"):
        _ = fan(40).topology.face_ring


@pytest.mark.parametrize("kept", [0, 10**9])
def test_each_part_is_computed_at_its_turn_and_kept_where_it_may_be(kept, monkeypatch):
    computed = []

    def counted(table, first, last):
        computed.append((first, last))
        return face_rings_of(table, first, last)

    face_rings_of = topology.Topology.face_rings
    monkeypatch.setattr(topology.Topology, "face_rings", counted)
    monkeypatch.setattr(face_rings, "MOST_NEIGHBOURS", kept)
    monkeypatch.setattr(face_rings, "_FEW_NEIGHBOURS", 500)
    rings = FaceRings(fan(40).topology)
    next(parts := rings.parts())
    assert len(computed) == 1
    rest = len(list(parts))
    assert rest > 1
    assert len(list(rings.parts())) == rest + 1
    assert len(computed) == (rest + 1 if kept else 2 * (rest + 1))


def test_a_part_of_a_huge_fan_takes_a_moment_and_little_memory():
    _ = next(FaceRings(fan(10).topology).parts())
    started = time.thread_time()
    part = next(FaceRings(fan(60_000).topology).parts())
    # Measured: 0.1 s; sorting the neighbours of its vertex alone took 3 s.
    assert time.thread_time() - started < 1.5
    assert len(part.items) < 25_000_000
