"""One mesh or eight side by side: by hand, against numpy, and what is refused."""

import subprocess
import sys

import numpy as np
import pytest
from numba.core.errors import TypingError

from core.kernels import Kernel
from core.lanes import WIDTH, row, set_row, side_by_side, totals, xyz

ROWS = np.array([[1.0, 2, 3, 4, 6, 8, 9, 10], [5.0, 7, 11, 13, 17, 19, 23, 29]])


def compiled(function):
    """Compile without a file on disk, so that the code is really made here."""
    return Kernel(function, cache=False)


@compiled
def calculated(rows, results):
    """Every operator between lanes, between lanes and a number, and a sum from 0."""
    a, b = row(rows, 0), row(rows, 1)
    set_row(results, 0, a + b)
    set_row(results, 1, a - b)
    set_row(results, 2, a * b)
    set_row(results, 3, a / b)
    set_row(results, 4, 2.0 / (1.0 - 3.0 * (a / 8.0 + 5.0)))
    total = 0.0
    for i in range(len(rows)):
        total = total + row(rows, i)
    set_row(results, 5, total)
    set_row(results, 6, 0.5)


@pytest.mark.parametrize("rows", [ROWS, ROWS[:, 1].copy()], ids=["eight", "one"])
def test_eight_are_calculated_as_one_is(rows):
    a, b = rows
    results = np.zeros((8, *rows.shape[1:]))
    calculated(rows, results)
    expected = [a + b, a - b, a * b, a / b, 2 / (1 - 3 * (a / 8 + 5)), a + b, 0 * a + 0.5, 0 * a]
    assert np.array_equal(results, expected)


@compiled
def set_coordinates(positions, i, results):
    x, y, z = xyz(positions, i)
    set_row(results, 0, x)
    set_row(results, 1, y)
    set_row(results, 2, z)


@pytest.mark.parametrize("shape", [(2, 3), (2, 3, WIDTH)], ids=["one", "eight"])
@pytest.mark.parametrize("kind", [np.int64, np.uint32])
def test_coordinates_of_a_vertex(shape, kind):
    positions = np.arange(float(np.prod(shape))).reshape(shape)
    for i in range(2):
        results = np.zeros(shape[1:])
        set_coordinates(positions, kind(i), results)
        assert np.array_equal(results, positions[i])


@pytest.mark.parametrize("count", range(1, WIDTH + 1))
def test_meshes_side_by_side(count):
    meshes = list(np.random.default_rng(1).normal(size=(count, 5, 3)))
    positions = side_by_side([np.asfortranarray(mesh) for mesh in meshes])
    assert positions.flags.c_contiguous
    filled = meshes + [meshes[-1]] * (WIDTH - count)
    expected = meshes[0] if count == 1 else np.stack(filled, axis=-1)
    assert np.array_equal(positions, expected)


def test_totals_do_not_depend_on_what_stands_beside():
    sums = np.random.default_rng(1).normal(size=(1000, WIDTH))
    assert np.array_equal(totals(sums), [totals(column) for column in sums.T])
    assert totals(sums) == pytest.approx(sums.sum(axis=0))


@pytest.mark.parametrize(
    "rows",
    [np.zeros((WIDTH, 2)).T, np.zeros((2, WIDTH), np.float32), np.zeros((2, 3, WIDTH))],
    ids=["order", "kind", "dimensions"],
)
def test_what_does_not_hold_numbers_of_one_or_eight_is_refused(rows):
    @compiled
    def first(rows):
        set_row(rows, 0, row(rows, 0))

    with pytest.raises(TypingError):
        first(rows)


def test_numba_is_not_imported_by_the_names():
    code = "import core.lanes, sys; sys.exit('numba' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
