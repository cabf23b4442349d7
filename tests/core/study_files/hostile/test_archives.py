"""Packed studies from strangers: models go nowhere else, and the disk is not filled."""

import json
import random
import stat
import zipfile
from pathlib import Path

import numpy as np
import pytest

from core.io import save_mesh
from core.mesh import TriangleMesh
from core.study import Study
from core.study_files import fingerprint, packing, read_study_file, write_study_file


def packed_as(file, plain, member, content, mark=None, **info):
    """Write a packed study whose model is a member of any name and form."""
    mark = mark or packing.Fingerprint.of(content).model_dump()
    study = {**plain["study"], "model": f"packed:{member}"}
    inside = {**plain, "study": study, "files": {**plain["files"], "model": mark}}
    entry = zipfile.ZipInfo(member)
    entry.compress_type = zipfile.ZIP_DEFLATED
    for name, value in info.items():
        setattr(entry, name, value)
    with zipfile.ZipFile(file, "w") as archive:
        archive.writestr("study.json", json.dumps(inside))
        archive.writestr(entry, content)
    return file


@pytest.mark.parametrize(
    "member",
    [
        "../../x.ply",
        "/tmp/x.ply",
        "..\\..\\x.ply",
        "C:\\x.ply",
        "C:x.ply",
        "a/../../x.ply",
        "./.ply",
    ],
)
def test_a_packed_model_is_put_nowhere_else(member, file, plain, tmp_path, outcome):
    cache = tmp_path / "home" / "cache"
    before = {path for path in tmp_path.rglob("*") if path != file}
    packed_as(file, plain, member, (file.parent / "t.ply").read_bytes())
    sentence = outcome(file, cache)
    made = {path for path in tmp_path.rglob("*") if path.is_file()} - before - {file}
    assert all(path.is_relative_to(cache) for path in made)
    assert made or sentence.startswith("a.burnish: ")


def test_a_link_in_an_archive_is_not_made(file, plain, tmp_path):
    mode = (stat.S_IFLNK | 0o777) << 16
    packed_as(file, plain, "m/x.ply", b"/etc/passwd", external_attr=mode, create_system=3)
    found = Path(read_study_file(file).locate(tmp_path / "cache").model)
    assert not found.is_symlink()
    assert found.read_bytes() == b"/etc/passwd"


def test_a_model_that_swells_out_of_nothing_is_not_unpacked(file, plain, tmp_path, refused):
    content = bytes(64 * 1024**2)
    packed_as(file, plain, "m/x.ply", content)
    assert file.stat().st_size < 100_000
    assert "in a size or form that is not allowed" in refused(file, tmp_path / "cache")
    assert not (tmp_path / "cache").exists()


def test_a_model_of_zeros_is_packed_so_that_it_opens_again(tmp_path):
    vertices = np.zeros((600_000, 3))
    save_mesh(TriangleMesh(vertices, [[0, 1, 2]]), tmp_path / "flat.ply")
    study = Study(model=str(tmp_path / "flat.ply"))
    write_study_file(study, tmp_path / "a.burnish", packed=True)
    found = read_study_file(tmp_path / "a.burnish").locate(tmp_path / "cache")
    assert fingerprint(found.model) == fingerprint(study.model)


def test_sizes_that_lie_are_not_believed(file, plain, tmp_path, refused):
    """The archive says ten bytes; a hundred million come out."""
    content = bytes(100_000_000)
    packed_as(file, plain, "m/x.ply", content, mark={"size": 10, "sha256": "0" * 64})
    raw = bytearray(file.read_bytes())
    size = len(content).to_bytes(4, "little")
    assert raw.count(size) == 2
    file.write_bytes(bytes(raw).replace(size, (10).to_bytes(4, "little")))
    assert refused(file, tmp_path / "cache").startswith("a.burnish: ")
    assert not (tmp_path / "cache").exists()


def test_a_document_that_swells_is_refused(file, tmp_path, refused):
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("study.json", " " * 50_000_000)
    assert "in a size or form that is not allowed" in refused(file, tmp_path)


@pytest.mark.parametrize("method", [zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_other_ways_to_pack_are_refused(method, file, plain, tmp_path, refused):
    packed_as(file, plain, "m/x.ply", b"x", compress_type=method)
    assert "in a size or form that is not allowed" in refused(file, tmp_path)


def test_broken_archives_are_one_sentence(file, plain, tmp_path, outcome):
    whole = packed_as(file, plain, "m/x.ply", (file.parent / "t.ply").read_bytes()).read_bytes()
    rng = random.Random(11)
    for _ in range(400):
        content = bytearray(whole)
        for _ in range(rng.choice([1, 2, 8])):
            content[rng.randrange(len(content))] = rng.choice([0, 255, rng.randrange(256)])
        file.write_bytes(content)
        sentence = outcome(file, tmp_path / "cache")
        assert sentence.isprintable()
    assert all(path.is_relative_to(tmp_path / "cache") for path in tmp_path.rglob("x.ply"))


def test_a_disk_that_is_full_while_unpacking_is_told(file, plain, tmp_path, monkeypatch, refused):
    packed_as(file, plain, "m/x.ply", (file.parent / "t.ply").read_bytes())

    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("os.fsync", full)
    assert "No space left on device" in refused(file, tmp_path / "cache")
    assert not [path for path in (tmp_path / "cache").rglob("*") if path.is_file()]
