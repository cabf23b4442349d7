"""PyVista's example models, downloaded beside the window."""

import contextlib
import logging
import threading
from collections.abc import Callable

from app.ui.tasks import Poster

logger = logging.getLogger(__name__)

_NO_CONNECTION = ("connection", "urlerror", "gaierror")

EXAMPLES = {
    "bunny": "Bunny",
    "bunny_coarse": "Coarse bunny",
    "cow": "Cow",
    "cow_head": "Cow's head",
    "horse": "Horse",
    "dragon": "Dragon",
    "armadillo": "Armadillo",
    "lucy": "Lucy",
    "foot_bones": "Foot bones",
    "louis_louvre": "Louis XIV",
    "shark": "Shark",
    "owl": "Owl",
    "urn": "Urn",
    "gears": "Gears",
}
"""Names of surfaces that `pyvista.examples` downloads, with their titles."""


class DownloadError(Exception):
    """Raised when a model cannot be had; one sentence says why."""


def download(example: str) -> str:
    """Return the path of an example, downloaded unless it was before.

    Raises
    ------
    DownloadError
        If it cannot be had.
    """
    from pyvista import examples

    try:
        return str(getattr(examples, f"download_{example}")(load=False))
    except Exception as error:
        # What a download can raise depends on the libraries beneath PyVista.
        logger.info("download of %s failed: %s", example, error)
        raise DownloadError(
            f"{EXAMPLES[example]} cannot be downloaded: {_reason(error)}"
        ) from error


def download_beside(
    poster: Poster,
    example: str,
    done: Callable[[str], None],
    failed: Callable[[DownloadError], None],
) -> None:
    """Download an example on a thread of its own; `poster` brings the outcome back."""

    def work() -> None:
        try:
            path = download(example)
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
