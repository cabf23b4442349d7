"""Command line: ``burnish MODEL`` opens the window, the other commands need neither Qt nor display.

Nothing heavy is imported before a command runs, so that ``burnish --help`` answers at once.
"""

import os
import sys
from pathlib import Path

from cyclopts import App, CycloptsError

from app.commands import COMMANDS, compare
from app.usage import say

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
    except (CycloptsError, ValueError, OSError, MemoryError) as error:
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
    say(f"There is no display; the comparison goes into {_HEADLESS_FOLDER}/ instead.")
    if model.lower().endswith(".burnish"):
        compare(study=Path(model), output=_HEADLESS_FOLDER)
    else:
        compare(model, output=_HEADLESS_FOLDER)
    return 0


for command in COMMANDS:
    app.command(command)


def _has_display() -> bool:
    """Whether a window can open: always on macOS and Windows, else with X or Wayland."""
    if sys.platform in {"darwin", "win32"}:
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))


def _one_line(error: Exception) -> str:
    if isinstance(error, MemoryError):
        return "There is not enough memory for that; a smaller model or fewer iterations may fit."
    return " ".join(str(error).split()) or type(error).__name__
