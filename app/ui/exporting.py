"""Exports: files written beside the window, whole or not at all, while the window draws for them.

An export is a generator that the worker advances; what it yields is the share that is done.
"""

from collections.abc import Callable, Iterator
from concurrent.futures import CancelledError, Future
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

from PySide6.QtWidgets import QFileDialog, QWidget

from app.export.formulas import guard_formulas
from app.session import Job, Post, Session
from app.ui.dialogs import ask_where_to_save
from core.io import SaveError
from core.statistics import Progress
from core.whole_files import Staging

T = TypeVar("T")
_END: Any = object()

# The window draws its plots while the worker writes figures.
guard_formulas()


class Drawer:
    """Draws on the window's thread, one piece a turn of its loop, what the worker asks for.

    VTK draws nowhere else. A call gives the worker an iterator over the pieces; asking it for one
    more waits until the window has drawn it.

    Parameters
    ----------
    post : callable
        Runs a function on the window's thread.
    """

    def __init__(self, post: Post) -> None:
        self._post = post
        self._closed = False
        self._piece: Future[Any] = Future()
        self._begun: list[Iterator[Any]] = []

    def __call__(self, pieces: Iterator[T]) -> Iterator[T]:
        """Hand on pieces, which only the window's thread begins, advances and closes."""
        self._begun.append(pieces)
        try:
            while (piece := self._fetch(pieces)) is not _END:
                yield piece
        finally:
            self._post(pieces.close)

    def close(self) -> None:
        """Draw nothing more; a worker that waits for a piece gives up."""
        self._closed = True
        self._piece.cancel()
        for pieces in self._begun:
            pieces.close()

    def _fetch(self, pieces: Iterator[T]) -> T:
        self._piece = piece = Future()
        if self._closed:
            raise CancelledError
        self._post(partial(_draw, pieces, piece))
        return piece.result()


Export = Callable[[Path, Drawer], Iterator[float]]
"""Writes to a path, step by step; called on the window's thread, advanced by the worker."""


def export(session: Session, path: Path, begin: Export, saved: str = "") -> Job:
    """Write files beside the window and tell when they are there.

    Parameters
    ----------
    session : Session
        Lists the export among what runs, and tells how it ended.
    path : Path
        The file, or the folder.
    begin : callable
        Gathers what is shown now and returns the generator that writes it.
    saved : str
        What to tell at the end, where it is more than the name.
    """
    drawer, staging = Drawer(session.post), Staging()
    reached: float | None = None

    def give_up() -> None:
        drawer.close()
        staging.discard()

    def step(progress: Progress[bool]) -> None:
        nonlocal reached
        reached = progress.share
        if progress.value:
            session.notified.emit(saved or f"Saved {path.name}.")

    job = Job(
        _whole_or_not(begin(path, drawer), path, staging), step, session.report,
        lambda: session.closing.disconnect(drawer.close), late=True,
        title=f"Writing {path.name}", share=lambda: reached, on_cancel=give_up,
    )  # fmt: skip
    session.closing.connect(drawer.close)
    return session.exports.start(job)


def ask_to_export(
    parent: QWidget, session: Session, title: str, name: str, filters: str, begin: Export
) -> QFileDialog:
    """Ask where to save, and write there."""
    return ask_where_to_save(
        parent, title, name, filters, lambda path: export(session, path, begin)
    )


def at_once(write: Callable[[Path], object]) -> Export:
    """Make an export of a function that writes a file in one step."""
    return lambda path, _: in_one_step(partial(write, path))


def in_one_step(write: Callable[[], object]) -> Iterator[float]:
    """Do all of an export in one step."""
    write()
    yield 1.0


def _whole_or_not(steps: Iterator[float], path: Path, staging: Staging) -> Iterator[Progress[bool]]:
    """Let what is written take its place at the end, unless the export fails or is cancelled."""
    try:
        while True:
            with staging:
                share = next(steps, None)
            if share is None:
                break
            yield Progress(None, share)
        staging.commit()
        yield Progress(True, 1.0)
    except OSError as error:
        reason = error.strerror or type(error).__name__
        raise SaveError(f"{path} cannot be written: {reason}.") from error
    finally:
        steps.close()
        staging.discard()


def _draw(pieces: Iterator[Any], answer: "Future[Any]") -> None:
    """Draw a piece, unless nobody waits for it any more."""
    if not answer.set_running_or_notify_cancel():
        return
    try:
        answer.set_result(next(pieces, _END))
    except Exception as error:  # noqa: BLE001 - belongs to the worker that asked
        answer.set_exception(error)
