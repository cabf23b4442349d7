"""The bundled models."""

import pytest

from core.io import LoadError, bundled_samples, load_sample, samples, save_mesh


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """Stand for the installed resources, so far without models."""
    monkeypatch.setattr(samples, "files", lambda _package: tmp_path)
    (tmp_path / "models").mkdir()
    return tmp_path / "models"


def test_an_empty_folder_has_no_samples(folder):
    assert bundled_samples() == ()
    folder.rmdir()
    assert bundled_samples() == ()


def test_missing_resources_have_no_samples(monkeypatch):
    def missing(name: str) -> None:
        raise ModuleNotFoundError(name)

    monkeypatch.setattr(samples, "files", missing)
    assert bundled_samples() == ()


def test_samples_come_in_display_order_with_titles(folder, ball):
    for name in ("zebra_foal", "machine_part", "ant", "creature"):
        save_mesh(ball, folder / f"{name}.ply")
    (folder / "generate.py").write_text("")
    found = [(sample.id, sample.title) for sample in bundled_samples()]
    assert found == [
        ("creature", "Creature"),
        ("machine_part", "Machine part"),
        ("ant", "Ant"),
        ("zebra_foal", "Zebra foal"),
    ]


def test_a_sample_is_loaded_by_its_id(folder, ball):
    save_mesh(ball, folder / "creature.ply")
    assert len(load_sample("creature").faces) == len(ball.faces)
    with pytest.raises(LoadError, match=r"cow is not a bundled model; allowed: creature\."):
        load_sample("cow")


def test_the_installed_samples_load():
    for sample in bundled_samples():
        assert len(load_sample(sample.id).faces) > 0
        assert sample.title
