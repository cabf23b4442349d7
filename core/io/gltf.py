"""glTF 2 and its binary form GLB, by trimesh.

trimesh leaves some things out without a word: compressed and sparse data, triangle fans, scaled
integers, instances on the GPU. A model that needs one of them is refused here, so that nobody gets
a wrong mesh; and sizes are compared with the file before memory is asked for.
"""

import io
import json
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import numpy as np

from core.arrays import FloatArray
from core.io.errors import LoadError
from core.io.parts import Part, join_parts
from core.io.polygons import Polygons, counted

_CHANGES_SHAPE = {
    "KHR_draco_mesh_compression",
    "EXT_meshopt_compression",
    "KHR_meshopt_compression",
    "EXT_mesh_gpu_instancing",
}
_MAGIC = b"glTF"
_GLB_HEAD = 20
_TRIANGLES, _STRIP, _FAN = 4, 5, 6
# Many accessors may look at one buffer; more than this many times its size is a trap.
_LARGEST_GROWTH = 20
_ITEM_BYTES = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}
_ITEMS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
_FLOAT32 = 5126


def read_gltf(path: Path) -> Polygons:
    """Read the triangles of all nodes of the scene, each moved to its place."""
    data = path.read_bytes()
    tree = _tree(data)
    primitives = [part for mesh in tree.get("meshes", []) for part in mesh["primitives"]]
    _refuse_what_trimesh_misses(tree, primitives)
    files = dict(_buffer_files(tree, path.parent.resolve()))
    size = len(data) + sum(map(len, files.values()))
    _check_sizes(tree, size)
    bare = sum(part.get("mode", _TRIANGLES) not in (_TRIANGLES, _STRIP) for part in primitives)
    left_out = (f"{counted(bare, 'part')} of points or lines left out",) if bare else ()
    return join_parts(_parts(data, files), file_size=size, changes=left_out)


def _tree(data: bytes) -> dict[str, Any]:
    text = _json_chunk(data) if data.startswith(_MAGIC) else data
    try:
        tree = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise LoadError(f"it is no glTF file or cut short ({error})") from error
    if not isinstance(tree, dict):
        raise LoadError("it is no glTF file (its JSON is not an object)")
    return tree


def _json_chunk(data: bytes) -> bytes:
    """Return the first chunk of a GLB file."""
    _, _, length, size = np.frombuffer(data[:16].ljust(16, b"\0"), "<u4").tolist()
    if len(data) < max(length, _GLB_HEAD):
        raise LoadError(f"the file is cut short: {length:,} bytes announced, {len(data):,} there")
    return data[_GLB_HEAD : _GLB_HEAD + size]


def _refuse_what_trimesh_misses(tree: dict[str, Any], primitives: Sequence[dict[str, Any]]) -> None:
    extensions = _CHANGES_SHAPE.intersection(tree.get("extensionsUsed", []))
    if extensions:
        raise LoadError(f"it uses {', '.join(sorted(extensions))}, which is not read")
    accessors = tree.get("accessors", [])
    if any("sparse" in accessor or "bufferView" not in accessor for accessor in accessors):
        raise LoadError("it uses sparse or missing data, which is not read")
    if any(part.get("mode") == _FAN for part in primitives):
        raise LoadError("it uses triangle fans, which are not read")
    positions = [accessors[part["attributes"]["POSITION"]] for part in primitives]
    if any(position["componentType"] != _FLOAT32 for position in positions):
        raise LoadError("its coordinates are not 32-bit numbers, which are the only ones read")


def _check_sizes(tree: dict[str, Any], available: int) -> None:
    accessors = tree.get("accessors", [])
    if any(accessor["count"] < 1 for accessor in accessors):
        raise LoadError("it announces an array without entries")
    sizes = [
        accessor["count"] * _ITEMS[accessor["type"]] * _ITEM_BYTES[accessor["componentType"]]
        for accessor in accessors
    ]
    views = [view["byteLength"] for view in tree.get("bufferViews", [])]
    if max(sum(sizes), sum(views)) > _LARGEST_GROWTH * available:
        raise LoadError("it announces far more numbers than it holds")


def _buffer_files(tree: dict[str, Any], folder: Path) -> Iterator[tuple[str, bytes]]:
    """Read the files that hold the numbers; nothing outside the model's folder is touched."""
    for uri in {buffer.get("uri", "data:") for buffer in tree.get("buffers", [])}:
        if uri.startswith("data:"):
            continue
        file = (folder / unquote(uri)).resolve()
        if not file.is_relative_to(folder) or not file.is_file():
            raise LoadError(f"it needs the file {uri[:60]!r}, which is not beside it")
        yield uri, file.read_bytes()


def _parts(data: bytes, files: dict[str, bytes]) -> Iterator[Part]:
    """Let trimesh read the scene; parts come in the order of the file's meshes."""
    import trimesh

    kind = "glb" if data.startswith(_MAGIC) else "gltf"
    options = {"process": False, "skip_materials": True}
    scene = trimesh.load_scene(io.BytesIO(data), file_type=kind, resolver=files, **options)
    order = {name: number for number, name in enumerate(scene.geometry)}
    for name, matrix in sorted(_places(scene.graph), key=lambda place: order[place[0]]):
        geometry = scene.geometry[name]
        if isinstance(geometry, trimesh.Trimesh):
            yield Part(np.asarray(geometry.vertices), np.asarray(geometry.faces), matrix)


def _places(graph: Any) -> Iterator[tuple[str, FloatArray]]:
    """Name of the geometry of each node and its map into the scene.

    One walk down the tree: asking trimesh node by node takes quadratic time in deep trees.
    """
    forest = graph.transforms
    waiting = [(graph.base_frame, np.eye(4))]
    while waiting:
        node, matrix = waiting.pop()
        if "geometry" in forest.node_data[node]:
            yield forest.node_data[node]["geometry"], matrix
        for child in forest.children.get(node, []):
            local = forest.edge_data[node, child].get("matrix", np.eye(4))
            waiting.append((child, matrix @ local))
