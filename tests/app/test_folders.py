"""Burnish's own folders do not grow for ever."""

import os

from app.folders import forget_old


def test_what_is_old_goes_and_what_is_new_stays(tmp_path):
    for name in ("old", "new"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "model.ply").write_text("ply")
    os.utime(tmp_path / "old", (1, 1))
    forget_old(tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["new"]


def test_a_folder_that_is_not_there_is_no_trouble(tmp_path):
    forget_old(tmp_path / "none")
