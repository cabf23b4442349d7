"""A composed figure as pixels, and as PNG, PDF and TIFF files."""

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from app.export.montage import montage_figure
from app.export.montage_plan import Montage
from app.export.montage_source import Drawn, PictureSource
from app.export.pictures import Picture, PictureError
from core.whole_files import whole_file

SUFFIXES = (".png", ".pdf", ".tiff")


def montage_pixels(figure: Figure) -> Picture:
    """Draw a montage's figure into pixels, (height, width, 4)."""
    canvas: Any = FigureCanvasAgg(figure)
    canvas.draw()
    picture: Picture = np.asarray(canvas.buffer_rgba()).copy()
    return picture


def write_montage(
    montage: Montage, source: PictureSource, path: Path, pictures: Iterable[Drawn]
) -> Iterator[float]:
    """Write a montage of pictures that are being drawn; yield the share that is done.

    Raises
    ------
    PictureError
        As :func:`save_montage`.
    """
    steps = len(montage.cells) + 2
    kept: list[Drawn] = []
    for drawn in pictures:
        kept.append(drawn)
        yield len(kept) / steps
    figure = montage_figure(montage, source, kept)
    yield 1 - 1 / steps
    save_montage(figure, path)
    yield 1.0


def save_montage(figure: Figure, path: Path) -> None:
    """Write a montage's figure as PNG, TIFF or PDF, by the suffix; in a PDF text stays text.

    Raises
    ------
    PictureError
        If the suffix is another, or the file cannot be written.
    """
    suffix = ".tiff" if path.suffix.lower() == ".tif" else path.suffix.lower()
    if suffix not in SUFFIXES:
        allowed = " ".join(SUFFIXES)
        raise PictureError(f"{path.name}: figures are not written in this format; use {allowed}.")
    # No date: the same study gives the same file.
    metadata = {"CreationDate": None} if suffix == ".pdf" else None
    extra: dict[str, Any] = {"pil_kwargs": {"compression": "tiff_lzw"}} if suffix == ".tiff" else {}
    try:
        with mpl.rc_context({"pdf.fonttype": 42}), whole_file(path) as stream:
            figure.savefig(stream, format=suffix[1:], dpi=figure.dpi, metadata=metadata, **extra)
    except OSError as error:
        reason = error.strerror or type(error).__name__
        raise PictureError(f"{path} cannot be written: {reason}.") from error
