"""Carrying out a study: reading its meshes, running its methods, measuring their errors.

A :class:`Comparison` is the pair of meshes that a study works on; :func:`run` does the whole of
it. Methods and metrics work in numbers that follow the surface, because on a large mesh whose
file numbers its vertices otherwise they take several times as long; what is handed out is in the
order of the file.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from core.arrays import FloatArray
from core.doctor import repaired
from core.file_order import FileOrderEvaluator, file_order_evaluator
from core.mesh import TriangleMesh
from core.metrics import metrics_in
from core.models import matched, read_model
from core.noise import add_noise
from core.smoothing import DivergenceError
from core.snapshots import Snapshot, iterations, measured
from core.study import MethodChoice, Study


@dataclass(frozen=True, eq=False)
class Comparison:
    """An original and its noisy version, with the metrics prepared.

    Parameters
    ----------
    original, noisy : TriangleMesh
        Meshes with the same topology.
    model_units : bool
        Errors in the file's own units and origin instead of mean edge lengths.
    """

    original: TriangleMesh
    noisy: TriangleMesh
    model_units: bool = False

    @cached_property
    def evaluators(self) -> dict[str, FileOrderEvaluator]:
        """Evaluator of each metric against the original."""
        specs = metrics_in(model_units=self.model_units)
        return {id_: file_order_evaluator(spec, self.original) for id_, spec in specs.items()}

    @cached_property
    def noisy_errors(self) -> dict[str, float]:
        """Each metric of the noisy mesh itself: what a method must beat."""
        return self.errors(self.noisy.vertices)

    def errors(self, vertices: FloatArray) -> dict[str, float]:
        """Return each metric of a mesh with these positions."""
        return {id_: evaluator.value(vertices) for id_, evaluator in self.evaluators.items()}

    def snapshots(
        self, choice: MethodChoice, wanted: Callable[[], int] | None = None
    ) -> Iterator[Snapshot | None]:
        """Yield the state after iteration 1, 2, 3 …, without end; None while there is none yet.

        Parameters
        ----------
        choice : MethodChoice
            Method and parameters.
        wanted : callable
            Returns the iteration that is to be reached, where that may change; no snapshot waits
            for one beyond it.

        Raises
        ------
        DivergenceError
            When the run diverges; the snapshot before is the last good one.
        """
        evaluators = {id_: e.along_surface for id_, e in self.evaluators.items()}
        return measured(
            iterations(self.noisy, choice), evaluators, wanted or (lambda: choice.iterations)
        )


@dataclass(frozen=True, eq=False)
class MethodResult:
    """What a method did in a study.

    Attributes
    ----------
    choice : MethodChoice
        What was asked for.
    errors : dict of str to tuple of float
        Each metric after 0 (the noisy input), 1, 2 … iterations.
    seconds : tuple of float
        Time of each iteration.
    diverged : int or None
        The iteration at which the run diverged.
    mesh : TriangleMesh
        The last good mesh.
    """

    choice: MethodChoice
    errors: dict[str, tuple[float, ...]]
    seconds: tuple[float, ...]
    diverged: int | None
    mesh: TriangleMesh

    @property
    def iterations(self) -> int:
        """Number of good iterations."""
        return len(self.seconds)

    @property
    def seconds_per_iteration(self) -> float:
        """Median time of an iteration; 0 where there is none."""
        return float(np.median(self.seconds)) if self.seconds else 0.0

    def best(self, metric: str) -> tuple[int, float]:
        """Return the iteration (0 is the noisy input) with the smallest error, and that error."""
        values = self.errors[metric]
        iteration = int(np.argmin(values))
        return iteration, values[iteration]


@dataclass(frozen=True, eq=False)
class StudyResult:
    """Meshes and numbers of a finished study."""

    study: Study
    comparison: Comparison
    report: tuple[str, ...]
    methods: tuple[MethodResult, ...]


def read_comparison(study: Study) -> tuple[Comparison, tuple[str, ...]]:
    """Read the meshes of a study, repair them, add the noise; also returns what was changed.

    Raises
    ------
    LoadError
        If a file cannot be read.
    ParameterError
        If the noisy file does not belong to the original.
    """
    loaded = read_model(study.model)
    whole = repaired(loaded.mesh, study.repairs)
    if study.noisy is None:
        noisy = add_noise(whole.mesh, study.noise.sigma, study.noise.seed)
    else:
        noisy = whole.carry(matched(loaded.mesh, read_model(study.noisy)))
    return Comparison(whole.mesh, noisy, study.model_units), loaded.report + whole.changes


def run_method(comparison: Comparison, choice: MethodChoice) -> MethodResult:
    """Run one method to the chosen iteration or until it diverges."""
    errors: dict[str, list[float]] = {id_: [e] for id_, e in comparison.noisy_errors.items()}
    seconds: list[float] = []
    snapshot = None
    diverged = None
    snapshots = (snapshot for snapshot in comparison.snapshots(choice) if snapshot is not None)
    try:
        for _ in range(choice.iterations):
            snapshot = next(snapshots)
            seconds.append(snapshot.seconds)
            for id_, error in snapshot.errors.items():
                errors[id_].append(error)
    except DivergenceError as error:
        diverged = error.iteration
    noisy = comparison.noisy
    return MethodResult(
        choice=choice,
        errors={id_: tuple(values) for id_, values in errors.items()},
        seconds=tuple(seconds),
        diverged=diverged,
        mesh=noisy.with_vertices(snapshot.vertices) if snapshot else noisy,
    )


def run(study: Study) -> StudyResult:
    """Carry out a study: read the model, add the noise, run every enabled method.

    Parameters
    ----------
    study : Study
        The description.

    Returns
    -------
    StudyResult
        Meshes, errors after every iteration, times, and where a method diverged. A method that
        diverges does not disturb the others.

    Raises
    ------
    LoadError
        If a file cannot be read.
    ParameterError
        If a parameter is not allowed or the noisy file does not belong to the original.
    """
    comparison, report = read_comparison(study)
    results = tuple(run_method(comparison, choice) for choice in study.methods if choice.enabled)
    return StudyResult(study, comparison, report, results)
