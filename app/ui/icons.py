"""Icons of one font: qtawesome by itself reads all of its twelve fonts before it draws one."""

from functools import cache
from pathlib import Path
from typing import Any

import qtawesome
from PySide6.QtGui import QIcon

_PREFIX = "mdi6"
_FILES = "materialdesignicons6-webfont"


def font_icon(name: str, **look: Any) -> QIcon:
    """Return an icon by its name; `look` is what qtawesome takes, such as its colour."""
    drawn: QIcon = _font().icon(name, **look)
    return drawn


@cache
def _font() -> qtawesome.IconicFont:
    folder = Path(qtawesome.__file__).parent / "fonts"
    letters, names = (next(folder.glob(f"{_FILES}-*.{kind}")).name for kind in ("ttf", "json"))
    return qtawesome.IconicFont((_PREFIX, letters, names))
