"""What the mesh doctor says of a model, for a terminal and as JSON."""

from dataclasses import dataclass
from typing import Any

from core.doctor import Finding, RepairChoice, Report


@dataclass(frozen=True, eq=False)
class Visit:
    """A model at the doctor's.

    Attributes
    ----------
    name : str
        The model.
    loading : tuple of str
        What loading changed.
    before, after : Report
        Before and after the repairs.
    repairs : tuple of RepairChoice
        What was done, in order.
    changes : tuple of str
        What each repair changed.
    """

    name: str
    loading: tuple[str, ...]
    before: Report
    repairs: tuple[RepairChoice, ...]
    changes: tuple[str, ...]
    after: Report


def visit_json(visit: Visit) -> dict[str, Any]:
    """Describe a visit as one JSON object."""
    done = zip(visit.repairs, visit.changes, strict=True)
    return {
        "model": visit.name,
        "loading": list(visit.loading),
        **_report_json(visit.before),
        "repairs": [{**choice.model_dump(), "change": change} for choice, change in done],
        "after": _report_json(visit.after),
    }


def _report_json(report: Report) -> dict[str, Any]:
    return {
        "vertices": report.vertices,
        "faces": report.faces,
        "components": report.components,
        "boundary_loops": report.boundary_loops,
        "genus": report.genus,
        "sound": report.is_sound,
        "findings": [_finding_json(finding) for finding in report.findings],
    }


def _finding_json(finding: Finding) -> dict[str, Any]:
    return {
        "id": finding.spec.id,
        "level": finding.spec.level,
        "count": finding.found.count,
        "text": finding.found.text,
        "meaning": finding.spec.meaning,
        "repair": finding.repair or None,
        "vertices": finding.found.vertices.tolist(),
    }


def visit_text(visit: Visit) -> str:
    """Describe a visit for a terminal."""
    lines = [f"{visit.name}: {headline(visit.before)}"]
    lines += [f"When loading: {change}." for change in visit.loading]
    lines += _findings_text(visit.before)
    if visit.repairs:
        lines += ["", *visit.changes, f"Now: {headline(visit.after)}"]
        lines += _findings_text(visit.after)
    return "\n".join(lines)


def headline(report: Report) -> str:
    """Sum up a report in one line."""
    closed = "closed" if not report.boundary_loops else _plural(report.boundary_loops, "boundary")
    counts = f"{report.vertices:,} vertices, {report.faces:,} faces"
    parts = [counts, _plural(report.components, "component"), closed]
    parts += [] if report.genus is None else [f"genus {report.genus}"]
    return ", ".join(parts)


def _plural(count: int, word: str) -> str:
    many = word[:-1] + "ies" if word.endswith("y") else word + "s"
    return f"{count:,} {word if count == 1 else many}"


def _findings_text(report: Report) -> list[str]:
    if not report.findings:
        return ["Nothing is wrong with it."]
    return [line for finding in report.findings for line in _finding_lines(finding)]


def _finding_lines(finding: Finding) -> list[str]:
    way = f"  [--repair {finding.repair}]" if finding.repair else ""
    mark = "!" if finding.is_defect else "·"
    return [f"{mark} {finding.found.text}{way}", f"    {finding.spec.meaning}"]
