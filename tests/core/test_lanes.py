"""Four numbers side by side: by hand, against numpy, and what is refused."""

import subprocess
import sys

import numpy as np
import pytest
from numba.core.errors import TypingError

from core.kernels import Kernel
from core.lanes import every, numbers, row, set_row, turned, with_fourth, xyz

ROWS = np.array([[1.0, 2.0, 3.0, 4.0], [5.0, 7.0, 11.0, 13.0]])


def compiled(function):
    """Compile without a file on disk, so that the code is really made here."""
    return Kernel(function, cache=False)


def test_rows_are_added_subtracted_and_multiplied_number_by_number():
    @compiled
    def pair(rows):
        a, b = row(rows, 0), row(rows, 1)
        return numbers(a + b), numbers(b - a), numbers(a * b)

    a, b = ROWS
    assert np.array_equal(pair(ROWS), [a + b, b - a, a * b])


def test_a_point_has_nothing_in_its_fourth_number():
    @compiled
    def point(points, i):
        return numbers(xyz(points, i))

    points = np.arange(6.0).reshape(2, 3) + 1
    assert point(points, 0) == (1, 2, 3, 0)
    assert point(points, 1) == (4, 5, 6, 0)


def test_one_number_is_repeated_and_the_fourth_replaced():
    @compiled
    def both(rows, number):
        return numbers(every(number)), numbers(with_fourth(row(rows, 0), number))

    assert both(ROWS, 8.0) == ((8, 8, 8, 8), (1, 2, 3, 8))


def test_a_row_is_written_and_its_neighbours_are_left():
    @compiled
    def write(rows, i, number):
        set_row(rows, i, every(number))

    rows = np.zeros((3, 4))
    write(rows, 1, 9.0)
    assert rows.tolist() == [[0] * 4, [9] * 4, [0] * 4]


def test_turned_numbers_give_the_cross_product_from_its_z_on():
    @compiled
    def product(points):
        a, b = xyz(points, 0), xyz(points, 1)
        return numbers(turned(a)), numbers(a * turned(b) - turned(a) * b)

    a, b = np.random.default_rng(1).normal(size=(2, 3))
    around, cross = product(np.array([a, b]))
    assert np.array_equal(around, [a[1], a[2], a[0], 0])
    assert np.array_equal(cross, [*np.roll(np.cross(a, b), 1), 0])


@pytest.mark.parametrize(
    "rows", [np.zeros((4, 2)).T, np.zeros((2, 4), np.float32), np.zeros(8)], ids=str
)
def test_rows_that_do_not_lie_one_after_the_other_are_refused(rows):
    @compiled
    def first(rows):
        return numbers(row(rows, 0))

    with pytest.raises(TypingError):
        first(rows)


def test_numba_is_not_imported_by_the_names():
    code = "import core.lanes, sys; sys.exit('numba' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
