"""Files that take their places together, or none of them does."""

from concurrent.futures import CancelledError
from contextlib import suppress

import pytest

from core.whole_files import Staging, replacing, whole_file, write_atomically


def test_files_that_are_held_back_take_their_places_together(tmp_path):
    first, second = tmp_path / "first", tmp_path / "second"
    first.write_bytes(b"old")
    staging = Staging()
    for file in (first, second):
        with staging:
            write_atomically(file, b"new")
        assert first.read_bytes() == b"old"
    assert not second.exists()
    staging.commit()
    staging.discard()
    assert [file.read_bytes() for file in (first, second)] == [b"new", b"new"]
    assert len(list(tmp_path.iterdir())) == 2


def test_what_is_discarded_leaves_nothing(tmp_path):
    file = tmp_path / "first"
    file.write_bytes(b"old")
    staging = Staging()
    with staging:
        write_atomically(file, b"new")
        write_atomically(tmp_path / "second", b"new")
    staging.discard()
    assert file.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [file]


def test_what_is_written_beside_a_staging_is_not_held_back(tmp_path):
    staging = Staging()
    with staging:
        pass
    write_atomically(tmp_path / "file", b"new")
    assert (tmp_path / "file").exists()


def test_a_file_that_fails_is_not_held(tmp_path):
    staging = Staging()
    with suppress(ZeroDivisionError), staging, replacing(tmp_path / "file") as fresh:
        fresh.write_bytes(b"half")
        raise ZeroDivisionError
    staging.commit()
    assert not list(tmp_path.iterdir())


def test_a_place_that_is_taken_is_told_and_the_rest_is_discarded(tmp_path):
    taken = tmp_path / "taken"
    staging = Staging()
    with staging:
        write_atomically(taken, b"new")
    taken.mkdir()
    with pytest.raises(OSError, match="taken"):
        staging.commit()
    staging.discard()
    assert list(tmp_path.iterdir()) == [taken]


def test_what_is_discarded_while_it_is_written_stops_and_leaves_nothing(tmp_path):
    file, staging = tmp_path / "file", Staging()
    file.write_bytes(b"old")
    written = []
    with suppress(CancelledError), staging, whole_file(file) as stream:
        for block in (b"first", b"second"):
            stream.write(block)
            written.append(block)
            staging.discard()
    assert written == [b"first"]
    assert list(tmp_path.iterdir()) == [file]
    assert file.read_bytes() == b"old"


def test_a_file_that_is_half_written_goes_at_once(tmp_path):
    staging = Staging()
    with suppress(CancelledError), staging, replacing(tmp_path / "file") as fresh:
        fresh.write_bytes(b"half")
        staging.discard()
        assert not fresh.exists()
        fresh.write_bytes(b"whole")  # by a writer that does not ask
    assert not list(tmp_path.iterdir())


def test_after_that_nothing_takes_its_place(tmp_path):
    staging = Staging()
    with staging:
        write_atomically(tmp_path / "file", b"new")
    staging.discard()
    with pytest.raises(CancelledError):
        staging.commit()
    with pytest.raises(CancelledError), staging:
        write_atomically(tmp_path / "other", b"new")
    assert not list(tmp_path.iterdir())
