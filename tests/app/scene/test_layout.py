"""Where the panes stand."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.scene.layout import row_lengths, tile


@pytest.mark.parametrize(
    ("count", "aspect", "rows"),
    [(1, 1.6, [1]), (2, 1.6, [2]), (2, 0.6, [1, 1]), (4, 1.6, [2, 2]), (7, 1.8, [4, 3])],
)
def test_rows_by_hand(count, aspect, rows):
    assert row_lengths(count, aspect) == rows


@given(st.integers(1, 9), st.floats(0.3, 4), st.floats(0.5, 1))
def test_panes_fill_their_part_of_the_window_without_overlap(count, aspect, right):
    ports = tile(count, aspect, right)
    area = sum((port.right - port.left) * (port.top - port.bottom) for port in ports)
    assert len(ports) == count
    assert area == pytest.approx(right)
    middles = [((p.left + p.right) / 2, (p.bottom + p.top) / 2) for p in ports]
    for index, middle in enumerate(middles):
        assert [port.holds(*middle) for port in ports].index(True) == index
        assert sum(port.holds(*middle) for port in ports) == 1
