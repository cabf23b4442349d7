"""The Statistics tab's second model in a study file: kept, found, told when it is another."""

import json
import shutil

import pytest

from core.io import save_mesh
from core.mesh import primitives
from core.statistics_view import StatisticsSettings
from core.study import Study
from core.study_files import (
    ChangedModelError,
    MissingModelError,
    StudyFileError,
    fingerprint,
    read_study_file,
    write_study_file,
)


@pytest.fixture
def ring(tmp_path):
    path = tmp_path / "models" / "ring.ply"
    path.parent.mkdir()
    save_mesh(primitives.torus(), path)
    return path


@pytest.fixture
def study(ring):
    return Study(statistics=StatisticsSettings(second=str(ring), colour="degree"))


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "studies" / "a.burnish"
    path.parent.mkdir()
    return path


def test_it_is_named_relative_to_the_file_with_its_content(study, file, ring, tmp_path):
    write_study_file(study, file)
    plain = json.loads(file.read_text())
    assert plain["study"]["statistics"]["second"] == "../models/ring.ply"
    assert plain["files"]["second"] == fingerprint(ring).model_dump()
    assert read_study_file(file).locate(tmp_path) == study


def test_it_is_packed_on_request(study, file, ring, tmp_path):
    content = ring.read_bytes()
    write_study_file(study, file, packed=True)
    shutil.rmtree(ring.parent)
    found = read_study_file(file).locate(tmp_path / "cache").statistics
    assert found.colour == "degree"
    with open(found.second, "rb") as unpacked:
        assert unpacked.read() == content


def test_where_it_is_missing_another_place_can_be_named(study, file, ring, tmp_path):
    write_study_file(study, file)
    moved = ring.rename(ring.with_name("moved.ply"))
    with pytest.raises(MissingModelError, match=r"its second model ring\.ply is not at") as caught:
        read_study_file(file).locate(tmp_path)
    assert caught.value.role == "second"
    found = read_study_file(file).locate(tmp_path, chosen={"second": str(moved)})
    assert found.statistics.second == str(moved)


def test_where_it_has_changed_it_is_taken_only_when_accepted(study, file, ring, tmp_path):
    write_study_file(study, file)
    save_mesh(primitives.sphere(1), ring)
    with pytest.raises(ChangedModelError, match=r"its second model ring\.ply is not the one"):
        read_study_file(file).locate(tmp_path)
    assert read_study_file(file).locate(tmp_path, accepted=["second"]) == study


def test_the_rest_can_be_had_without_it(study, file, ring, tmp_path):
    write_study_file(study, file)
    ring.unlink()
    found = read_study_file(file).locate(tmp_path, with_second=False).statistics
    assert found == StatisticsSettings(second="none", colour="degree")


def test_what_everyone_has_needs_no_file(file, tmp_path):
    study = Study(statistics=StatisticsSettings(second="method:mean"))
    write_study_file(study, file)
    assert "second" not in json.loads(file.read_text())["files"]
    assert read_study_file(file).locate(tmp_path, with_second=False) == study


@pytest.mark.parametrize("place", ["//server/share.ply", "../../etc/passwd", ""])
def test_a_place_that_is_none_of_a_model_is_refused(study, file, tmp_path, place):
    write_study_file(study, file)
    plain = json.loads(file.read_text())
    plain["study"]["statistics"]["second"] = place
    file.write_text(json.dumps(plain))
    with pytest.raises(StudyFileError, match="is not the place of a model"):
        read_study_file(file).locate(tmp_path)
