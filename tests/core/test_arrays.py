"""Arrays: rows that are equal."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from core.arrays import first_rows


def test_the_first_of_equal_rows_in_their_order():
    rows = np.array([[2, 1], [0, 5], [2, 1], [0, 3], [0, 5]])
    assert first_rows(rows).tolist() == [3, 1, 0]


def test_no_rows():
    assert first_rows(np.zeros((0, 3), np.int32)).tolist() == []


@given(
    arrays(np.int64, st.tuples(st.integers(0, 40), st.integers(1, 3)), elements=st.integers(-2, 2))
)
def test_same_as_numpy(rows):
    assert first_rows(rows).tolist() == np.unique(rows, axis=0, return_index=True)[1].tolist()
