"""Looking a mesh over: what is wrong with it, what is worth knowing, what would repair it."""

from dataclasses import dataclass

import numpy as np

from core.doctor.boundary import loop_count
from core.doctor.pieces import component_sizes
from core.doctor.registry import FINDINGS, repair_for
from core.doctor.spec import Finding, FindingSpec
from core.mesh import TriangleMesh
from core.stepwise import Stepwise, carried_out


@dataclass(frozen=True, eq=False)
class Report:
    """What the doctor says of a mesh.

    Attributes
    ----------
    vertices, faces : int
        Numbers of the mesh.
    components : int
        Connected components that have faces.
    boundary_loops : int
        Closed boundaries; 0 for a closed surface.
    genus : int or None
        Genus, None where it is not defined.
    findings : tuple of Finding
        What was found, defects first.
    """

    vertices: int
    faces: int
    components: int
    boundary_loops: int
    genus: int | None
    findings: tuple[Finding, ...]

    @property
    def defects(self) -> tuple[Finding, ...]:
        """Findings that are wrong with the file."""
        return tuple(finding for finding in self.findings if finding.is_defect)

    @property
    def absent(self) -> tuple[FindingSpec, ...]:
        """What was looked for and not found."""
        return tuple(spec for spec in FINDINGS if not self.count(spec.id))

    @property
    def is_sound(self) -> bool:
        """Whether there is no defect."""
        return not self.defects

    def count(self, finding: str) -> int:
        """Return how many there are of a finding, by its id; 0 where there is none."""
        known = {each.spec.id: each.found.count for each in self.findings}
        return known.get(finding, 0)


def examine(mesh: TriangleMesh) -> Report:
    """Look a mesh over; nothing is changed.

    Every mesh that loads may be examined, and every method is defined on it: each finding's
    `spec.meaning` says what the methods do there. The cost is linear in the size of the mesh,
    apart from sorting and from patches for small holes.

    Parameters
    ----------
    mesh : TriangleMesh
        The mesh.

    Returns
    -------
    Report
        Counts, and the findings with the vertices at which they are.

    Examples
    --------
    >>> from core.mesh import primitives
    >>> examine(primitives.sphere(1)).findings
    ()
    """
    return carried_out(examination_steps(mesh))


def examination_steps(mesh: TriangleMesh) -> Stepwise[Report]:
    """Return what :func:`examine` does; whoever iterates may stop after any step."""
    findings = []
    for spec in FINDINGS:
        found = yield from spec.look(mesh)
        if found is not None:
            findings.append(Finding(spec, found, repair_for(spec)))
    return Report(
        vertices=len(mesh.vertices),
        faces=len(mesh.faces),
        components=int(np.count_nonzero(component_sizes(mesh))),
        boundary_loops=loop_count(mesh),
        genus=mesh.genus,
        findings=tuple(findings),
    )
