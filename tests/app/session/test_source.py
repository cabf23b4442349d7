"""The worker's end of a run, where iterations come in parts."""

from types import SimpleNamespace

from app.session.runs import Source


def test_what_was_left_within_an_iteration_goes_on_there():
    one, two = SimpleNamespace(iteration=1), SimpleNamespace(iteration=2)
    source = Source(lambda wanted: iter([None, one, None, two]))
    first = source.advance(lambda: 1)
    assert next(first) is None
    first.close()
    assert list(source.advance(lambda: 2)) == [one, None, two]


def test_a_run_is_told_how_far_it_is_to_go():
    def snapshots(wanted):
        while True:
            yield SimpleNamespace(iteration=wanted())

    source = Source(snapshots)
    assert [step.iteration for step in source.advance(lambda: 3)] == [3]
    assert [step.iteration for step in source.advance(lambda: 5)] == [5]
