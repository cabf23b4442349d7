"""A statistic that a model does not have: said under its plot, and the others are there."""

from PySide6.QtCore import Qt

from core.statistics import Progress, StatisticsError

REASON = "The eigenvalues do not converge."


def test_a_refused_spectrum_leaves_the_other_plots(user, ball_file, monkeypatch):
    def refuse(*_):
        yield Progress(None, 0.0)
        raise StatisticsError(REASON)

    reports = []
    tab = user.window.statistics
    monkeypatch.setattr("app.ui.statistics_work.spectrum_steps", refuse)
    monkeypatch.setattr(tab.work, "_report", reports.append)
    user.open(ball_file)
    user.press(Qt.Key.Key_3, Qt.KeyboardModifier.ControlModifier)
    user.wait(lambda: REASON in tab.plots["spectrum"].words.text())
    user.wait(lambda: tab.work.series()[0].geodesic is not None)
    assert [str(error) for error in reports] == [REASON]
    assert REASON not in tab.plots["geodesic"].words.text()
