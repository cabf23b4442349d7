"""Models by the names that a study gives them, and whether two are versions of one."""

from pathlib import Path

import numpy as np

from core.arrays import FloatArray
from core.io import LoadedMesh, read_mesh, sample_path
from core.mesh import TriangleMesh
from core.parameters import ParameterError
from core.study import SAMPLE_PREFIX


def read_model(model: str) -> LoadedMesh:
    """Read a model by its path or, as ``sample:ID``, from the bundled ones."""
    if model.startswith(SAMPLE_PREFIX):
        return read_mesh(sample_path(model.removeprefix(SAMPLE_PREFIX)))
    return read_mesh(Path(model))


def matched(original: TriangleMesh, noisy: LoadedMesh) -> TriangleMesh:
    """Give a noisy mesh from its own file the topology of the original.

    Raises
    ------
    ParameterError
        If the two do not agree vertex by vertex and face by face.
    """
    mesh = noisy.mesh
    pairs = (("vertices", mesh.vertices, original.vertices), ("faces", mesh.faces, original.faces))
    for word, ours, theirs in pairs:
        if len(ours) != len(theirs):
            raise ParameterError(
                f"{noisy.name} has {len(ours):,} {word} and the original {len(theirs):,}; "
                "a noisy file must match its original vertex by vertex."
            )
    same = np.array_equal(mesh.faces, original.faces)
    if not same and not np.array_equal(_face_set(mesh), _face_set(original)):
        raise ParameterError(
            f"{noisy.name} joins its vertices to other faces than the original; "
            "a noisy file must match its original vertex by vertex."
        )
    return original.with_vertices(mesh.vertices)


def _face_set(mesh: TriangleMesh) -> FloatArray:
    """Faces without order: corners sorted in each, faces sorted among themselves."""
    faces = np.sort(mesh.faces, axis=1).astype(np.float64)
    return faces[np.lexsort(faces.T[::-1])]
