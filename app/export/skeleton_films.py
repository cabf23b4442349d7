"""Films of skeletal graphs: GIF or MP4, frame by frame."""

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

from app.export.pictures import Picture, PictureError
from core.whole_files import replacing

FILM_SUFFIXES = (".gif", ".mp4")


def write_film(path: Path, frames: Iterable[Picture], per_second: float) -> Iterator[int]:
    """Write a film and yield the number of frames that are written, so that it can be stopped.

    A film that is stopped or fails leaves no file, and one that was there stays as it was.

    Parameters
    ----------
    path : Path
        File ending in .gif or .mp4.
    frames : iterable of Picture
        Opaque pictures of one size; MP4 leaves out the last row or column of an odd one.
    per_second : float
        Frames a second.

    Raises
    ------
    PictureError
        If the suffix is another or the file cannot be written.
    """
    if path.suffix.lower() not in FILM_SUFFIXES:
        raise PictureError(f"{path.name}: films end in {' or '.join(FILM_SUFFIXES)}.")
    try:
        with replacing(path) as fresh, _writer(fresh, per_second) as writer:
            for number, frame in enumerate(frames, 1):
                height, width = frame.shape[:2]
                writer.append_data(frame[: height - height % 2, : width - width % 2])
                yield number
    except OSError as error:
        reason = error.strerror or str(error).splitlines()[0]
        raise PictureError(f"{path} cannot be written: {reason}.") from error


def _writer(path: Path, per_second: float) -> Any:
    import imageio.v2 as imageio  # late, because its import takes a while

    if path.suffix.lower() == ".gif":
        return imageio.get_writer(path, duration=1000 / per_second, loop=0)
    return imageio.get_writer(path, fps=per_second, quality=8, macro_block_size=2)
