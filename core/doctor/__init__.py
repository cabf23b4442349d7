"""The mesh doctor: what is wrong with a mesh, what that means, and repairs.

A new repair is one file with its `REPAIR`, and one line in :mod:`core.doctor.registry`.
"""

from core.doctor.examination import Report, examination_steps, examine
from core.doctor.registry import FINDINGS, REPAIRS, repair_for, repair_spec
from core.doctor.repairing import (
    RepairChoice,
    needed_repair_steps,
    needed_repairs,
    repair,
    repair_steps,
    repaired,
)
from core.doctor.spec import NOTHING, Finding, FindingSpec, Repaired, RepairError, RepairSpec

__all__ = [
    "FINDINGS",
    "NOTHING",
    "REPAIRS",
    "Finding",
    "FindingSpec",
    "RepairChoice",
    "RepairError",
    "RepairSpec",
    "Repaired",
    "Report",
    "examination_steps",
    "examine",
    "needed_repair_steps",
    "needed_repairs",
    "repair",
    "repair_for",
    "repair_spec",
    "repair_steps",
    "repaired",
]
