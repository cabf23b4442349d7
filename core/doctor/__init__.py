"""The mesh doctor: what is wrong with a mesh, what that means, and repairs.

A new repair is one file with its `REPAIR`, and one line in :mod:`core.doctor.registry`.
"""

from core.doctor.examination import Report, examine
from core.doctor.registry import FINDINGS, REPAIRS, repair_for, repair_spec
from core.doctor.repairing import RepairChoice, needed_repairs, repair, repaired
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
    "examine",
    "needed_repairs",
    "repair",
    "repair_for",
    "repair_spec",
    "repaired",
]
