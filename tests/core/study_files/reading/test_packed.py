"""Packed studies that were changed: their models stay what, where and as large as they say."""

import zipfile

import pytest

from core.study_files import StudyFileError, packing, read_study_file, write_study_file


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
