"""The table of results: numbers of every method, for the window, the terminal and papers."""

import csv
import io
import os
import unicodedata
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from app.export.outcomes import Outcome, study_outcomes
from core.comparison import StudyResult
from core.io import SaveError
from core.metrics import METRICS, MetricSpec
from core.whole_files import write_atomically

NOISY_TITLE = "Noisy input"
WORSE = "worse than the noisy input"

_LATEX = {
    "ℓ̄": r"$\bar{\ell}$",
    "²": r"\textsuperscript{2}",
    "°": r"\textdegree{}",
    "–": "--",
    **{sign: f"\\{sign}" for sign in "%&#_"},
}


@dataclass(frozen=True)
class ResultRow:
    """One line of the table.

    Attributes
    ----------
    method : str or None
        Id of the method; None for the noisy input.
    title : str
        Its name.
    iteration : int or None
        The iteration that is shown; None for the noisy input.
    errors : mapping of str to float
        Each metric at that iteration.
    best_iteration : int or None
        The iteration with the smallest error of the current metric.
    best_error : float or None
        That error.
    milliseconds : float or None
        Time of an iteration.
    note : str
        What a reader must know: that the run diverged, that it is worse than doing nothing.
    metrics : mapping of str to MetricSpec
        The metrics in the units of the errors.
    """

    method: str | None
    title: str
    iteration: int | None
    errors: Mapping[str, float]
    best_iteration: int | None = None
    best_error: float | None = None
    milliseconds: float | None = None
    note: str = ""
    metrics: Mapping[str, MetricSpec] = field(default_factory=lambda: METRICS)


def result_rows(
    noisy_errors: Mapping[str, float],
    outcomes: Sequence[Outcome],
    metric: str,
    metrics: Mapping[str, MetricSpec] = METRICS,
) -> tuple[ResultRow, ...]:
    """Return the rows: the noisy input first, then each method.

    Parameters
    ----------
    noisy_errors : mapping of str to float
        Each metric of the noisy input.
    outcomes : sequence of Outcome
        What the methods did.
    metric : str
        Metric that the best iteration and the note are about.
    metrics : mapping of str to MetricSpec
        The metrics in the units of the errors.
    """
    noisy = ResultRow(None, NOISY_TITLE, None, noisy_errors)
    rows = (noisy, *(_row(outcome, noisy_errors[metric], metric) for outcome in outcomes))
    return tuple(replace(row, metrics=metrics) for row in rows)


def study_rows(result: StudyResult) -> tuple[ResultRow, ...]:
    """Return the rows of a finished study, best by the study's own metric."""
    noisy_errors = result.comparison.noisy_errors
    study = result.study
    return result_rows(noisy_errors, study_outcomes(result), study.metric, study.metrics)


def _row(outcome: Outcome, noisy_error: float, metric: str) -> ResultRow:
    errors = {id_: values[outcome.iteration] for id_, values in outcome.errors.items()}
    best_iteration, best_error = outcome.best(metric)
    seconds = outcome.seconds_per_iteration
    notes = [] if outcome.diverged is None else [f"diverged at iteration {outcome.diverged}"]
    # A method that changes nothing may differ from its input in the last digit.
    if errors[metric] > noisy_error * (1 + 1e-9):
        notes.append(WORSE)
    return ResultRow(
        method=outcome.method,
        title=outcome.title,
        iteration=outcome.iteration,
        errors=errors,
        best_iteration=best_iteration,
        best_error=best_error,
        milliseconds=None if seconds is None else 1000 * seconds,
        note="; ".join(notes),
    )


def best_rows(rows: Sequence[ResultRow], metric: str) -> frozenset[int]:
    """Return the numbers of the rows with the smallest error of a metric."""
    smallest = min((row.errors[metric] for row in rows), default=0.0)
    return frozenset(i for i, row in enumerate(rows) if row.errors[metric] == smallest)


def significant(value: float | None, digits: int = 4) -> str:
    """Return a number with its significant digits, or a dash where there is none."""
    if value is None:
        return "–"
    return f"{value:#.{digits}g}".rstrip(".") if value else "0"


def headers(rows: Sequence[ResultRow] = ()) -> tuple[str, ...]:
    """Return the column titles of some rows with their units."""
    specs = rows[0].metrics if rows else METRICS
    metrics = [f"{spec.title} ({spec.unit})" for spec in specs.values()]
    return ("Method", "Iteration", *metrics, "Best at", "Best error", "ms/iteration", "Note")


def cells(row: ResultRow, digits: int = 4) -> tuple[str, ...]:
    """Return the cells of a row as a person reads them, errors with this many digits."""
    return (
        row.title,
        _count(row.iteration),
        *(significant(row.errors[metric], digits) for metric in METRICS),
        _count(row.best_iteration),
        significant(row.best_error, digits),
        significant(row.milliseconds, 3),
        row.note,
    )


def as_csv(rows: Sequence[ResultRow]) -> str:
    """Return the table for programs: ids for names, all digits, nothing where there is nothing."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    ends = ("best_iteration", "best_error", "ms_per_iteration", "note")
    writer.writerow(("method", "iteration", *METRICS, *ends))
    for row in rows:
        errors = [row.errors[metric] for metric in METRICS]
        best = (row.best_iteration, row.best_error)
        name = row.method or "noisy_input"
        writer.writerow((name, row.iteration, *errors, *best, row.milliseconds, row.note))
    return text.getvalue()


def as_markdown(rows: Sequence[ResultRow]) -> str:
    """Return the table in Markdown, the numbers to the right."""
    lines = [headers(rows), *(cells(row) for row in rows)]
    rule = [":--" if text else "--:" for text in _is_text()]
    body = [" | ".join(line) for line in (lines[0], rule, *lines[1:])]
    return "".join(f"| {line} |\n" for line in body)


def as_latex(rows: Sequence[ResultRow]) -> str:
    """Return the table as a LaTeX tabular that needs no packages."""
    columns = "".join("l" if text else "r" for text in _is_text())
    lines = [" & ".join(_latex(cell) for cell in line) for line in map(cells, rows)]
    head = " & ".join(_latex(header) for header in headers(rows))
    body = "".join(f"{line} \\\\\n" for line in lines)
    return (
        f"\\begin{{tabular}}{{{columns}}}\n\\hline\n{head} \\\\\n\\hline\n"
        f"{body}\\hline\n\\end{{tabular}}\n"
    )


def as_text(rows: Sequence[ResultRow]) -> str:
    """Return the table in columns of fixed width, for a terminal."""
    lines = [headers(rows), *(cells(row) for row in rows)]
    widths = [max(map(_width, column)) for column in zip(*lines, strict=True)]
    padded = [
        "  ".join(
            _padded(cell, width, left=text)
            for cell, width, text in zip(line, widths, _is_text(), strict=True)
        )
        for line in lines
    ]
    padded.insert(1, "  ".join("─" * width for width in widths))
    return "".join(f"{line.rstrip()}\n" for line in padded)


_FORMATS: dict[str, Callable[[Sequence[ResultRow]], str]] = {
    ".csv": as_csv,
    ".md": as_markdown,
    ".tex": as_latex,
    ".txt": as_text,
}
TABLE_SUFFIXES = tuple(_FORMATS)


def save_table(path: str | os.PathLike[str], rows: Sequence[ResultRow]) -> None:
    """Write the table to a file in the format of its suffix, one of `TABLE_SUFFIXES`.

    Raises
    ------
    SaveError
        If the suffix is another.
    """
    file = Path(path)
    if file.suffix.lower() not in _FORMATS:
        allowed = " ".join(_FORMATS)
        raise SaveError(f"{file.name}: tables are not written in this format; use {allowed}.")
    write_atomically(file, _FORMATS[file.suffix.lower()](rows).encode())


def _is_text() -> list[bool]:
    return [header in {"Method", "Note"} for header in headers()]


def _count(number: int | None) -> str:
    return "–" if number is None else str(number)


def _latex(text: str) -> str:
    for sign, command in _LATEX.items():
        text = text.replace(sign, command)
    return text


def _width(text: str) -> int:
    """Columns that a terminal gives a text: the bar of ℓ̄ stands over its letter."""
    return sum(not unicodedata.combining(sign) for sign in text)


def _padded(text: str, width: int, *, left: bool) -> str:
    room = " " * (width - _width(text))
    return text + room if left else room + text
