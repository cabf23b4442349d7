"""The numbers beside the statistics plots."""

from app.ui.statistics_side import StatisticsSide
from core.mesh import primitives
from core.statistics.summary import summarise


def test_numbers_that_stay_the_same_keep_their_labels(shown):
    side = shown(StatisticsSide(), 280, 650)
    side.show_summaries([summarise(primitives.sphere(1))])
    label = side._summary.itemAt(1).widget()
    assert label.text() == "42"
    side.show_summaries([summarise(primitives.sphere(1))])
    assert side._summary.itemAt(1).widget() is label
    side.show_summaries([summarise(primitives.sphere(2))])
    assert side._summary.itemAt(1).widget().text() == "162"
    side.show_summaries([])
    assert side._summary.count() == 0
