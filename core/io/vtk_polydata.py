"""VTK's polygonal data, legacy ``.vtk`` and XML ``.vtp``, by VTK's own readers.

VTK is written in C++ and can end the process on a broken file. So its readers run in a process of
their own, with bounded memory and time, and only arrays come back.
"""

import io
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from core.io.errors import LoadError
from core.io.polygons import Lists, Polygons, cut_strips

_WORKER = Path(__file__).with_name("vtk_worker.py")
_SECONDS = 10.0
_BYTES_PER_SECOND = 2e6
_DATASET = re.compile(rb"^[ \t]*DATASET[ \t]+(\w+)", re.MULTILINE | re.IGNORECASE)


def read_vtk(path: Path) -> Polygons:
    """Read the polygons and triangle strips of a legacy VTK file."""
    data = path.read_bytes()
    if not data.lstrip().lower().startswith(b"# vtk"):
        raise LoadError("it does not begin with '# vtk DataFile', so it is no VTK file")
    found = _DATASET.search(data)
    kind = found[1].decode().upper() if found else "nothing"
    if kind != "POLYDATA":
        raise LoadError(f"its data set is {kind}; allowed is POLYDATA")
    return _read(path, "legacy")


def read_vtp(path: Path) -> Polygons:
    """Read the polygons and triangle strips of a VTP file."""
    with path.open("rb") as file:
        head = file.read(4096)
    if b"<VTKFile" not in head:
        raise LoadError("it has no element <VTKFile>, so it is no VTP file")
    if not re.search(rb"type\s*=\s*[\"']PolyData", head):
        raise LoadError("its VTKFile is of another type; allowed is PolyData")
    return _read(path, "xml")


def _read(path: Path, kind: str) -> Polygons:
    arrays = _arrays(path, kind)
    vertices = arrays["vertices"].astype(np.float64)
    faces = Lists(arrays["face_sizes"], arrays["face_corners"])
    strips = Lists(arrays["strip_sizes"], arrays["strip_corners"])
    if not len(strips.sizes):
        return Polygons(vertices, faces)
    triangles, change = cut_strips(strips)
    return Polygons(vertices, Lists.chain([faces, triangles]), (change,))


def _arrays(path: Path, kind: str) -> dict[str, NDArray[Any]]:
    """Run VTK's reader in its own process and take the arrays that it writes."""
    seconds = _SECONDS + path.stat().st_size / _BYTES_PER_SECOND
    command = [sys.executable, "-I", str(_WORKER), kind, str(path.resolve())]
    try:
        result = subprocess.run(
            command,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=seconds,
            check=False,
            creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
        )
    except subprocess.TimeoutExpired as error:
        raise LoadError(f"VTK did not get through it in {seconds:.0f} s") from error
    if result.returncode:
        raise LoadError(f"VTK cannot read it ({_reason(result.stderr)})")
    with np.load(io.BytesIO(result.stdout), allow_pickle=False) as arrays:
        return dict(arrays)


def _reason(message: bytes) -> str:
    if b"bad_alloc" in message:
        return "it announces more than a file of its size can hold"
    words = message.decode(errors="replace").split()
    return " ".join(words)[:160] or "its reader broke down"
