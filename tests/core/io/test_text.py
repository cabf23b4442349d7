"""Numbers in lines of text: whole tables at once, and what is left to the slower way."""

import numpy as np
import pytest

from core.io import LoadError
from core.io.text import coordinates, number_lists, number_rows, whole_rows


def test_a_table_is_read_at_once():
    assert number_rows([b" 1 2.5", b"3\t4e2 "]).tolist() == [[1, 2.5], [3, 400]]
    assert whole_rows([b"1 -2", b"3 4"]).tolist() == [[1, -2], [3, 4]]


@pytest.mark.parametrize(
    "lines", [[], [b""], [b"1 2", b"3"], [b"1 2", b""], [b"1 2", b"3 x"], [b"1 2 # 3", b"4 5 # 6"]]
)
def test_other_lines_are_left_to_the_slower_way(lines):
    assert number_rows(lines) is None


@pytest.mark.parametrize("word", [b"1.5", b"nan", b"inf", b"99999999999999999999"])
def test_what_is_not_whole_is_left_too(word):
    assert whole_rows([b"1 2", b"3 " + word]) is None


def test_every_digit_counts():
    numbers = (
        np.random.default_rng(0).standard_normal((50, 3)) * 10.0 ** np.arange(-30, 20)[:, None]
    )
    lines = [" ".join(map(repr, row)).encode() for row in numbers.tolist()]
    assert np.array_equal(coordinates(lines), numbers)
    assert np.array_equal(coordinates([*lines[:-1], lines[-1] + b" colour"]), numbers)


def test_coordinates_leave_what_follows_them():
    expected = [[1, 2, 3], [4, 5, 6]]
    assert coordinates([b"1 2 3 0.5", b"4 5 6 0.5"]).tolist() == expected
    assert coordinates([b"1 2 3", b"4 5 6 7"]).tolist() == expected
    assert coordinates([b"1 2 3 red", b"4 5 6 blue"]).tolist() == expected
    assert coordinates([]).shape == (0, 3)


def test_lists_of_equal_and_of_different_lengths():
    assert number_lists([b"1 2 3", b"4 5 6"]).items.tolist() == [1, 2, 3, 4, 5, 6]
    ragged = number_lists([b"1 2 3", b"", b"4 5"])
    assert ragged.sizes.tolist() == [3, 0, 2]
    assert ragged.items.tolist() == [1, 2, 3, 4, 5]
    assert len(number_lists([]).sizes) == 0


@pytest.mark.parametrize("read", [coordinates, number_lists])
def test_what_is_no_number_is_named(read):
    with pytest.raises(LoadError, match="'two' is not a"):
        read([b"1 2 3", b"1 two 3"])
