"""A random user: nothing breaks, whatever is done in whatever order.

``make monkey`` does ten thousand things instead of a few hundred. What failed is done again by
``python tests/gui/monkey/play.py --seed N --actions M``.
"""

import math
import os

import pytest

ACTIONS = int(os.environ.get("BURNISH_MONKEY_ACTIONS", "0"))
EACH = min(ACTIONS, 2500) or 60
SEEDS = math.ceil(ACTIONS / EACH) or 4
FIRST = int(os.environ.get("BURNISH_MONKEY_SEED", "1"))

# What is held depends on what was looked at: all tabs, figures, a window nearly as large as the
# screen. After 400 actions it hovers; a leak of every redraw would show as several hundred.
MEGABYTES = 100

# A second of the machine an action, and what starting takes: more is a hang.
SECONDS = 120 + 2 * EACH


@pytest.mark.parametrize("seed", range(FIRST, FIRST + SEEDS))
def test_nothing_breaks_whatever_is_done(outcome, growth, seed):
    report = outcome("play", SECONDS, seed=seed, actions=EACH)
    measured = report["measured"]
    assert report["done"] == EACH
    assert {each["threads"] for each in measured} == {measured[0]["threads"]}
    if len(measured) > 8:
        assert growth(measured, "handles") <= 4
        assert growth(measured, "megabytes") < MEGABYTES
