"""Colours with a meaning: the same in panes, plots and tables, safe for colour-blind eyes."""

from dataclasses import dataclass

from core.smoothing import METHODS

# Okabe and Ito's palette for colour-blind readers, dark enough on white and light enough on black.
_PALETTE = ("#1a80c4", "#e69f00", "#009e73", "#cc79a7", "#d55e00", "#56b4e9", "#8c6bb1", "#999933")

ORIGINAL_COLOUR = "#7f8c99"
NOISY_COLOUR = "#7f7f7f"
MARK_COLOUR = "#e0341f"
"""Places that are pointed out."""
WARNING_COLOUR = "#d9480f"
"""What went wrong, on the grounds of both themes in the panels."""


def method_colour(method: str) -> str:
    """Colour of a method, by its place in the registry."""
    return _PALETTE[list(METHODS).index(method) % len(_PALETTE)]


@dataclass(frozen=True)
class Theme:
    """Ground and ink of pictures and plots.

    Attributes
    ----------
    dark : bool
        Whether this is the dark theme.
    ground, ground_top : str
        Background of the panes at the bottom and at the top.
    panel, ink, faint : str
        Background of a plot, its text and lines, and its grid.
    surface : str
        Colour of a mesh that no values colour.
    accent : str
        Frame of the selected pane.
    warning : str
        Text that warns, on the background of the panes.
    """

    dark: bool
    ground: str
    ground_top: str
    panel: str
    ink: str
    faint: str
    surface: str
    accent: str
    warning: str


LIGHT = Theme(
    False, "#e9edf2", "#fbfcfd", "#ffffff", "#20262d", "#d5dbe2", "#b9c7d6", "#0b6bcb", "#b3261e"
)
DARK = Theme(
    True, "#1b1f24", "#2b3138", "#22272d", "#e4e8ec", "#3d454e", "#a9bacb", "#5aa9f5", "#ff8a7a"
)
