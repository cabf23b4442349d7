"""The numbers behind the plots of the statistics."""

import csv
import io
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any, Literal

from app.export.statistics_series import Series
from core.statistics import Histogram


@dataclass(frozen=True)
class Table:
    """Columns with a name each.

    Attributes
    ----------
    name : str
        Name of its file.
    columns : tuple of str
        Names of the columns.
    rows : tuple of tuples
        The cells.
    """

    name: str
    columns: tuple[str, ...]
    rows: tuple[tuple[Any, ...], ...]

    def text(self, delimiter: str = ",") -> str:
        """Return the table with all digits, for files (commas) or the clipboard (tabs)."""
        stream = io.StringIO()
        writer = csv.writer(stream, delimiter=delimiter, lineterminator="\n")
        writer.writerow(self.columns)
        writer.writerows(self.rows)
        return stream.getvalue()


def plot_tables(plot: str, series: Sequence[Series]) -> tuple[Table, ...]:
    """Return the tables with the numbers of a plot."""
    return _TABLES[plot](series)


def _spectrum(series: Sequence[Series]) -> tuple[Table, ...]:
    rows = [
        (one.name, *line)
        for one in series
        if (s := one.spectrum)
        for line in _lines(s.ranks, s.eigenvalues, s.low, s.high)
    ]
    columns = ("model", "normalised_rank", "eigenvalue", "low", "high")
    return (Table("spectrum", columns, tuple(rows)),)


def _degree(series: Sequence[Series]) -> tuple[Table, ...]:
    rows = _by_degree("degree", series)
    return (Table("degree", ("model", "degree", "vertices", "share"), rows),)


def _averages(part: Literal["assortativity", "clustering"], series: Sequence[Series]) -> Any:
    curve = Table(part, ("model", "degree", "vertices", part), _by_degree(part, series))
    histograms = [(one.name, getattr(one, part).histogram) for one in series]
    return curve, _histogram_table(f"{part}_histogram", "vertices", histograms)


def _geodesic(series: Sequence[Series]) -> tuple[Table, ...]:
    known = [(one.name, one.geodesic.histogram) for one in series if one.geodesic]
    return (_histogram_table("geodesic", "pairs", known),)


def _by_degree(part: str, series: Sequence[Series]) -> tuple[tuple[Any, ...], ...]:
    parts = [(one.name, getattr(one, part)) for one in series]
    return tuple(
        (name, *line) for name, p in parts for line in _lines(p.degrees, p.counts, p.quantity)
    )


def _histogram_table(
    name: str, counted: str, histograms: Iterable[tuple[str, Histogram | None]]
) -> Table:
    rows = [
        (model, *line)
        for model, h in histograms
        if h
        for line in _lines(h.edges[:-1], h.edges[1:], h.counts, h.shares)
    ]
    return Table(name, ("model", "from", "to", counted, "share"), tuple(rows))


def _lines(*columns: Any) -> Iterable[tuple[Any, ...]]:
    return zip(*(column.tolist() for column in columns), strict=True)


_TABLES: dict[str, Callable[[Sequence[Series]], tuple[Table, ...]]] = {
    "spectrum": _spectrum,
    "degree": _degree,
    "assortativity": partial(_averages, "assortativity"),
    "clustering": partial(_averages, "clustering"),
    "geodesic": _geodesic,
}
