"""``burnish doctor``: what is wrong with a model, and repairs."""

import json
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from app.usage import say


def doctor(
    model: str,
    /,
    *,
    repair: str | None = None,
    output: Annotated[Path | None, Parameter(name=["-o", "--output"])] = None,
    json_: Annotated[bool, Parameter(name="--json", negative="")] = False,
) -> None:
    """Look a model over, say what is wrong with it, and repair it.

    Parameters
    ----------
    model
        Path of a model, or sample:ID for a bundled one.
    repair
        Ids of repairs, separated by commas, done in that order; all stands for those that remove
        every defect and keep the shape. A parameter after a colon: fill_holes:most_edges=60.
    output
        File for the repaired model, PLY, OBJ, OFF or STL.
    json_
        Print one JSON object instead of the text.
    """
    from app.export.doctor_reports import Visit, visit_json, visit_text
    from app.repair_words import repairs_of
    from core.doctor import examine, repaired
    from core.io import save_mesh
    from core.models import read_model

    loaded = read_model(model)
    before = examine(loaded.mesh)
    choices = repairs_of(repair or "", lambda: loaded.mesh)
    result = repaired(loaded.mesh, choices)
    if output is not None:
        save_mesh(result.mesh, output)
    after = examine(result.mesh) if choices else before
    visit = Visit(model, loaded.report, before, choices, result.changes, after)
    say(json.dumps(visit_json(visit)) if json_ else visit_text(visit))
