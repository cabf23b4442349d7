"""The quick exponential against the library's."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from core.smoothing.exponential import falling_exponential


@given(st.floats(-708, 0))
def test_exponential_is_exact_to_the_last_two_bits(x):
    assert falling_exponential(x) == pytest.approx(np.exp(x), rel=1e-15, abs=0)


def test_exponential_far_down_and_of_no_number():
    assert [falling_exponential(x) for x in (-709.0, -np.inf, np.nan)] == [0, 0, 0]
    assert falling_exponential(0.0) == 1
