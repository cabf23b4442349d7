"""PyVista's example models, downloaded beside the window."""

import contextlib
import logging
import threading
from collections.abc import Callable
from typing import NamedTuple

from app.ui.tasks import Poster

logger = logging.getLogger(__name__)

_NO_CONNECTION = ("connection", "urlerror", "gaierror")


class Example(NamedTuple):
    """A surface of `pyvista.examples`: its title, and its file there."""

    title: str
    file: str


EXAMPLES = {
    "bunny": Example("Bunny", "bunny.ply"),
    "bunny_coarse": Example("Coarse bunny", "Bunny.vtp"),
    "cow": Example("Cow", "cow.vtp"),
    "cow_head": Example("Cow's head", "cowHead.vtp"),
    "horse": Example("Horse", "horse.vtp"),
    "dragon": Example("Dragon", "dragon.ply"),
    "armadillo": Example("Armadillo", "Armadillo.ply"),
    "lucy": Example("Lucy", "lucy.ply"),
    "foot_bones": Example("Foot bones", "fsu/footbones.ply"),
    "louis_louvre": Example("Louis XIV", "louis.ply"),
    "shark": Example("Shark", "shark.ply"),
    "owl": Example("Owl", "ivan-nikolov/owl_decimated.vtp"),
    "urn": Example("Urn", "urn.stl"),
    "gears": Example("Gears", "gears.stl"),
}
"""Surfaces that can be downloaded, by id."""


class DownloadError(Exception):
    """Raised when a model cannot be had; one sentence says why."""


class DownloadCancelledError(DownloadError):
    """Raised when a download was cancelled."""


class Meter:
    """Is told by a download how far it is, and stops it between two pieces when it is cancelled.

    To the library that downloads it is a progress bar.
    """

    def __init__(self) -> None:
        self.total = 0
        self._done = 0
        self._cancelled = False

    def cancel(self) -> None:
        """Let the download stop at its next piece."""
        self._cancelled = True

    def share(self) -> float | None:
        """Share that has come, None where that is not known."""
        return min(self._done / self.total, 1.0) if self.total else None

    def update(self, size: int) -> None:
        """Count a piece that has come."""
        if self._cancelled:
            raise DownloadCancelledError("The download was cancelled.")
        self._done += size

    def reset(self) -> None:
        """Count from the beginning."""
        self._done = 0

    def close(self) -> None:
        """All has come: nothing is left to tell."""


def download(example: str, meter: Meter) -> str:
    """Return the path of an example, downloaded unless it was before.

    Raises
    ------
    DownloadCancelledError
        If it was cancelled; then nothing is left of it.
    DownloadError
        If it cannot be had.
    """
    try:
        return _fetched(EXAMPLES[example].file, meter)
    except DownloadCancelledError:
        raise
    except Exception as error:
        # What a download can raise depends on the libraries beneath PyVista.
        logger.info("download of %s failed: %s", example, error)
        title = EXAMPLES[example].title
        raise DownloadError(f"{title} cannot be downloaded: {_reason(error)}") from error


def _fetched(file: str, meter: Meter) -> str:
    """Get a file into PyVista's own folder, under its name only once all of it is there.

    PyVista lets nobody look on while it downloads, so that is done before it is asked.
    """
    import pooch
    from pyvista.examples import downloads

    if downloads.SOURCE.startswith("http"):  # it may be a folder on this computer
        downloads.FETCHER.registry.setdefault(file, None)
        downloads.FETCHER.fetch(file, downloader=pooch.HTTPDownloader(progressbar=meter))
    return str(downloads.download_file(file))


def download_beside(
    poster: Poster,
    example: str,
    meter: Meter,
    done: Callable[[str], None],
    failed: Callable[[DownloadError], None],
) -> None:
    """Download an example on a thread of its own; `poster` brings the outcome back."""

    def work() -> None:
        try:
            path = download(example, meter)
        except DownloadError as error:
            _post(poster, lambda error=error: failed(error))
        else:
            _post(poster, lambda: done(path))

    threading.Thread(target=work, name=f"burnish-download-{example}", daemon=True).start()


def _post(poster: Poster, call: Callable[[], None]) -> None:
    with contextlib.suppress(RuntimeError):  # the window is gone
        poster(call)


def _reason(error: Exception) -> str:
    """Why a download failed, in words; networks and the libraries above them have many names."""
    names = " ".join(kind.__name__.lower() for kind in type(error).__mro__)
    if "timeout" in names:
        return "github.com did not answer in time. The bundled models need no connection."
    if isinstance(error, OSError) and any(word in names for word in _NO_CONNECTION):
        return "there is no connection to github.com. The bundled models need none."
    return f"{' '.join(str(error).split())[:160]}."
