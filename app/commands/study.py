"""``burnish study``: a study as a command line or a script."""

from pathlib import Path
from typing import Annotated, Literal

from cyclopts import Parameter

from app.usage import say


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
    say((command_of if as_ == "command" else script_of)(shown))
