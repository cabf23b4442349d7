"""``burnish stats``: the statistics of a model."""

import json
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from app.usage import UsageError, say


def stats(
    model: str,
    /,
    *,
    along: str = "neighbours",
    neighbours: int = 8,
    sources: int = 200,
    seed: int = 0,
    matrices: Annotated[bool, Parameter(negative="")] = False,
    output: Annotated[Path | None, Parameter(name=["-o", "--output"])] = None,
    json_: Annotated[bool, Parameter(name="--json", negative="")] = False,
) -> None:
    """Report the statistics of a model: degrees, clustering, spectra, geodesic distances.

    Parameters
    ----------
    model
        Path of a model, or sample:ID for a bundled one.
    along
        Paths of the geodesic distances: neighbours, edges or surface.
    neighbours
        Nearest neighbours of a vertex in the graph that paths follow.
    sources
        Random vertices that distances are taken from.
    seed
        Seed of the random vertices.
    matrices
        Write the matrices of the mesh too, as Matrix Market and NPZ.
    output
        Folder for figure, plots and tables.
    json_
        Print one JSON object instead of the text.
    """
    from app.export.statistics_reports import statistics_json, statistics_text
    from core.models import read_model
    from core.parameters import build_params
    from core.statistics import GeodesicParams, mesh_statistics

    words = {"along": along, "neighbours": neighbours, "sources": sources, "seed": seed}
    params = build_params(GeodesicParams, words, "geodesic")
    if matrices and output is None:
        raise UsageError("--matrices needs a folder to write to: add -o FOLDER.")
    loaded = read_model(model)
    statistics = mesh_statistics(loaded.mesh, params)
    if output is not None:
        from app.export.statistics_bundle import write_statistics

        write_statistics(loaded.name, loaded.mesh, statistics, output, matrices=matrices)
    describe = statistics_json if json_ else statistics_text
    described = describe(loaded.name, statistics)
    say(json.dumps(described) if json_ else str(described))
