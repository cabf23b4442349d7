"""Command line: ``burnish MODEL`` opens the window, the other commands need neither Qt nor display.

Nothing heavy is imported before a command runs, so that ``burnish --help`` answers at once.
"""

import json
import os
import sys
from pathlib import Path
from typing import Annotated, Literal

from cyclopts import App, CycloptsError, Parameter

from app.usage import UsageError

app = App(
    name="burnish",
    help="Compare mesh denoisers side by side and look at the skeleton of a shape.",
    version_flags=["--version"],
)

DEFAULT_MODEL = "sample:creature"
_HEADLESS_FOLDER = Path("out")


def main(arguments: list[str] | None = None) -> None:
    """Run a command; bad input ends it with status 2 and one line on standard error."""
    try:
        status = app(arguments, exit_on_error=False, print_error=False)
    except (CycloptsError, ValueError, OSError) as error:
        print(f"burnish: {_one_line(error)}", file=sys.stderr)  # noqa: T201
        sys.exit(2)
    sys.exit(status or 0)


@app.default
def window(model: str = DEFAULT_MODEL, /) -> int:
    """Open the window on a model or a study; with no display, write the comparison into out/.

    Parameters
    ----------
    model
        Path of a model or a .burnish study, or sample:ID for a bundled model.
    """
    if _has_display():
        from app.ui.application import start

        return start(model)
    _say(f"There is no display; the comparison goes into {_HEADLESS_FOLDER}/ instead.")
    if model.lower().endswith(".burnish"):
        compare(study=Path(model), output=_HEADLESS_FOLDER)
    else:
        compare(model, output=_HEADLESS_FOLDER)
    return 0


@app.command
def compare(
    model: str | None = None,
    /,
    *,
    study: Path | None = None,
    noisy: str | None = None,
    sigma: float | None = None,
    seed: int | None = None,
    methods: str | None = None,
    iterations: int | None = None,
    set_: Annotated[list[str] | None, Parameter(name="--set")] = None,
    model_units: Annotated[bool, Parameter(negative="")] = False,
    output: Annotated[Path | None, Parameter(name=["-o", "--output"])] = None,
    json_: Annotated[bool, Parameter(name="--json", negative="")] = False,
) -> None:
    """Add noise to a model, run the methods, and report their errors.

    Parameters
    ----------
    model
        Path of the original, or sample:ID for a bundled one; with --study it replaces the study's.
    study
        Study file to carry out; the other options change what they name.
    noisy
        Separate noisy file of the same model; then no noise is added.
    sigma
        Standard deviation of the noise in mean edge lengths, 0 to 1; 0.02 if not given.
    seed
        Seed of the noise; 0 if not given.
    methods
        Ids of the methods, separated by commas; the thesis' five if not given.
    iterations
        Iterations of every method; 6 if not given. For one method: --set id.iterations=N.
    set_
        Parameter of a method as id.parameter=value; may be given several times.
    model_units
        Errors in the file's own units and origin instead of mean edge lengths.
    output
        Folder for pictures, plot, table and meshes.
    json_
        Print one JSON object instead of the table.
    """
    from app.export.reports import comparison_json, comparison_text
    from app.study_words import study_of_words
    from core.comparison import run

    result = run(
        study_of_words(
            model, file=study, noisy=noisy, noise={"sigma": sigma, "seed": seed}, methods=methods,
            iterations=iterations, settings=set_ or [], model_units=model_units,
        )
    )  # fmt: skip
    if output is not None:
        from app.export.bundle import write_comparison

        write_comparison(result, output)
    _say(json.dumps(comparison_json(result)) if json_ else comparison_text(result))


@app.command
def study(
    file: Path,
    /,
    *,
    as_: Annotated[Literal["command", "python"], Parameter(name="--as")] = "command",
) -> None:
    """Show a study as the command line or the Python script that gives the same numbers.

    Parameters
    ----------
    file
        Study file.
    as_
        What to show.
    """
    from app.export.study_script import script_of
    from app.study_words import command_of, study_of_words

    shown = study_of_words(None, file=file)
    _say((command_of if as_ == "command" else script_of)(shown))


@app.command
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
    _say(json.dumps(made) if json_ else str(made))


@app.command
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
    from core.comparison import read_model
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
    _say(json.dumps(described) if json_ else str(described))


@app.command
def methods(*, json_: Annotated[bool, Parameter(name="--json", negative="")] = False) -> None:
    """List every method with its parameters.

    Parameters
    ----------
    json_
        Print one JSON object instead of the list.
    """
    from app.export.reports import methods_json, methods_text

    _say(json.dumps(methods_json()) if json_ else methods_text())


def _field_settings(settings: list[str]) -> dict[str, str]:
    values = {}
    for setting in settings:
        name, equals, value = setting.partition("=")
        if not (equals and name):
            raise UsageError(f"--set {setting} is not of the form parameter=value.")
        values[name] = value
    return values


def _has_display() -> bool:
    """Whether a window can open: always on macOS and Windows, else with X or Wayland."""
    if sys.platform in {"darwin", "win32"}:
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def _one_line(error: Exception) -> str:
    return " ".join(str(error).split()) or type(error).__name__


def _say(text: str) -> None:
    print(text)  # noqa: T201
