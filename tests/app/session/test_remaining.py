"""The estimate of the time that is left."""

import pytest

from app.session.remaining import Remaining, in_words


def _estimate(shares, step=0.25):
    """Feed one share after the other, a step of time apart; return all estimates."""
    remaining = Remaining()
    return [remaining.update(share, k * step) for k, share in enumerate(shares)]


def test_steady_work_is_foretold():
    # A hundredth in each quarter of a second: 25 s in all.
    estimates = _estimate([k / 100 for k in range(101)])
    for k, left in enumerate(estimates[4:], 4):
        assert left == pytest.approx(25 - k / 4, abs=1e-9)


def test_nothing_is_said_in_the_first_second():
    estimates = _estimate([k / 100 for k in range(10)])
    assert estimates[:4] == [None] * 4
    assert estimates[4] is not None


def test_work_that_does_not_tell_how_far_it_is_has_no_estimate():
    assert _estimate([None] * 20) == [None] * 20


def test_between_steps_the_time_counts_down_to_nothing():
    # A fifth in two seconds, and then no news: 8 s, 7 s … 0 s.
    remaining = Remaining()
    remaining.update(0.0, 0.0)
    assert remaining.update(0.2, 2.0) == pytest.approx(8)
    assert remaining.update(0.2, 5.0) == pytest.approx(5)
    assert remaining.update(0.2, 30.0) == 0


def test_more_to_do_begins_anew():
    remaining = Remaining()
    for second in range(6):
        remaining.update(second / 10, float(second))
    assert remaining.update(0.1, 6.0) is None
    assert remaining.update(0.2, 8.0) == pytest.approx(16)


def test_work_that_has_got_slower_is_judged_by_its_later_half():
    remaining = Remaining()
    for second in range(11):
        remaining.update(second / 20, float(second))
    for second in range(11, 41):  # a tenth as fast
        left = remaining.update(0.5 + (second - 10) / 200, float(second))
    assert left == pytest.approx((1 - 0.65) * 200, rel=0.1)


def test_one_late_step_hardly_changes_it():
    remaining = Remaining()
    for second in range(21):
        left = remaining.update(second / 40, float(second))
    assert left == pytest.approx(20)
    assert 17 < remaining.update(21 / 40, 22.5) < 23


@pytest.mark.parametrize(
    ("seconds", "words"),
    [
        (0, "a moment left"),
        (1.6, "about 2 s left"),
        (12.3, "about 12 s left"),
        (33, "about 35 s left"),
        (57.4, "about 55 s left"),
        (57.6, "about 1 min left"),
        (150, "about 2 min left"),
        (3570, "about 1 h left"),
        (9000, "about 2 h left"),
    ],
)
def test_words(seconds, words):
    assert in_words(seconds) == words
