"""``burnish compare``: the methods side by side, as numbers and files."""

import json
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from app.usage import say


def compare(
    model: str | None = None,
    /,
    *,
    study: Path | None = None,
    repair: str | None = None,
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
    repair
        Ids of repairs of the model, separated by commas, done in that order before noise is added;
        all stands for what burnish doctor --repair all does, none drops those of the study.
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
            model, file=study, repair=repair, noisy=noisy,
            noise={"sigma": sigma, "seed": seed}, methods=methods, iterations=iterations,
            settings=set_ or [], model_units=model_units,
        )
    )  # fmt: skip
    if output is not None:
        from app.export.bundle import write_comparison

        write_comparison(result, output)
    say(json.dumps(comparison_json(result)) if json_ else comparison_text(result))
