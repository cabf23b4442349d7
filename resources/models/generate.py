"""Make the bundled models: ``python -m resources.models.generate [FOLDER]``.

Takes about a minute and a half. The same versions of the packages give the same files.
"""

import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np

from core.mesh import TriangleMesh
from core.mesh.geometry import volume
from resources.models.creature import creature
from resources.models.double_torus import double_torus
from resources.models.machine_part import machine_part
from resources.models.surface import Mesh

# Each model with its genus.
MODELS: dict[str, tuple[Callable[[], Mesh], int]] = {
    "creature": (creature, 0),
    "double_torus": (double_torus, 2),
    "machine_part": (machine_part, 5),
}


def main(folder: Path) -> None:
    """Make all models and write them to a folder."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, (make, genus) in MODELS.items():
        mesh = y_up(make())
        check(mesh, genus)
        path = folder / f"{name}.ply"
        path.write_bytes(ply(mesh, name))
        print(f"{path}: {len(mesh.vertices)} vertices, {len(mesh.faces)} faces, genus {genus}")


def y_up(mesh: Mesh) -> Mesh:
    """Stand a model that was made with z up on its feet where y is up, as most files have it."""
    return Mesh(mesh.vertices[:, [0, 2, 1]] * [1.0, 1.0, -1.0], mesh.faces)


def check(mesh: Mesh, genus: int) -> None:
    """Refuse a mesh that is not one closed surface of the given genus, wound outwards."""
    solid = TriangleMesh(*mesh)
    topology = solid.topology
    is_sound = topology.component_count == 1 and topology.is_consistently_wound
    if not (is_sound and solid.genus == genus and volume(solid) > 0):
        raise ValueError(f"{solid} is not one closed surface of genus {genus} wound outwards.")


def ply(mesh: Mesh, name: str) -> bytes:
    """The mesh as a binary little-endian PLY file with single precision coordinates."""
    header = [
        "ply",
        "format binary_little_endian 1.0",
        f"comment {name}, made by resources/models/generate.py of Burnish",
        f"element vertex {len(mesh.vertices)}",
        *[f"property float {axis}" for axis in "xyz"],
        f"element face {len(mesh.faces)}",
        "property list uchar int vertex_indices",
        "end_header",
    ]
    rows = np.zeros(len(mesh.faces), [("count", "u1"), ("corners", "<i4", 3)])
    rows["count"], rows["corners"] = 3, mesh.faces
    vertices = mesh.vertices.astype("<f4")
    return "\n".join([*header, ""]).encode("ascii") + vertices.tobytes() + rows.tobytes()


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent)
