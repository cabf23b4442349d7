"""The results table, by mouse and keys."""

import csv
import io
from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication

from app.ui.results_table import ResultsTable

pytestmark = pytest.mark.gui

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def table(qtbot, session, shown):
    table = shown(ResultsTable(session), 480, 190)
    qtbot.waitUntil(lambda: table.model.rowCount() == 6, timeout=10_000)
    return table


def column(table, place):
    return [table.model.index(row, place).data() for row in range(table.model.rowCount())]


def cell_centre(table, row):
    return table.view.visualRect(table.model.index(row, 0)).center()


def test_rows_show_the_noisy_input_first(session, table):
    assert column(table, 0)[:2] == ["Noisy input", "Weighted Laplacian"]
    assert column(table, 1) == ["–", *5 * ["6"]]
    assert float(column(table, 2)[2]) == pytest.approx(
        session.run("mean").values("visual_error")[6], rel=0.005
    )


def test_best_value_of_a_metric_is_bold(table):
    for place in (2, 3, 4):
        values = [float(text) for text in column(table, place)]
        fonts = [
            table.model.index(row, place).data(Qt.ItemDataRole.FontRole)
            for row in range(len(values))
        ]
        assert [bool(font and font.bold()) for font in fonts].index(True) == values.index(
            min(values)
        )


def test_click_on_a_row_selects_its_method(qtbot, table):
    with qtbot.waitSignal(table.selected) as selected:
        qtbot.mouseClick(table.view.viewport(), LEFT, pos=cell_centre(table, 3))
    assert selected.args == ["median"]
    with qtbot.waitSignal(table.selected) as selected:
        qtbot.keyClick(table.view, Qt.Key.Key_Down)
    assert selected.args == ["bilateral"]


def test_set_selected_marks_the_row_without_a_signal(qtbot, table, change):
    with qtbot.assertNotEmitted(table.selected):
        table.set_selected("mean")
    assert [index.row() for index in table.view.selectionModel().selectedRows()] == [2]
    change("laplacian", enabled=True)
    qtbot.waitUntil(lambda: table.model.rowCount() == 7)
    assert [index.row() for index in table.view.selectionModel().selectedRows()] == [2]
    table.set_selected(None)
    assert table.view.selectionModel().selectedRows() == []


def test_table_follows_the_sliders(qtbot, table, change):
    change("mean", iterations=2)
    qtbot.waitUntil(lambda: column(table, 1)[2] == "2")


def test_divergence_is_noted(qtbot, table, change, diverging):
    change("diffusion", params=diverging)
    qtbot.waitUntil(
        lambda: any("diverged at iteration" in text for text in column(table, 8)), timeout=10_000
    )


def test_copy_by_key_and_menu(qtbot, table):
    table.view.setFocus()
    qtbot.keyClick(table.view, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    clipboard = QGuiApplication.clipboard()
    assert clipboard.text().startswith("Method")
    menu = {action.text(): action for action in table.view.actions()}
    menu["Copy as CSV"].trigger()
    assert len(list(csv.reader(io.StringIO(clipboard.text())))) == 7
    menu["Copy as LaTeX"].trigger()
    assert clipboard.text().startswith("\\begin{tabular}")


def test_saved_table_can_be_read(table, tmp_path):
    table.writer()(tmp_path / "table.csv")
    lines = (tmp_path / "table.csv").read_text(encoding="utf-8").splitlines()
    assert [line.split(",")[0] for line in lines[1:3]] == ["noisy_input", "weighted_laplacian"]


@pytest.mark.parametrize("width", [420, 480, 800])
def test_columns_fill_the_table_and_need_no_scroll_bar(qtbot, table, width):
    table.resize(width, 190)
    qtbot.waitUntil(lambda: table.view.width() == width)
    columns = table.view.horizontalHeader()
    assert columns.length() == table.view.viewport().width()
    for place in range(1, 8):
        needed = max(table.view.sizeHintForColumn(place), columns.sectionSizeHint(place))
        assert columns.sectionSize(place) >= needed


def test_names_that_do_not_fit_beside_large_numbers_get_more_lines(qtbot, table):
    view, columns = table.view, table.view.horizontalHeader()
    one_line = view.rowHeight(0)
    assert all(view.rowHeight(row) == one_line for row in range(6))
    rows = table.model.rows
    wild = dict.fromkeys(rows[1].errors, 1.23e15)
    note = "worse than the noisy input"  # which its icon stands for: it needs no lines
    noted = [
        replace(row, errors=wild, best_error=1.23e15, milliseconds=123.4, note=note)
        for row in rows[1:]
    ]
    table.model.show((rows[0], *noted))
    view.fit_columns()
    assert view.sizeHintForColumn(0) > columns.sectionSize(0)
    metrics = view.fontMetrics()
    room = columns.sectionSize(0) - view.iconSize().width() - 14
    for row, data in enumerate(table.model.rows):
        assert all(metrics.horizontalAdvance(word) <= room for word in data.title.split())
        assert 2 * metrics.height() <= view.rowHeight(row) == view.rowHeight(0) < 4 * one_line
    table.model.show(rows)
    view.fit_columns()
    assert view.rowHeight(1) == one_line
