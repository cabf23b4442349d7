"""What the Statistics tab keeps in a study."""

import json

import pytest

from core.parameters import ParameterError
from core.statistics_view import StatisticsSettings
from core.study import Study
from core.study_files.document import read_document, write_document
from core.study_files.fingerprints import Fingerprint


def text(study):
    return write_document(study, {"model": Fingerprint.of(b"model")})


@pytest.mark.parametrize("second", ["none", "noisy", "method:mean", "sample:double_torus"])
def test_a_second_model_that_everyone_has_is_kept(second):
    settings = StatisticsSettings(second=second, colour="degree", relative=True)
    study = Study(statistics=settings)
    assert read_document(text(study).encode()).study.statistics == settings


@pytest.mark.parametrize(
    ("second", "file"),
    [("none", None), ("sample:torus", None), ("method:mean", None), ("/a/b.ply", "/a/b.ply")],
)
def test_it_is_known_which_second_model_is_a_file(second, file):
    assert StatisticsSettings(second=second).second_file == file


def test_a_second_model_without_its_fingerprint_is_refused():
    plain = json.loads(text(Study()))
    plain["study"]["statistics"]["second"] = "share.ply"
    with pytest.raises(ValueError, match="must hold the fingerprints of: model, second"):
        read_document(json.dumps(plain).encode())


def test_older_files_have_the_defaults():
    plain = json.loads(text(Study()))
    del plain["study"]["statistics"]
    assert read_document(json.dumps(plain).encode()).study.statistics == StatisticsSettings()


def test_parameters_are_checked():
    assert StatisticsSettings(geodesic={"sources": 7}).geodesic_params.sources == 7
    with pytest.raises(ParameterError):
        _ = StatisticsSettings(geodesic={"sources": 0}).geodesic_params


def test_statistics_do_not_change_the_comparison():
    assert Study().compares_like(Study(statistics=StatisticsSettings(colour="degree")))
