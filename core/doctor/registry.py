"""All repairs and findings, listed in display order."""

from core.doctor import (
    degenerate,
    duplicates,
    holes,
    pieces,
    seams,
    splitting,
    unreferenced,
    winding,
)
from core.doctor.spec import FindingSpec, RepairSpec
from core.parameters import ParameterError

REPAIRS: dict[str, RepairSpec] = {
    spec.id: spec
    for spec in (
        degenerate.REPAIR,
        duplicates.REPAIR,
        seams.REPAIR,
        splitting.REPAIR,
        winding.REPAIR,
        unreferenced.REPAIR,
        pieces.REPAIR,
        holes.REPAIR,
    )
}
"""All repairs by id, in the order in which they are shown and done."""

FINDINGS: tuple[FindingSpec, ...] = (
    *(spec for repair in REPAIRS.values() for spec in (*repair.removes, *repair.eases)),
    seams.TOUCHING,
    winding.ONE_SIDED,
)
"""All that the doctor looks for: what a repair declares, and what none can mend."""


def repair_spec(repair: str) -> RepairSpec:
    """Look up a repair by its id.

    Raises
    ------
    ParameterError
        If there is no such repair; names all that there are.
    """
    if repair not in REPAIRS:
        raise ParameterError(f"{repair} is not a repair; allowed: {', '.join(REPAIRS)}.")
    return REPAIRS[repair]


def repair_for(finding: FindingSpec) -> str:
    """Id of the repair that removes or eases a finding; empty where there is none."""
    specs = REPAIRS.values()
    return next((spec.id for spec in specs if finding in (*spec.removes, *spec.eases)), "")
