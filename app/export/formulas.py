"""Matplotlib's formulas in two threads: the window draws plots while a worker writes figures."""

import threading
from typing import Any

from matplotlib.mathtext import MathTextParser

_ALONE = threading.Lock()
_parse: Any = MathTextParser.parse


def guard_formulas() -> None:
    """Let one thread at a time read a formula: all share one parser, which has a state.

    Numbers on axes are formulas too. Fonts are each thread's own, figures are never shared.
    """

    def parse_alone(*args: Any, **options: Any) -> Any:
        with _ALONE:
            return _parse(*args, **options)

    setattr(MathTextParser, "parse", parse_alone)  # noqa: B010 - mypy
