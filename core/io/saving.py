"""Writing a mesh to a file, whole or not at all."""

import os
from collections.abc import Callable
from pathlib import Path

from core.io.errors import SaveError
from core.io.obj import write_obj
from core.io.off import write_off
from core.io.ply import write_ply
from core.io.stl import write_stl
from core.mesh import TriangleMesh
from core.whole_files import write_atomically

_WRITERS: dict[str, Callable[[TriangleMesh], bytes]] = {
    ".ply": write_ply,
    ".obj": write_obj,
    ".off": write_off,
    ".stl": write_stl,
}
SUPPORTED_WRITE = tuple(_WRITERS)


def save_mesh(mesh: TriangleMesh, path: str | os.PathLike[str]) -> None:
    """Write a mesh; the suffix chooses the format.

    PLY, OBJ and OFF keep every vertex in its order and give exactly the same coordinates back; STL
    keeps neither and rounds to 32 bits. A file of that name is replaced only once the new one is
    complete.

    Parameters
    ----------
    mesh : TriangleMesh
        What is written.
    path : str or path-like
        File whose suffix is one of `SUPPORTED_WRITE`, in a folder that exists.

    Raises
    ------
    SaveError
        One sentence with the file's name: unknown suffix, no such folder, no permission, disk full.
    """
    file = Path(path)
    try:
        if file.suffix.lower() not in _WRITERS:
            allowed = " ".join(SUPPORTED_WRITE)
            raise SaveError(f"files of this kind are not written; allowed are {allowed}")
        if not file.parent.is_dir():
            raise SaveError(f"there is no folder {file.parent}")
        if file.is_dir():
            raise SaveError("a folder has this name")
        write_atomically(file, _WRITERS[file.suffix.lower()](mesh))
    except SaveError as error:
        raise SaveError(f"{file.name or file}: {error}.") from error
    except OSError as error:
        raise SaveError(f"{file.name}: cannot be written ({error.strerror or error}).") from error
