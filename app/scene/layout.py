"""Where the panes stand: rows of viewports that fill a window."""

from typing import NamedTuple


class Viewport(NamedTuple):
    """A rectangle in a window, as shares of its width and height from the lower left corner."""

    left: float
    bottom: float
    right: float
    top: float

    def pixels(self, width: int, height: int) -> tuple[float, float, float, float]:
        """Return left, top, width and height in pixels from the upper left corner."""
        return (
            self.left * width,
            (1 - self.top) * height,
            (self.right - self.left) * width,
            (self.top - self.bottom) * height,
        )

    def holds(self, x: float, y: float) -> bool:
        """Whether a point, in shares of the window from the lower left corner, lies inside."""
        return self.left <= x < self.right and self.bottom <= y < self.top


def row_lengths(count: int, aspect: float) -> list[int]:
    """Number of panes in each row, so that the panes come out as square as they can.

    Parameters
    ----------
    count : int
        Number of panes.
    aspect : float
        Width of the window over its height.
    """

    def smaller_side(rows: int) -> float:
        return min(aspect / -(-count // rows), 1 / rows)

    rows = max(range(1, count + 1), key=smaller_side)
    base, longer = divmod(count, rows)
    return [base + (row < longer) for row in range(rows)]


def tile(count: int, aspect: float, right: float = 1.0) -> list[Viewport]:
    """Viewports of `count` panes in reading order, up to the share `right` of the width."""
    if count == 0:
        return []
    lengths = row_lengths(count, aspect * right)
    height = 1 / len(lengths)
    return [
        Viewport(
            right * column / length,
            1 - (row + 1) * height,
            right * (column + 1) / length,
            1 - row * height,
        )
        for row, length in enumerate(lengths)
        for column in range(length)
    ]
