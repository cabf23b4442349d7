"""``burnish methods``: what there is to run."""

import json
from typing import Annotated

from cyclopts import Parameter

from app.usage import say


def methods(*, json_: Annotated[bool, Parameter(name="--json", negative="")] = False) -> None:
    """List every method with its parameters.

    Parameters
    ----------
    json_
        Print one JSON object instead of the list.
    """
    from app.export.reports import methods_json, methods_text

    say(json.dumps(methods_json()) if json_ else methods_text())
