"""Pushing changes of the Skeleton tab into the study."""

from typing import Any

from app.session import Session
from core.study import SkeletonView


def current_view(session: Session, index: int) -> SkeletonView:
    """Return the settings of a view."""
    return session.study.skeleton.views[index]


def change_settings(session: Session, step: str, **update: Any) -> None:
    """Change what both views share, as one undoable step."""
    settings = session.study.skeleton.model_copy(update=update)
    session.apply(session.study.model_copy(update={"skeleton": settings}), step)


def change_view(session: Session, index: int, step: str, **update: Any) -> None:
    """Change one view, as one undoable step."""
    view = current_view(session, index).model_copy(update=update)
    settings = session.study.skeleton.with_view(index, view)
    session.apply(session.study.model_copy(update={"skeleton": settings}), step)
