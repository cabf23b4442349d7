"""Study files of other versions, damaged, or none at all: what is wrong is one clear sentence."""

import json

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from core.io import save_mesh
from core.mesh import primitives
from core.study import Study
from core.study_files import StudyFileError, document, read_study_file, write_study_file


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
