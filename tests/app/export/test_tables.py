"""The table of results: its rows, and the same rows in every format."""

import csv
import io

import pytest

from app.export.outcomes import Outcome
from app.export.tables import (
    NOISY_TITLE,
    WORSE,
    as_csv,
    as_latex,
    as_markdown,
    as_text,
    best_rows,
    result_rows,
    save_table,
    significant,
    study_rows,
)
from core.comparison import run
from core.io import SaveError, save_mesh
from core.mesh import primitives
from core.metrics import METRICS
from core.study import MethodChoice, Study

NOISY = {"visual_error": 0.002, "vertex_rms": 0.03, "normal_angle": 2.5}


def outcome(method="mean", visual_errors=(0.002, 0.0012, 0.0016), **changes):
    errors = {metric: (NOISY[metric], 0.2, 0.1) for metric in METRICS}
    errors["visual_error"] = visual_errors
    settings = {"iteration": 2, "seconds_per_iteration": 0.0125, "diverged": None, **changes}
    return Outcome(method, errors=errors, **settings)


def test_rows_solved_by_hand():
    noisy, row = result_rows(NOISY, [outcome()], "visual_error")
    assert (noisy.method, noisy.title, noisy.iteration) == (None, NOISY_TITLE, None)
    assert noisy.errors == NOISY
    assert (row.method, row.title, row.iteration) == ("mean", "Mean filter", 2)
    assert row.errors == {"visual_error": 0.0016, "vertex_rms": 0.1, "normal_angle": 0.1}
    assert (row.best_iteration, row.best_error) == (1, 0.0012)
    assert row.milliseconds == 12.5
    assert row.note == ""


def test_best_follows_the_metric():
    row = result_rows(NOISY, [outcome()], "vertex_rms")[1]
    assert (row.best_iteration, row.best_error) == (0, 0.03)


def test_note_says_what_a_reader_must_know():
    worse = outcome(visual_errors=(0.002, 0.003, 0.004))
    diverged = outcome(visual_errors=(0.002, 0.003, 9.0), diverged=3)
    unchanged = outcome(visual_errors=(0.002, 0.002, 0.002))
    rows = result_rows(NOISY, [worse, diverged, unchanged], "visual_error")
    assert [row.note for row in rows] == ["", WORSE, f"diverged at iteration 3; {WORSE}", ""]


def test_run_without_an_iteration_has_no_time():
    start = outcome(visual_errors=(0.002,), iteration=0, seconds_per_iteration=None)
    row = result_rows(NOISY, [start], "visual_error")[1]
    assert row.milliseconds is None
    assert row.errors["visual_error"] == 0.002


def test_best_rows_count_the_noisy_input_and_ties():
    rows = result_rows(NOISY, [outcome(), outcome("median")], "visual_error")
    assert best_rows(rows, "visual_error") == {1, 2}
    assert best_rows(rows, "vertex_rms") == {0}
    assert best_rows((), "vertex_rms") == frozenset()


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [
        (0.0021374, 4, "0.002137"),
        (0.0021, 4, "0.002100"),
        (12.0, 3, "12.0"),
        (1234.0, 4, "1234"),
        (0.0, 4, "0"),
        (None, 4, "–"),
        (0.000012345, 3, "1.23e-05"),
    ],
)
def test_significant_digits(value, digits, text):
    assert significant(value, digits) == text


@pytest.fixture
def rows():
    diverged = outcome("bilateral", visual_errors=(0.002, 0.0015, 7.0), diverged=3)
    return result_rows(NOISY, [outcome(), diverged], "visual_error")


def test_csv_holds_ids_and_all_digits(rows):
    lines = list(csv.DictReader(io.StringIO(as_csv(rows))))
    assert [line["method"] for line in lines] == ["noisy_input", "mean", "bilateral"]
    assert float(lines[1]["visual_error"]) == rows[1].errors["visual_error"]
    assert lines[0]["iteration"] == ""
    assert lines[2]["note"].startswith("diverged at iteration 3")


def test_text_columns_line_up_under_combining_signs(rows):
    # ℓ̄ is two signs and one column of a terminal.
    lines = as_text(rows).replace("\u0304", "").splitlines()
    gaps = [place for place, sign in enumerate(lines[1]) if sign == " "]
    assert len(gaps) == 2 * 8
    assert all(line[place : place + 1] in {" ", ""} for line in lines for place in gaps)
    assert lines[0].startswith("Method")
    assert "0.002000" in lines[2]


def test_markdown_has_one_line_a_row(rows):
    lines = as_markdown(rows).splitlines()
    assert len(lines) == 2 + len(rows)
    assert len({line.count("|") for line in lines}) == 1
    assert lines[1].startswith("| :-- | --: |")


def test_latex_has_no_bare_unicode(rows):
    text = as_latex(rows)
    assert text.isascii()
    assert r"$\bar{\ell}$\textsuperscript{2}" in text
    assert text.count("&") == 8 * (1 + len(rows))


@pytest.mark.parametrize(
    ("name", "beginning"),
    [("a.csv", "method,"), ("a.MD", "| Method"), ("a.tex", "\\begin"), ("a.txt", "Method")],
)
def test_saved_in_the_format_of_the_suffix(rows, tmp_path, name, beginning):
    save_table(tmp_path / name, rows)
    assert (tmp_path / name).read_text(encoding="utf-8").startswith(beginning)


def test_unknown_suffix_is_refused(rows, tmp_path):
    with pytest.raises(SaveError, match=r"a\.xls: tables are not written .* use \.csv"):
        save_table(tmp_path / "a.xls", rows)


def test_rows_of_a_study_agree_with_its_results(tmp_path):
    save_mesh(primitives.icosahedron(), tmp_path / "model.ply")
    choice = MethodChoice(method="mean", iterations=3)
    result = run(Study(model=str(tmp_path / "model.ply"), methods=(choice,)))
    noisy, row = study_rows(result)
    assert noisy.errors == result.comparison.noisy_errors
    assert row.errors["normal_angle"] == result.methods[0].errors["normal_angle"][3]
    assert (row.best_iteration, row.best_error) == result.methods[0].best("visual_error")
