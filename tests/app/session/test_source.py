"""The worker's end of a run, where iterations come in parts."""

from types import SimpleNamespace

from app.session.runs import Source


def test_what_was_left_within_an_iteration_goes_on_there():
    one, two = SimpleNamespace(iteration=1), SimpleNamespace(iteration=2)
    source = Source(iter([None, one, None, two]))
    first = source.advance(lambda: 1)
    assert next(first) is None
    first.close()
    assert list(source.advance(lambda: 2)) == [one, None, two]
