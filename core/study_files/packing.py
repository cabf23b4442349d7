"""Models packed beside their study in a zip file.

A zip file and not text in the JSON: it is a third smaller, any archive program can take the
models out, and sizes are known before anything is read.
"""

import io
import zipfile
import zlib
from collections.abc import Mapping
from pathlib import Path

from core.io import SUPPORTED_READ, read_mesh
from core.io.ply import write_ply
from core.study_files.document import MOST_BYTES
from core.study_files.fingerprints import Fingerprint, fingerprint, model_path
from core.whole_files import write_atomically

DOCUMENT = "study.json"
MOST_MODEL_BYTES = 512 * 1024**2

_METHODS = {zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED}
_LONGEST = 120
# Models shrink 2 to 30 times; what grows more than this from a large file is made to fill the disk.
_LARGEST_GROWTH = 200
_ALWAYS_UNPACKED = 16 * 1024**2
# A .gltf names further files, so its mesh is packed and not the file.
_NOT_ALONE = ".gltf"


def packable(model: str) -> tuple[str, bytes]:
    """Return the name and the content under which a model is packed.

    Raises
    ------
    OSError, LoadError
        If it cannot be read.
    ValueError
        If it is too large.
    """
    path = model_path(model)
    if path.suffix.lower() == _NOT_ALONE:
        return f"{path.stem}.ply", write_ply(read_mesh(path).mesh)
    if path.stat().st_size > MOST_MODEL_BYTES:
        raise ValueError(f"{path.name} is larger than {MOST_MODEL_BYTES >> 20} MB")
    return path.name, path.read_bytes()


def pack(document: str, models: Mapping[str, bytes]) -> bytes:
    """Return a zip file of a document and models by their member names."""
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        for member, content in {DOCUMENT: document.encode(), **models}.items():
            entry = zipfile.ZipInfo(member)  # without the time: the same study, the same file
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, content, _method(content))
    return stream.getvalue()


def _method(content: bytes) -> int:
    """Leave a model as it is that would shrink so much that nobody would unpack it again."""
    if 2 * len(content) < _most_unpacked(0):
        return zipfile.ZIP_DEFLATED
    swells = 2 * len(content) > _most_unpacked(len(zlib.compress(content)))
    return zipfile.ZIP_STORED if swells else zipfile.ZIP_DEFLATED


def _most_unpacked(packed: int) -> int:
    return max(_LARGEST_GROWTH * packed, _ALWAYS_UNPACKED)


def packed_document(file: Path) -> bytes:
    """Return the document of a packed study.

    Raises
    ------
    ValueError
        If it is not there, too large or broken.
    """
    return _member(file, DOCUMENT, MOST_BYTES)


def unpack(file: Path, member: str, mark: Fingerprint, folder: Path) -> Path:
    """Put a packed model into a folder of its own below `folder`, named by its content.

    Raises
    ------
    ValueError
        If its name is not that of a model, or its size or content is not what the study says.
    OSError
        If the folder cannot be written.
    """
    name = Path(member.replace("\\", "/")).name
    if Path(name).suffix.lower() not in SUPPORTED_READ or len(name) > _LONGEST or "\0" in name:
        raise ValueError(f"holds {name[:60]!r}, which is not the name of a model")
    target = folder / mark.sha256[:32] / name
    if target.is_file() and fingerprint(target) == mark:
        return target
    content = _member(file, member, min(mark.size, MOST_MODEL_BYTES))
    if Fingerprint.of(content) != mark:
        raise ValueError(f"holds {name} with another content than it says")
    target.parent.mkdir(parents=True, exist_ok=True)
    write_atomically(target, content)
    return target


def _member(file: Path, member: str, most: int) -> bytes:
    """Read one member, at most as many bytes as allowed, whatever the archive says of itself."""
    try:
        with zipfile.ZipFile(file) as archive:
            info = archive.getinfo(member)
            most = min(most, _most_unpacked(info.compress_size))
            if info.compress_type not in _METHODS or info.file_size > most:
                raise ValueError(f"holds {member[:60]!r} in a size or form that is not allowed")
            with archive.open(info) as stream:
                return stream.read(most)
    except KeyError as error:
        raise ValueError(f"does not hold {member[:60]!r}") from error
    except (
        zipfile.BadZipFile,
        zlib.error,
        EOFError,
        NotImplementedError,
        RuntimeError,
        MemoryError,
    ) as error:
        raise ValueError("is a packed study that is damaged") from error
