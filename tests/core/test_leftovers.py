"""What a killed writer leaves beside a file goes when that is next written; nobody else's does."""

import os
import subprocess
import sys
import time

import pytest

from core.leftovers import fresh_path, remove_leftovers
from core.whole_files import replacing, write_atomically

_KILLED = """
import os, signal, sys
from pathlib import Path
from core.whole_files import replacing
with replacing(Path(sys.argv[1])) as fresh:
    fresh.write_bytes(b"half")
    if sys.argv[2] == "die":
        os.kill(os.getpid(), signal.SIGKILL)
    print("writing", flush=True)
    sys.stdin.read()
"""


def writer(target, end):
    words = [sys.executable, "-c", _KILLED, str(target), end]
    return subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.PIPE)


def names(folder):
    return sorted(path.name for path in folder.iterdir())


@pytest.mark.skipif(sys.platform == "win32", reason="kills a process")
def test_the_next_writer_removes_what_a_killed_one_left(tmp_path):
    target, other = tmp_path / "a [1].ply", tmp_path / "b.ply"
    for file in (target, other):
        with writer(file, "die") as killed:
            killed.wait(30)
    left = names(tmp_path)
    assert len(left) == 2
    write_atomically(target, b"whole")
    assert names(tmp_path) == [next(name for name in left if ".b." in name), "a [1].ply"]


def test_what_another_process_is_writing_stays(tmp_path):
    target = tmp_path / "model.ply"
    with writer(target, "live") as alive:
        assert alive.stdout.readline().strip() == b"writing"
        write_atomically(target, b"ours")
        assert target.read_bytes() == b"ours"
        assert len(names(tmp_path)) == 2
        alive.stdin.close()
        assert alive.wait(30) == 0
    assert target.read_bytes() == b"half"
    assert names(tmp_path) == ["model.ply"]


def test_what_this_process_is_writing_stays(tmp_path):
    target = tmp_path / "model.ply"
    with replacing(target) as fresh:
        fresh.write_bytes(b"slow")
        write_atomically(target, b"quick")
        assert fresh.exists()
    assert target.read_bytes() == b"slow"


def test_of_another_machine_it_stays_for_a_day(tmp_path, monkeypatch):
    target = tmp_path / "model.ply"
    with monkeypatch.context() as patch:
        patch.setattr("platform.node", lambda: "elsewhere")
        theirs = fresh_path(target)
    theirs.write_bytes(b"half")
    remove_leftovers(target)
    assert theirs.exists()
    yesterday = time.time() - 25 * 3600
    os.utime(theirs, (yesterday, yesterday))
    remove_leftovers(target)
    assert not theirs.exists()


@pytest.mark.parametrize(
    "name", [".model.tmp.ply", ".model.0000-1-abcdef.tmp.obj", "model.ply", ".model.old.tmp.ply"]
)
def test_a_file_of_somebody_elses_making_stays(name, tmp_path):
    file = tmp_path / name
    file.write_bytes(b"mine")
    os.utime(file, (0, 0))
    remove_leftovers(tmp_path / "model.ply")
    assert file.exists()


def test_a_folder_that_cannot_be_listed_keeps_nobody_from_saving(tmp_path, monkeypatch):
    def refuse(_):
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr("os.scandir", refuse)
    write_atomically(tmp_path / "model.ply", b"whole")
    assert (tmp_path / "model.ply").read_bytes() == b"whole"
