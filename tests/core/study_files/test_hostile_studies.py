"""Studies from strangers: nothing runs, nothing else is read, the disk is not filled."""

import copy
import json
import random
import stat
import sys
import zipfile
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest

from core.io import save_mesh
from core.mesh import TriangleMesh, primitives
from core.study import Study
from core.study_files import (
    MissingModelError,
    StudyFileError,
    document,
    fingerprint,
    packing,
    read_study_file,
    write_study_file,
)

VALUES = [
    *(None, True, -1, 0, 1.5, 1e308, float("nan"), float("inf"), 2**63, 10**400, "", "\0", "a\nb"),
    *("\ud800", "x" * 5000, "../../etc/passwd", [], [[]], {}, {"a": {"b": {}}}, [None], "\x1b[2J"),
]
RUNS = (
    "exec",
    "compile",
    "import",
    "os.",
    "subprocess.",
    "socket.",
    "ctypes.",
    "pickle.",
    "shutil",
)

# Hooks of this kind stay for ever; this one has something to do only while somebody watches.
_watchers: list[list[tuple[str, object]]] = []


def _audit(event: str, arguments: tuple[object, ...]) -> None:
    for events in _watchers:
        events.append((event, arguments[0] if arguments else None))


sys.addaudithook(_audit)


@contextmanager
def watching():
    """Collect what Python does meanwhile: files opened, code run, programs started."""
    events: list[tuple[str, object]] = []
    _watchers.append(events)
    try:
        yield events
    finally:
        _watchers.remove(events)


@pytest.fixture
def file(tmp_path):
    """A plain study of a tetrahedron, in a folder of its own."""
    (tmp_path / "study").mkdir()
    save_mesh(primitives.tetrahedron(), tmp_path / "study" / "t.ply")
    path = tmp_path / "study" / "a.burnish"
    write_study_file(Study(model=str(tmp_path / "study" / "t.ply")), path)
    return path


@pytest.fixture
def plain(file):
    return json.loads(file.read_text())


def refused(file, folder) -> str:
    with pytest.raises(StudyFileError) as caught:
        read_study_file(file).locate(folder)
    return str(caught.value)


def outcome(file, folder) -> str:
    try:
        read_study_file(file).locate(folder)
    except StudyFileError as error:
        return str(error)
    return ""


def places(tree, path=()):
    """Every place in a tree of JSON."""
    for key, value in tree.items() if isinstance(tree, dict) else enumerate(tree):
        yield (*path, key)
        if isinstance(value, dict | list):
            yield from places(value, (*path, key))


def changed(tree, path, value):
    tree = copy.deepcopy(tree)
    *way, last = path
    place = tree
    for key in way:
        place = place[key]
    place[last] = value
    return tree


def test_every_value_may_be_any_other(file, plain, tmp_path):
    rng = random.Random(7)
    for place in list(places(plain)):
        for value in rng.sample(VALUES, 8):
            file.write_text(json.dumps(changed(plain, place, value)))
            sentence = outcome(file, tmp_path / "cache")
            assert sentence.isprintable()
            assert not sentence or sentence.startswith("a.burnish: ")
            assert len(sentence) < 5500


@pytest.mark.parametrize("name", ["a\nb", "\x1b[31m", "x" * 10_000, "__class__"])
def test_unknown_fields_of_any_name_are_one_sentence(name, file, plain, tmp_path):
    file.write_text(json.dumps({**plain, name: {"py/object": "os.system"}}))
    sentence = refused(file, tmp_path)
    assert sentence.isprintable()
    assert "which this Burnish does not know" in sentence
    assert len(sentence) < 200


@pytest.mark.parametrize("depth", [10, 300, 600, 900, 990, 2000])
def test_values_may_be_nested_deep(depth, file, plain, tmp_path):
    text = json.dumps(plain).replace('"visual_error"', "[" * depth + "]" * depth)
    file.write_text(text)
    assert refused(file, tmp_path).startswith("a.burnish: ")


def test_nothing_runs_and_no_other_file_is_opened(file, plain, tmp_path):
    for name, value in (("metric", "__import__('os').system('id')"), ("model", "/etc/passwd")):
        hostile = changed(plain, ("study", name), value)
        file.write_text(json.dumps(hostile))
        outcome(file, tmp_path / "cache")  # what is loaded on first use is loaded now
        with watching() as events:
            assert outcome(file, tmp_path / "cache")
        assert {str(what) for event, what in events if event == "open"} == {str(file)}
        assert not [event for event, _ in events if event.startswith(RUNS)]


@pytest.mark.parametrize(
    "place",
    [
        *("/etc/passwd", "../../../../../../etc/passwd", "/dev/zero", "/proc/self/environ", "~"),
        *("//host/a.ply", "\\\\host\\a.ply", "/\\host/a.ply", "\\/host\\a.ply", "http://host/x"),
        *("packed:a.ply/../../x", "a.ply\0.txt", "a.ply/", ".", "..", "x" * 5000 + ".ply"),
    ],
)
def test_what_is_no_model_is_not_even_looked_for(place, file, plain, tmp_path):
    file.write_text(json.dumps(changed(plain, ("study", "model"), place)))
    with watching() as events:
        sentence = outcome(file, tmp_path / "cache")
    assert "is not the place of a model" in sentence or "is not at" in sentence
    assert {str(what) for event, what in events if event == "open"} == {str(file)}


def test_a_secret_called_like_a_model_is_compared_and_not_read_further(file, plain, tmp_path):
    secret = tmp_path / "secret.ply"
    secret.write_text("the code is 1234")
    file.write_text(json.dumps(changed(plain, ("study", "model"), "../secret.ply")))
    with watching() as events:
        sentence = refused(file, tmp_path / "cache")
    assert "is not the one the study was saved with" in sentence
    assert "1234" not in sentence
    assert str(secret) not in [str(what) for event, what in events if event == "open"]


def test_every_older_version_has_a_way_to_this_one():
    assert set(document.MIGRATIONS) == set(range(1, document.FORMAT_VERSION))


def test_an_old_version_that_is_damaged_is_one_sentence(file, tmp_path, monkeypatch):
    this = document.FORMAT_VERSION
    monkeypatch.setattr(document, "FORMAT_VERSION", this + 1)
    monkeypatch.setitem(document.MIGRATIONS, this, lambda plain: plain["missing"]["field"])
    assert refused(file, tmp_path) == f"a.burnish: is damaged (it says format version {this})."


@pytest.mark.parametrize("version", [0, -1, 1.0, True, None, "1", [], 10**400, 3, 999])
def test_versions_that_are_not_known_are_told(version, file, plain, tmp_path):
    file.write_text(json.dumps({**plain, "version": version}))
    assert "version" in refused(file, tmp_path)


def packed_as(file, plain, member, content, mark=None, **info):
    """Write a packed study whose model is a member of any name and form."""
    mark = mark or packing.Fingerprint.of(content).model_dump()
    inside = changed(plain, ("study", "model"), f"packed:{member}")
    inside["files"]["model"] = mark
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
def test_a_packed_model_is_put_nowhere_else(member, file, plain, tmp_path):
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


def test_a_model_that_swells_out_of_nothing_is_not_unpacked(file, plain, tmp_path):
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


def test_sizes_that_lie_are_not_believed(file, plain, tmp_path):
    """The archive says ten bytes; a hundred million come out."""
    content = bytes(100_000_000)
    packed_as(file, plain, "m/x.ply", content, mark={"size": 10, "sha256": "0" * 64})
    raw = bytearray(file.read_bytes())
    size = len(content).to_bytes(4, "little")
    assert raw.count(size) == 2
    file.write_bytes(bytes(raw).replace(size, (10).to_bytes(4, "little")))
    assert refused(file, tmp_path / "cache").startswith("a.burnish: ")
    assert not (tmp_path / "cache").exists()


def test_a_document_that_swells_is_refused(file, tmp_path):
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("study.json", " " * 50_000_000)
    assert "in a size or form that is not allowed" in refused(file, tmp_path)


@pytest.mark.parametrize("method", [zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_other_ways_to_pack_are_refused(method, file, plain, tmp_path):
    packed_as(file, plain, "m/x.ply", b"x", compress_type=method)
    assert "in a size or form that is not allowed" in refused(file, tmp_path)


def test_broken_archives_are_one_sentence(file, plain, tmp_path):
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


def test_a_disk_that_is_full_while_unpacking_is_told(file, plain, tmp_path, monkeypatch):
    packed_as(file, plain, "m/x.ply", (file.parent / "t.ply").read_bytes())

    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("os.fsync", full)
    assert "No space left on device" in refused(file, tmp_path / "cache")
    assert not [path for path in (tmp_path / "cache").rglob("*") if path.is_file()]


def test_a_missing_model_with_a_strange_name_is_one_line(file, plain, tmp_path):
    file.write_text(json.dumps(changed(plain, ("study", "model"), "a\nb\x1b[2J.ply")))
    with pytest.raises(MissingModelError) as caught:
        read_study_file(file).locate(tmp_path)
    assert str(caught.value).isprintable()
