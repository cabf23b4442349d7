"""The same work over and over: what the process holds does not grow.

``BURNISH_SOAK_MINUTES=60`` works for an hour instead of a few rounds.
"""

import os

MINUTES = float(os.environ.get("BURNISH_SOAK_MINUTES", "0"))

# Between rounds the resident size swings by 5 MB, and undo steps add 3 MB until 200 are kept; one
# redraw that leaks a pane's mesh loses ten times as much within minutes.
MEGABYTES = 30


def test_memory_and_handles_do_not_grow_with_work(outcome, growth):
    report = outcome("soak", 300 + 120 * MINUTES, minutes=MINUTES)
    measured = report["measured"]
    assert {each["threads"] for each in measured} == {measured[0]["threads"]}
    assert growth(measured, "handles") <= 1
    assert growth(measured, "qobjects") <= 5
    assert growth(measured, "vtk") == 0
    assert growth(measured, "megabytes") < MEGABYTES
