"""Which two panes are compared, one shown in place of the other."""

from collections.abc import Sequence
from dataclasses import replace

from app.scene.panes import Pane


def pair(ids: Sequence[str], selected: str | None, compare_with: str) -> tuple[str, str] | None:
    """Choose the pane to compare and the one to compare it with.

    Parameters
    ----------
    ids : sequence of str
        Ids of the panes; the last is a method's where there is one.
    selected : str or None
        The selected pane.
    compare_with : str
        The pane that the view compares with.

    Returns
    -------
    (str, str) or None
        The pane and its counterpart, two different ones; None if there are fewer than two.
    """
    if len(ids) < 2:
        return None
    pane = selected if selected is not None and selected in ids else ids[-1]
    others = [id_ for id_ in (compare_with, "noisy", *ids) if id_ in ids and id_ != pane]
    return pane, others[0]


def swapped(panes: Sequence[Pane], pane: str, other: str) -> list[Pane]:
    """Return the panes with one of them showing another's mesh, colours and text in its place."""
    source = next(p for p in panes if p.id == other)
    return [replace(source, id=pane) if p.id == pane else p for p in panes]
