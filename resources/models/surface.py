"""From a field to a triangle mesh of evenly sized, well-shaped faces.

The field is sampled on a grid and its zero set cut out (flying edges). That dense mesh is then
divided into as many cells as vertices are wanted, each as round as can be (Lloyd's iteration);
the mesh we want is the dual: a vertex for each cell, a face where three cells meet.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import pyvista
import trimesh
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from resources.models.implicit import Array, Field, project

Faces = NDArray[np.int64]
Density = Callable[[Array], Array]

BLOCK = 8


class Mesh(NamedTuple):
    """Vertices (m, 3) and faces (n, 3), wound outwards."""

    vertices: Array
    faces: Faces


def even_mesh(
    field: Field,
    box: tuple[Array, Array],
    count: int,
    *,
    cell: float,
    density: Density = lambda points: np.ones(len(points)),
    rounds: int = 60,
    seed: int = 0,
) -> Mesh:
    """Mesh the zero set of a field inside a box with `count` vertices.

    Parameters
    ----------
    field : Field
        Negative inside; its zero set must not touch the box.
    box : pair of (3,) array
        Lowest and highest corner.
    count : int
        Number of vertices; a closed surface of genus g gets 2·count − 4 + 4·g faces.
    cell : float
        Grid spacing; no more than the mean edge length of the result.
    density : callable
        Weight of a place: four times the weight makes its edges 1/√2 as long.
    rounds : int
        Lloyd iterations: more make the faces more even.
    seed : int
        Chooses the first vertices.
    """
    dense = contour(field, *box, cell)
    area = vertex_areas(dense).sum()
    dense = refined(dense, 0.32 * np.sqrt(2 / np.sqrt(3) * area / count))
    centers, labels = cells(dense, count, density, rounds, seed)
    return Mesh(project(field, centers), dual(dense.faces, labels))


def contour(field: Field, low: Array, high: Array, cell: float) -> Mesh:
    """Zero set of the field inside a box as a dense mesh."""
    values = _sample(field, low, np.ceil((high - low) / cell).astype(np.int64), cell)
    grid = pyvista.ImageData(dimensions=values.shape, spacing=(cell,) * 3, origin=low)
    grid["field"] = values.ravel(order="F")
    skin = grid.contour([0.0], method="flying_edges", compute_normals=False)
    inwards = skin.regular_faces.astype(np.int64)
    return Mesh(np.asarray(skin.points, np.float64), inwards[:, ::-1])


def _sample(field: Field, low: Array, shape: NDArray[np.int64], cell: float) -> Array:
    """Values on a grid of at least `shape` points: exact near the surface, rough elsewhere."""
    blocks = -(-shape // BLOCK)
    middles = np.stack(np.meshgrid(*map(np.arange, blocks), indexing="ij"), axis=-1) + 0.5
    rough = field((low + middles * BLOCK * cell).reshape(-1, 3)).reshape(blocks)
    values = np.kron(rough, np.ones((BLOCK,) * 3))
    near = np.argwhere(np.abs(values) < np.sqrt(3) * BLOCK * cell)
    values[tuple(near.T)] = field(low + near * cell)
    return values


def refined(mesh: Mesh, length: float) -> Mesh:
    """Split all faces in four until the mean edge is no longer than `length`."""
    vertices, faces = mesh
    while np.linalg.norm(vertices[faces[:, 0]] - vertices[faces[:, 1]], axis=1).mean() > length:
        vertices, faces = trimesh.remesh.subdivide(vertices, faces)
    return Mesh(vertices, faces)


def vertex_areas(mesh: Mesh) -> Array:
    """A third of the area of the faces around each vertex."""
    a, b, c = mesh.vertices[mesh.faces].transpose(1, 0, 2)
    areas = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 6
    return np.bincount(mesh.faces.ravel(), np.repeat(areas, 3), len(mesh.vertices))


def cells(
    mesh: Mesh, count: int, density: Density, rounds: int, seed: int
) -> tuple[Array, NDArray[np.int64]]:
    """Divide the vertices into `count` round cells; return the centres and each vertex' cell.

    Lloyd's iteration: every vertex belongs to the nearest centre, every centre moves to the
    middle of its cell.
    """
    vertices, areas, wanted = mesh.vertices, vertex_areas(mesh), density(mesh.vertices)
    # The optimal cells have an area that goes with the inverse root of the weight.
    chance = areas * np.sqrt(wanted)
    rng = np.random.default_rng(seed)
    centers = vertices[rng.choice(len(vertices), count, replace=False, p=chance / chance.sum())]
    weights = areas * wanted
    for step in range(rounds):
        labels = cKDTree(centers).query(vertices)[1]
        sums = [np.bincount(labels, weights * x, count) for x in vertices.T]
        middles = np.stack(sums, axis=1) / np.bincount(labels, weights, count)[:, None]
        # Going beyond the middle converges sooner; the last rounds settle.
        centers = centers + (1.6 if step < rounds - 5 else 1.0) * (middles - centers)
    return centers, cKDTree(centers).query(vertices)[1]


def dual(faces: Faces, labels: NDArray[np.int64]) -> Faces:
    """Faces that join three cells, for each place where three cells meet.

    Where the border of two cells runs to and fro, the same three meet in opposite senses; such
    pairs cancel, so that the image of a closed surface is closed.
    """
    corners = labels[faces]
    corners = corners[(corners != np.roll(corners, 1, axis=1)).all(axis=1)]
    order = np.argsort(corners, axis=1)
    sense = np.where((order[:, 1] - order[:, 0]) % 3 == 1, 1, -1)
    triples, which = np.unique(
        np.take_along_axis(corners, order, axis=1), axis=0, return_inverse=True
    )
    turns = np.bincount(which.ravel(), sense, len(triples))
    return np.concatenate([triples[turns > 0], triples[turns < 0, ::-1]])
