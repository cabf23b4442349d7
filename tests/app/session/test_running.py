"""The list of what runs."""

import pytest

from app.session.running import RunningTasks, Task, TaskState, together


class Clock:
    """A clock that is set by hand."""

    def __init__(self):
        self.now = 0.0

    def __call__(self):
        return self.now


@pytest.fixture
def clock():
    return Clock()


@pytest.fixture
def tasks(clock):
    return RunningTasks(clock)


def test_tasks_stand_in_the_order_in_which_they_began(tasks, clock):
    one, other = Task(title="Mean", share=lambda: 0.5), Task(title="Loading cow.ply")
    tasks.begin(one)
    clock.now = 2.0
    tasks.begin(other)
    clock.now = 3.0
    first, second = tasks.states()
    assert (first.title, first.share, first.seconds, first.task) == ("Mean", 0.5, 3.0, one)
    assert (second.title, second.share, second.seconds) == ("Loading cow.ply", None, 1.0)
    tasks.end(one)
    assert [state.task for state in tasks.states()] == [other]


def test_work_that_has_just_begun_can_be_left_out(tasks, clock):
    tasks.begin(Task(title="Quick"))
    clock.now = 0.2
    assert tasks.states(older_than=0.3) == ()
    clock.now = 0.4
    assert len(tasks.states(older_than=0.3)) == 1


def test_words_tell_how_far_and_how_long(tasks, clock):
    done = 0.0
    tasks.begin(Task(title="Mean", share=lambda: done))
    tasks.states()
    clock.now, done = 4.0, 0.25
    (state,) = tasks.states()
    assert state.words == "25 %, about 12 s left"


def test_words_of_work_without_a_share(tasks, clock):
    tasks.begin(Task(title="Loading"))
    assert tasks.states()[0].words == ""
    clock.now = 7.0
    assert tasks.states()[0].words == "7 s so far"


def test_cancelling_tells_the_task_once(tasks):
    told = []
    task = Task(title="Film", on_cancel=lambda: told.append("film"))
    tasks.begin(task)
    tasks.cancel(task)
    tasks.cancel_all()
    assert told == ["film"]
    assert tasks.states()[0].words == "stopping …"


def test_what_may_not_be_cancelled_goes_on(tasks):
    saving = Task(title="Saving", can_cancel=False)
    tasks.begin(saving)
    tasks.cancel_all()
    assert not saving.cancelled


def test_what_has_ended_cannot_be_cancelled(tasks):
    told = []
    task = Task(on_cancel=lambda: told.append(1))
    tasks.begin(task)
    tasks.end(task)
    tasks.cancel(task)
    assert not told


def test_a_task_may_end_when_it_is_cancelled(tasks):
    task = Task(on_cancel=lambda: tasks.end(task))
    tasks.begin(task)
    tasks.begin(Task())
    tasks.cancel_all()
    assert len(tasks.states()) == 1


def test_every_change_is_told(tasks):
    changes = []
    tasks.changed.connect(lambda: changes.append(1))
    task = Task()
    tasks.begin(task)
    tasks.cancel(task)
    tasks.end(task)
    tasks.end(task)
    assert len(changes) == 3


def test_several_are_summed_up():
    states = [
        TaskState("Mean", 0.2, 3.0, 12.0, stopping=False),
        TaskState("Median", 0.4, 2.0, 9.0, stopping=False),
        TaskState("Loading", None, 1.0, None, stopping=True),
    ]
    both = together(states)
    assert (both.title, both.share, both.seconds_left) == (
        "Mean and 2 more",
        pytest.approx(0.3),
        12,
    )
    assert not both.stopping
    assert together(states[:1]) is states[0]
