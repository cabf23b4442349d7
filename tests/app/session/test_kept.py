"""Values that are kept as far as number and memory allow."""

from app.session.kept import Kept


def numbers(*keys, limit=10, budget=1000):
    """Get the keys in turn, each a value of its own size; return what had to be made."""
    made = []
    kept = Kept(limit, weigh=lambda value: value, budget=lambda: budget)
    for key in keys:
        kept.get(key, lambda key=key: made.append(key) or key)
    return made


def test_what_is_there_is_not_made_again():
    assert numbers(1, 2, 1, 2) == [1, 2]


def test_the_least_recently_used_goes_first():
    assert numbers(1, 2, 1, 3, 1, 2, limit=2) == [1, 2, 3, 2]


def test_memory_limits_the_number():
    assert numbers(40, 50, 60, 50, 40, budget=100) == [40, 50, 60, 50, 40]
    assert numbers(40, 50, 40, 50, budget=100) == [40, 50]


def test_the_newest_stays_whatever_it_takes():
    assert numbers(500, 500, budget=100) == [500]
