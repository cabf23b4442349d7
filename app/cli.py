"""Command line: ``burnish MODEL`` opens the window, the other commands need neither Qt nor display.

Nothing heavy is imported before a command runs, so that ``burnish --help`` answers at once.
"""

import json
import os
import sys
from pathlib import Path
from typing import Annotated, Any

from cyclopts import App, CycloptsError, Parameter

app = App(
    name="burnish",
    help="Compare mesh denoisers side by side and look at the skeleton of a shape.",
    version_flags=["--version"],
)

DEFAULT_MODEL = "sample:creature"
_HEADLESS_FOLDER = Path("out")


class UsageError(ValueError):
    """Raised when the words of a command do not fit; one sentence says how."""


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
    """Open the window on a model; with no display, write the comparison into out/.

    Parameters
    ----------
    model
        Path of a model, or sample:ID for a bundled one.
    """
    if _has_display():
        from app.ui.application import start

        return start(model)
    _say(f"There is no display; the comparison goes into {_HEADLESS_FOLDER}/ instead.")
    compare(model, output=_HEADLESS_FOLDER)
    return 0


@app.command
def compare(
    model: str,
    /,
    *,
    noisy: str | None = None,
    sigma: float = 0.02,
    seed: int = 0,
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
        Path of the original, or sample:ID for a bundled one.
    noisy
        Separate noisy file of the same model; then no noise is added.
    sigma
        Standard deviation of the noise in mean edge lengths, 0 to 1.
    seed
        Seed of the noise.
    methods
        Ids of the methods, separated by commas; the thesis' five if not given.
    iterations
        Iterations of every method.
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
    from core.comparison import run
    from core.noise import NoiseParams
    from core.parameters import build_params
    from core.study import Study

    study = Study(
        model=model,
        noisy=noisy,
        noise=build_params(NoiseParams, {"sigma": sigma, "seed": seed}, "noise"),
        methods=_choices(methods, iterations, set_ or []),
        model_units=model_units,
    )
    result = run(study)
    if output is not None:
        from app.export.bundle import write_comparison

        write_comparison(result, output)
    _say(json.dumps(comparison_json(result)) if json_ else comparison_text(result))


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


def _choices(methods: str | None, iterations: int | None, settings: list[str]) -> tuple[Any, ...]:
    """Build the choices of a study from the words of the command line."""
    from core.parameters import build_params
    from core.smoothing import method_spec
    from core.study import MethodChoice, default_choices

    ids = [choice.method for choice in default_choices() if choice.enabled]
    if methods is not None:
        ids = [method_spec(id_.strip()).id for id_ in methods.split(",")]
    params: dict[str, dict[str, Any]] = {id_: {} for id_ in ids}
    for setting in settings:
        id_, name, value = _parse_setting(setting)
        if id_ not in params:
            raise UsageError(f"--set {setting}: {id_} does not take part; {', '.join(ids)} do.")
        params[id_][name] = value
    counts = {} if iterations is None else {"iterations": iterations}
    made = [
        build_params(MethodChoice, {"method": id_, "params": params[id_], **counts}) for id_ in ids
    ]
    for choice in made:
        _ = choice.settings  # a wrong value is told now, not after minutes of work
    return tuple(made)


def _parse_setting(setting: str) -> tuple[str, str, str]:
    left, equals, value = setting.partition("=")
    id_, dot, name = left.partition(".")
    if not (equals and dot and name):
        raise UsageError(f"--set {setting} is not of the form id.parameter=value.")
    return id_, name, value


def _has_display() -> bool:
    """Whether a window can open: always on macOS and Windows, else with X or Wayland."""
    if sys.platform in {"darwin", "win32"}:
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def _one_line(error: Exception) -> str:
    return " ".join(str(error).split()) or type(error).__name__


def _say(text: str) -> None:
    print(text)  # noqa: T201
