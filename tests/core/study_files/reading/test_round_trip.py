"""Study files: what is written comes back, also after its folder was moved."""

import json
import os
import shutil

import pytest

from core.comparison import run
from core.io import save_mesh
from core.mesh import primitives
from core.noise import NoiseParams
from core.study import Study
from core.study_files import (
    ChangedModelError,
    MissingModelError,
    StudyFileError,
    fingerprint,
    read_study_file,
    study_text,
    write_study_file,
)


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
    message = r"^x\.burnish: cannot be written \(No such file or directory\)\.$"
    with pytest.raises(StudyFileError, match=message):
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
