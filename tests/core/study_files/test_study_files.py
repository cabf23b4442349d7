"""Study files: what is written comes back, and what is wrong is one clear sentence."""

import json
import os
import shutil
import zipfile

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.comparison import run
from core.io import save_mesh
from core.mesh import primitives
from core.noise import NoiseParams, add_noise
from core.study import MethodChoice, Study
from core.study_files import (
    ChangedModelError,
    MissingModelError,
    StudyFileError,
    document,
    fingerprint,
    packing,
    read_study_file,
    study_text,
    write_study_file,
)


@pytest.fixture
def models(tmp_path):
    folder = tmp_path / "models"
    folder.mkdir()
    save_mesh(primitives.sphere(1), folder / "ball.ply")
    save_mesh(add_noise(primitives.sphere(1), 0.1), folder / "scan.ply")
    return folder


@pytest.fixture
def study(models):
    return Study(
        model=str(models / "ball.ply"),
        noise=NoiseParams(sigma=0.3, seed=9),
        methods=(MethodChoice(method="mean", iterations=2),),
    )


@pytest.fixture
def file(tmp_path):
    folder = tmp_path / "studies"
    folder.mkdir()
    return folder / "first.burnish"


def numbers(study):
    return [method.errors for method in run(study).methods]


def test_a_plain_file_names_the_model_relative_to_itself(study, file, models, tmp_path):
    write_study_file(study, file)
    plain = json.loads(file.read_text())
    assert plain["format"] == "burnish study"
    assert plain["version"] == 2
    assert plain["study"]["model"] == "../models/ball.ply"
    assert plain["files"]["model"]["size"] == (models / "ball.ply").stat().st_size
    assert len(plain["files"]["model"]["sha256"]) == 64
    assert str(tmp_path) not in file.read_text()


def test_what_was_written_comes_back(study, file, tmp_path):
    write_study_file(study, file)
    assert read_study_file(file).locate(tmp_path) == study


def test_folders_moved_together_give_the_same_numbers(study, file, tmp_path):
    before = numbers(study)
    write_study_file(study, file)
    moved = tmp_path / "another machine"
    moved.mkdir()
    for name in ("studies", "models"):
        shutil.move(tmp_path / name, moved / name)
    found = read_study_file(moved / "studies" / file.name).locate(tmp_path)
    assert found.model == str(moved / "models" / "ball.ply")
    assert numbers(found) == before


def test_a_packed_file_needs_no_other(study, file, models, tmp_path):
    study = study.model_copy(update={"noisy": str(models / "scan.ply")})
    before = numbers(study)
    write_study_file(study, file, packed=True)
    shutil.rmtree(models)
    read = read_study_file(file)
    found = read.locate(tmp_path / "cache")
    assert read.packed
    assert numbers(found) == before
    assert read.locate(tmp_path / "cache").model == found.model


def test_a_model_of_several_files_is_packed_as_one(study, file, models, tmp_path):
    ball = primitives.sphere(1)
    parts = {"vertices": ball.vertices.astype("<f4"), "faces": ball.faces.astype("<u4")}
    (models / "ball.bin").write_bytes(parts["vertices"].tobytes() + parts["faces"].tobytes())
    split = parts["vertices"].nbytes
    gltf = {
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"uri": "ball.bin", "byteLength": split + parts["faces"].nbytes}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": split},
            {"buffer": 0, "byteOffset": split, "byteLength": parts["faces"].nbytes},
        ],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(ball.vertices), "type": "VEC3",
             "min": [-1, -1, -1], "max": [1, 1, 1]},
            {"bufferView": 1, "componentType": 5125, "count": ball.faces.size, "type": "SCALAR"},
        ],
    }  # fmt: skip
    (models / "ball.gltf").write_text(json.dumps(gltf))
    study = study.model_copy(update={"model": str(models / "ball.gltf")})
    before = numbers(study)
    write_study_file(study, file, packed=True)
    shutil.rmtree(models)
    assert numbers(read_study_file(file).locate(tmp_path)) == before


def test_bundled_models_are_named_by_their_id(file, tmp_path):
    write_study_file(Study(), file, packed=True)
    found = read_study_file(file).locate(tmp_path / "cache")
    assert found == Study()
    assert not (tmp_path / "cache").exists()


def test_a_missing_model_says_which_and_can_be_replaced(study, file, models, tmp_path):
    write_study_file(study, file)
    (models / "ball.ply").rename(models / "moved.ply")
    read = read_study_file(file)
    with pytest.raises(MissingModelError, match=r"its model ball\.ply is not at") as caught:
        read.locate(tmp_path)
    assert caught.value.role == "model"
    assert caught.value.place == str(models / "ball.ply")
    moved = str(models / "moved.ply")
    assert read.locate(tmp_path, chosen={"model": moved}).model == moved


def test_a_changed_model_is_told_and_taken_only_when_accepted(study, file, models, tmp_path):
    write_study_file(study, file)
    save_mesh(primitives.torus(), models / "ball.ply")
    read = read_study_file(file)
    with pytest.raises(ChangedModelError, match="not the one the study was saved with"):
        read.locate(tmp_path)
    assert read.locate(tmp_path, accepted=["model"]) == study


def test_a_change_that_keeps_the_size_is_seen(study, file, models, tmp_path):
    write_study_file(study, file)
    ball = models / "ball.ply"
    content = bytearray(ball.read_bytes())
    content[-1] ^= 1
    ball.write_bytes(content)
    os.utime(ball, ns=(1, 1))
    with pytest.raises(ChangedModelError):
        read_study_file(file).locate(tmp_path)


def test_the_fingerprint_of_what_was_opened_is_kept(study, file, models, tmp_path):
    known = {study.model: fingerprint(study.model)}
    save_mesh(primitives.torus(), models / "ball.ply")
    write_study_file(study, file, known=known)
    with pytest.raises(ChangedModelError):
        read_study_file(file).locate(tmp_path)
    with pytest.raises(StudyFileError, match=r"ball\.ply has changed since it was opened"):
        write_study_file(study, file, packed=True, known=known)


def edited(study, file, change):
    write_study_file(study, file)
    plain = json.loads(file.read_text())
    change(plain)
    file.write_text(json.dumps(plain))
    return file


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (lambda d: d.update(version=7), r"newer Burnish \(format version 7; this one reads up"),
        (lambda d: d.update(version="x"), "format version 'x', which is not known"),
        (lambda d: d.pop("version"), "format version None"),
        (lambda d: d.update(format="cake"), "is not a study"),
        (lambda d: d.update(macro="rm"), "has the field macro, which this Burnish does not know"),
        (lambda d: d["study"].update(colour=1), "has the field study.colour, which"),
        (lambda d: d["study"]["noise"].update(sigma=7), "study.noise.sigma=7, which is not all"),
        (lambda d: d["study"]["methods"][0].update(method="magic"), "magic is not a method"),
        (lambda d: d["study"]["methods"][0].update(params={"a": 1}), "mean.a is not a parameter"),
        (lambda d: d["study"]["methods"].append(d["study"]["methods"][0]), "a method twice"),
        (lambda d: d["study"].update(metric="luck"), "metric=luck; allowed: visual_error"),
        (lambda d: d["study"].update(model="//host/share/a.ply"), "not the place of a model"),
        (lambda d: d["study"].update(model=""), "not the place of a model"),
        (lambda d: d["files"].clear(), "must hold the fingerprints of: model"),
        (lambda d: d["files"]["model"].update(sha256="abc"), "files.model.sha256=abc"),
    ],
)
def test_what_is_not_known_or_not_allowed_is_one_sentence(study, file, tmp_path, change, sentence):
    with pytest.raises(StudyFileError, match=sentence) as caught:
        read_study_file(edited(study, file, change)).locate(tmp_path)
    text = str(caught.value)
    assert text.startswith("first.burnish: ")
    assert text.endswith(".")
    assert "\n" not in text


@pytest.mark.parametrize(
    "content", [b"", b"{", b"[" * 100_000, b"PK\x03\x04", b"\xff\xfe", b"9" * 5_000, b"null"]
)
def test_what_is_no_study_is_one_sentence(file, content):
    file.write_bytes(content)
    with pytest.raises(StudyFileError, match=r"first\.burnish: is not a study"):
        read_study_file(file)


def test_a_huge_file_is_not_read_whole(file):
    with file.open("wb") as stream:
        stream.truncate(10**12)
    with pytest.raises(StudyFileError, match="larger than a study can be"):
        read_study_file(file)


def test_old_versions_migrate(study, file, tmp_path, monkeypatch):
    write_study_file(study, file)

    def renamed(plain):
        return {**plain, "version": 3}

    monkeypatch.setattr(document, "FORMAT_VERSION", 3)
    monkeypatch.setitem(document.MIGRATIONS, 2, renamed)
    assert read_study_file(file).locate(tmp_path) == study


def test_version_1_which_knew_no_second_file_is_read(study, file, tmp_path):
    old = edited(study, file, lambda plain: plain.update(version=1))
    assert read_study_file(old).locate(tmp_path) == study


@given(cut=st.integers(0, 900), flip=st.integers(0, 900), value=st.integers(0, 255))
@settings(max_examples=150, deadline=None)
@pytest.mark.parametrize("packed", [False, True])
def test_damaged_files_are_refused_in_one_sentence(tmp_path_factory, packed, cut, flip, value):
    folder = tmp_path_factory.mktemp("damaged")
    save_mesh(primitives.tetrahedron(), folder / "t.ply")
    file = folder / "a.burnish"
    write_study_file(Study(model=str(folder / "t.ply")), file, packed=packed)
    content = bytearray(file.read_bytes())
    content[flip % len(content)] = value
    file.write_bytes(content[: len(content) - cut if cut % 2 else None])
    sentence = ""
    try:
        read_study_file(file).locate(folder / "cache")
    except StudyFileError as error:
        sentence = str(error)
    assert "\n" not in sentence


def packed_with(study, file, change):
    """Write a packed study and change the archive."""
    write_study_file(study, file, packed=True)
    with zipfile.ZipFile(file) as archive:
        members = {name: archive.read(name) for name in archive.namelist()}
    change(members)
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in members.items():
            archive.writestr(name, content)
    return file


def test_a_packed_model_stays_in_its_folder(study, file, tmp_path):
    def escape(members):
        members["study.json"] = members["study.json"].replace(
            b"packed:model/ball.ply", b"packed:../../evil.ply"
        )
        members["../../evil.ply"] = members["model/ball.ply"]

    cache = tmp_path / "a" / "b" / "cache"
    found = read_study_file(packed_with(study, file, escape)).locate(cache)
    assert found.model.startswith(str(cache))
    assert not list(tmp_path.glob("evil.ply"))


def test_only_models_are_unpacked(study, file, tmp_path):
    def disguise(members):
        text = members["study.json"].replace(b"model/ball.ply", b"model/ball.exe")
        members["study.json"] = text
        members["model/ball.exe"] = members["model/ball.ply"]

    with pytest.raises(StudyFileError, match=r"'ball\.exe', which is not the name of a model"):
        read_study_file(packed_with(study, file, disguise)).locate(tmp_path)


def test_a_packed_model_with_another_content_is_refused(study, file, tmp_path):
    def swap(members):
        members["model/ball.ply"] = members["model/ball.ply"][:-1] + b"!"

    with pytest.raises(StudyFileError, match="another content than it says"):
        read_study_file(packed_with(study, file, swap)).locate(tmp_path)


def test_a_member_that_swells_does_not_fill_the_disk(study, file, tmp_path):
    def swell(members):
        members["model/ball.ply"] = bytes(50 * 1024**2)

    packed_with(study, file, swell)
    assert file.stat().st_size < 100_000
    with pytest.raises(StudyFileError, match="in a size or form that is not allowed"):
        read_study_file(file).locate(tmp_path / "cache")
    assert not (tmp_path / "cache").exists()


def test_a_model_that_is_too_large_is_not_packed(study, file, monkeypatch):
    monkeypatch.setattr(packing, "MOST_MODEL_BYTES", 100)
    with pytest.raises(StudyFileError, match=r"ball\.ply is larger than"):
        write_study_file(study, file, packed=True)


def test_an_old_file_stays_when_the_new_one_cannot_be_written(study, file, monkeypatch):
    write_study_file(study, file)
    before = file.read_bytes()

    def fail(_):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", fail)
    with pytest.raises(StudyFileError, match="No space left on device"):
        write_study_file(study.model_copy(update={"noise": NoiseParams()}), file)
    assert file.read_bytes() == before
    assert [path.name for path in file.parent.iterdir()] == [file.name]


def test_a_study_without_its_folder_or_model_is_not_written(study, file, tmp_path):
    with pytest.raises(StudyFileError, match="cannot be written"):
        write_study_file(study, tmp_path / "no" / "x.burnish")
    gone = study.model_copy(update={"model": str(tmp_path / "gone.ply")})
    with pytest.raises(StudyFileError, match=r"gone\.ply"):
        write_study_file(gone, file)


def test_a_file_that_is_called_like_a_bundled_model_is_a_file(file, models, tmp_path, monkeypatch):
    shutil.copy(models / "ball.ply", file.parent / "sample:ball.ply")
    study = Study(model=str(file.parent / "sample:ball.ply"))
    assert '"./sample:ball.ply"' in study_text(study, file.parent)
    write_study_file(study, file)
    assert read_study_file(file).locate(tmp_path) == study
