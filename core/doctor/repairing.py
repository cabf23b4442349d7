"""Doing repairs, one after the other."""

from collections.abc import Iterable

import numpy as np

from core.doctor.registry import REPAIRS, repair_spec
from core.doctor.spec import NOTHING, Repaired
from core.mesh import TriangleMesh
from core.parameters import Params, build_params, param
from core.stepwise import Stepwise, carried_out


class RepairChoice(Params):
    """One repair of a study, with its parameters."""

    repair: str = param(..., help="Id of a repair.")
    params: dict[str, float | int | bool | str | None] = param(
        {}, help="Parameters that differ from their declared defaults."
    )

    @property
    def settings(self) -> Params:
        """The validated parameters of the repair."""
        settings: Params = build_params(repair_spec(self.repair).params, self.params, self.repair)
        return settings


def repair(mesh: TriangleMesh, repair: str, **params: float) -> Repaired:
    """Repair a mesh in one way.

    Parameters
    ----------
    mesh : TriangleMesh
        The mesh; it is not changed.
    repair : str
        Id of a repair in :data:`REPAIRS`.
    **params
        Parameters of the repair; those not given take their declared defaults.

    Returns
    -------
    Repaired
        The repaired mesh, the vertex that each of its vertices comes from, and one sentence
        that says what was changed.

    Raises
    ------
    ParameterError
        If the repair or a parameter is not allowed.
    RepairError
        If no face would be left.

    Examples
    --------
    >>> twice = TriangleMesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2], [1, 2, 0]])
    >>> repair(twice, "duplicate_faces").changes
    ('Removed 1 face that lay on others.',)
    """
    return repaired(mesh, [RepairChoice(repair=repair, params=params)])


def repaired(mesh: TriangleMesh, choices: Iterable[RepairChoice]) -> Repaired:
    """Do repairs one after the other; `changes` of the result has one sentence for each."""
    return carried_out(repair_steps(mesh, choices))


def repair_steps(mesh: TriangleMesh, choices: Iterable[RepairChoice]) -> Stepwise[Repaired]:
    """Return what :func:`repaired` does; whoever iterates may stop after any step."""
    result = Repaired(mesh, np.arange(len(mesh.vertices)))
    for choice in choices:
        step = yield from repair_spec(choice.repair).apply(result.mesh, choice.settings)
        sources = result.sources[step.sources]
        result = Repaired(step.mesh, sources, result.changes + step.changes)
    return result


def needed_repairs(mesh: TriangleMesh) -> tuple[RepairChoice, ...]:
    """Return the repairs that remove every defect and keep the shape, in their order.

    Those that change the shape (filling holes, removing components) are left to the person.
    """
    return carried_out(needed_repair_steps(mesh))


def needed_repair_steps(mesh: TriangleMesh) -> Stepwise[tuple[RepairChoice, ...]]:
    """Return what :func:`needed_repairs` does; whoever iterates may stop after any step."""
    chosen = []
    for spec in REPAIRS.values():
        if not spec.keeps_shape:
            continue
        step = yield from spec.apply(mesh, spec.params())
        if step.changes != (NOTHING,):
            mesh = step.mesh
            chosen.append(RepairChoice(repair=spec.id))
    return tuple(chosen)
