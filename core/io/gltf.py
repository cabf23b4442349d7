"""glTF 2 and its binary form GLB; trimesh decodes the arrays.

trimesh passes over some things without a word: compressed and sparse data, triangle fans, scaled
integers, instances on the GPU, whatever hangs below a camera. Here the description is read first:
what trimesh cannot do is refused, what does not matter (cameras, points, lines) is taken out, and
sizes are compared with the file before memory is asked for.
"""

import io
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any, TypeAlias
from urllib.parse import unquote

import numpy as np

from core.arrays import FloatArray
from core.io.errors import LoadError, quoted
from core.io.parts import Part, join_parts
from core.io.polygons import Polygons, counted

Tree: TypeAlias = dict[str, Any]

_CHANGES_SHAPE = {
    "KHR_draco_mesh_compression",
    "EXT_meshopt_compression",
    "KHR_meshopt_compression",
    "EXT_mesh_gpu_instancing",
}
_MAGIC = b"glTF"
_HEAD = 12
_CHUNK_HEAD = 8
# Name under which the binary chunk of a GLB file is handed to trimesh.
_BINARY_CHUNK = "binary chunk"
_TRIANGLES, _FAN = 4, 6  # below 4 are points and lines
# Many arrays may look at one buffer; together more than this many times its size is a trap.
_LARGEST_GROWTH = 20
_ITEM_BYTES = {5120: 1, 5121: 1, 5122: 2, 5123: 2, 5125: 4, 5126: 4}
_ITEMS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT2": 4, "MAT3": 9, "MAT4": 16}
_FLOAT32 = 5126


def read_gltf(path: Path) -> Polygons:
    """Read the triangles of all nodes of the scene, each moved to its place."""
    text, binary = _chunks(path.read_bytes())
    tree = _tree(text)
    files = _buffer_files(tree, path.parent.resolve(), binary)
    size = len(text) + sum(map(len, files.values()))
    bare = _take_out_points_and_cameras(tree)
    _refuse_what_trimesh_misses(tree)
    _check_sizes(tree, size)
    left_out = (f"{counted(bare, 'part')} of points or lines left out",) if bare else ()
    return join_parts(_parts(tree, files), file_size=size, changes=left_out)


def _chunks(data: bytes) -> tuple[bytes, bytes]:
    """Return the description and, from a GLB file, the binary data."""
    if not data.startswith(_MAGIC):
        return data, b""
    length = int.from_bytes(data[8:_HEAD], "little")
    if len(data) < max(length, _HEAD + _CHUNK_HEAD):
        raise LoadError(f"the file is cut short: {length:,} bytes announced, {len(data):,} there")
    text, rest = _chunk(data[_HEAD:])
    return text, _chunk(rest)[0]


def _chunk(data: bytes) -> tuple[bytes, bytes]:
    """Return the content of the first chunk, and what follows it."""
    end = _CHUNK_HEAD + int.from_bytes(data[:4], "little")
    if len(data) < end and data:
        raise LoadError("the file is cut short: a chunk is longer than the file")
    return data[_CHUNK_HEAD:end], data[end:]


def _tree(text: bytes) -> Tree:
    try:
        tree = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise LoadError(f"it is no glTF file or cut short ({error})") from error
    if not isinstance(tree, dict):
        raise LoadError("it is no glTF file (its JSON is not an object)")
    return tree


def _buffer_files(tree: Tree, folder: Path, binary: bytes) -> dict[str, bytes]:
    """Read the files that hold the numbers; nothing outside the model's folder is touched."""
    files = {_BINARY_CHUNK: binary}
    for buffer in tree.get("buffers", []):
        uri = buffer.setdefault("uri", _BINARY_CHUNK)
        if uri in files or uri.startswith("data:"):
            continue
        file = (folder / unquote(uri)).resolve()
        if not file.is_relative_to(folder) or not file.is_file():
            raise LoadError(f"it needs the file {quoted(uri)}, which is not beside it")
        files[uri] = file.read_bytes()
    return files


def _take_out_points_and_cameras(tree: Tree) -> int:
    """Leave only what has a surface; return the number of parts that have none."""
    bare = 0
    for mesh in tree.get("meshes", []):
        surfaces = [part for part in mesh["primitives"] if _mode(part) >= _TRIANGLES]
        bare += len(mesh["primitives"]) - len(surfaces)
        mesh["primitives"] = surfaces
    for node in tree.get("nodes", []):
        node.pop("camera", None)
        if "mesh" in node and not tree["meshes"][node["mesh"]]["primitives"]:
            del node["mesh"]
    return bare


def _mode(primitive: Tree) -> int:
    mode: int = primitive.get("mode", _TRIANGLES)
    return mode


def _refuse_what_trimesh_misses(tree: Tree) -> None:
    extensions = _CHANGES_SHAPE.intersection(tree.get("extensionsUsed", []))
    if extensions:
        raise LoadError(f"it uses {', '.join(sorted(extensions))}, which is not read")
    children = [child for node in tree.get("nodes", []) for child in node.get("children", [])]
    if len(set(children)) < len(children):
        raise LoadError("its nodes do not form a tree")
    accessors = tree.get("accessors", [])
    if any("sparse" in accessor or "bufferView" not in accessor for accessor in accessors):
        raise LoadError("it uses sparse or missing data, which is not read")
    primitives = [part for mesh in tree.get("meshes", []) for part in mesh["primitives"]]
    if any(_mode(part) == _FAN for part in primitives):
        raise LoadError("it uses triangle fans, which are not read")
    positions = [accessors[part["attributes"]["POSITION"]] for part in primitives]
    if any(position["componentType"] != _FLOAT32 for position in positions):
        raise LoadError("its coordinates are not 32-bit numbers, which are the only ones read")


def _check_sizes(tree: Tree, available: int) -> None:
    accessors = tree.get("accessors", [])
    if any(accessor["count"] < 1 for accessor in accessors):
        raise LoadError("it announces an array without entries")
    sizes = [
        accessor["count"] * _ITEMS[accessor["type"]] * _ITEM_BYTES[accessor["componentType"]]
        for accessor in accessors
    ]
    views = [view["byteLength"] for view in tree.get("bufferViews", [])]
    if max(sum(sizes), sum(views)) > _LARGEST_GROWTH * available:
        raise LoadError("the file is cut short: it announces far more numbers than it holds")


def _parts(tree: Tree, files: dict[str, bytes]) -> Iterator[Part]:
    """Let trimesh decode the scene; parts come in the order of the file's meshes."""
    import trimesh

    text = io.BytesIO(json.dumps(tree).encode())
    options = {"process": False, "skip_materials": True}
    scene = trimesh.load_scene(text, file_type="gltf", resolver=files, **options)
    places = list(_places(scene.graph))
    if len(places) < len(scene.graph.nodes_geometry):
        raise LoadError("its nodes do not form a tree")
    order = {name: number for number, name in enumerate(scene.geometry)}
    for name, matrix in sorted(places, key=lambda place: order[place[0]]):
        geometry = scene.geometry[name]
        yield Part(np.asarray(geometry.vertices), np.asarray(geometry.faces), matrix)


def _places(graph: Any) -> Iterator[tuple[str, FloatArray]]:
    """Name of the geometry of each node, and its map into the scene.

    One walk down the tree: asking trimesh node by node takes quadratic time in deep trees.
    """
    forest, children = graph.transforms, graph.transforms.children
    waiting = [(graph.base_frame, np.eye(4))]
    while waiting:
        node, matrix = waiting.pop()
        if "geometry" in forest.node_data[node]:
            yield forest.node_data[node]["geometry"], matrix
        for child in children.get(node, []):
            local = forest.edge_data[node, child].get("matrix", np.eye(4))
            waiting.append((child, matrix @ local))
