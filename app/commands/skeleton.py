"""``burnish skeleton``: the skeletal graph of a model."""

import json
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from app.usage import UsageError, say


def skeleton(
    model: str,
    /,
    *,
    field: str = "mixture",
    resolution: str = "22",
    bands: str = "exact",
    spacing: str = "value",
    root: bool = False,
    set_: Annotated[list[str] | None, Parameter(name="--set")] = None,
    output: Annotated[Path | None, Parameter(name=["-o", "--output"])] = None,
    json_: Annotated[bool, Parameter(name="--json", negative="")] = False,
) -> None:
    """Draw the skeletal graph of a model and count its nodes, arcs and loops.

    Parameters
    ----------
    model
        Path of the model, or sample:ID for a bundled one.
    field
        Id of the field: mixture, euclidean, affine or height.
    resolution
        Number of bands R, 1 to 64, or auto.
    bands
        exact cuts the faces at the levels; vertices is the printed algorithm.
    spacing
        Levels at equal steps of the value, of the distance, or of the area.
    root
        Join the centroid to the nodes of the first band.
    set_
        Parameter of the field as parameter=value; may be given several times.
    output
        File for the graph (.graphml, .json, .obj, .csv, .swc) or for a picture (.png).
    json_
        Print one JSON object instead of the text.
    """
    from app.export.skeleton_report import (
        check_output,
        draw_skeleton,
        read_surface,
        skeleton_json,
        skeleton_text,
        write_skeleton,
    )
    from core.fields import field_spec
    from core.parameters import build_params
    from core.study import SkeletonView

    automatic = resolution == "auto"
    settings = build_params(field_spec(field).params, _field_settings(set_ or []), field)
    words = {"field": field, "bands": bands, "spacing": spacing, "root": root}
    count = {} if automatic else {"resolution": resolution}
    params = settings.model_dump(exclude_defaults=True)
    view = build_params(SkeletonView, {**words, **count, "params": params})
    if output is not None:
        check_output(output)
    drawn, seconds = draw_skeleton(read_surface(model), view, automatic=automatic)
    if output is not None:
        write_skeleton(drawn, output)
    report = skeleton_json if json_ else skeleton_text
    made = report(drawn, seconds)
    say(json.dumps(made) if json_ else str(made))


def _field_settings(settings: list[str]) -> dict[str, str]:
    values = {}
    for setting in settings:
        name, equals, value = setting.partition("=")
        if not (equals and name):
            raise UsageError(f"--set {setting} is not of the form parameter=value.")
        values[name] = value
    return values
