"""What each method did, in one shape for plots and tables, from the window or from a study."""

from dataclasses import dataclass

from app.scene.colours import method_colour
from app.session import Run, Session
from core.comparison import MethodResult, StudyResult
from core.smoothing import METHODS


@dataclass(frozen=True)
class Outcome:
    """One method's errors and times.

    Attributes
    ----------
    method : str
        Id of the method.
    iteration : int
        The iteration that is shown.
    errors : dict of str to tuple of float
        Each metric after 0 (the noisy input), 1, 2 … iterations.
    seconds_per_iteration : float or None
        Time of an iteration, None before the first.
    diverged : int or None
        The iteration at which the run diverged.
    """

    method: str
    iteration: int
    errors: dict[str, tuple[float, ...]]
    seconds_per_iteration: float | None
    diverged: int | None

    @property
    def title(self) -> str:
        """Name of the method as a person reads it."""
        return METHODS[self.method].title

    @property
    def colour(self) -> str:
        """Colour of the method."""
        return method_colour(self.method)

    def best(self, metric: str) -> tuple[int, float]:
        """Return the iteration (0 is the noisy input) with the smallest error, and that error."""
        values = self.errors[metric]
        error = min(values)
        return values.index(error), error


def study_outcomes(result: StudyResult) -> tuple[Outcome, ...]:
    """Return the outcome of each method of a finished study."""
    return tuple(_of_result(method) for method in result.methods)


def session_outcomes(session: Session) -> tuple[Outcome, ...]:
    """Return the outcome so far of each enabled method; none before the meshes are there."""
    enabled = [choice.method for choice in session.study.methods if choice.enabled]
    runs = [(method, session.run(method)) for method in enabled]
    return tuple(
        _of_run(method, run, session.shown_iteration(method)) for method, run in runs if run
    )


def _of_result(result: MethodResult) -> Outcome:
    seconds = result.seconds_per_iteration if result.seconds else None
    return Outcome(result.choice.method, result.iterations, result.errors, seconds, result.diverged)


def _of_run(method: str, run: Run, iteration: int) -> Outcome:
    errors = {metric: tuple(run.values(metric)) for metric in run.errors[0]}
    return Outcome(method, iteration, errors, run.seconds_per_iteration, run.diverged)
