"""From a mesh and a field to its skeletal graph, thesis table 5.1."""

from typing import NamedTuple, get_args

import numpy as np

from core.arrays import FloatArray, IntArray, frozen
from core.fields import ScalarField, scalar_field
from core.fields.centred import surface_vertices
from core.mesh import MeshError, TriangleMesh
from core.mesh.geometry import face_areas
from core.parameters import ParameterError
from core.skeleton.bands import NO_FACES, band_components, distinct_pairs
from core.skeleton.cut import cut_pieces
from core.skeleton.elements import face_pieces
from core.skeleton.graph import ROOT_BAND, Bands, Pieces, SkeletalGraph, label_components
from core.skeleton.levels import Spacing, band_levels, vertex_bands
from core.skeleton.slices import node_moments


def skeletal_graph(
    mesh: TriangleMesh,
    field: str = "mixture",
    resolution: int = 22,
    bands: Bands = "exact",
    spacing: Spacing = "value",
    root: bool = False,
    **params: object,
) -> SkeletalGraph:
    """Draw the skeletal graph of a mesh.

    The field is cut into R bands. Each connected component of the surface within a band becomes
    a node, and an arc joins two components that share a piece of level curve.

    Parameters
    ----------
    mesh : TriangleMesh
        Any mesh with faces: closed or open, manifold or not, in one part or many.
    field : str
        Id of a field in :data:`core.fields.FIELDS`.
    resolution : int
        Number of bands R, 1 to 1024; more bands show finer branches and shorter loops.
    bands : {"exact", "vertices"}
        ``exact`` cuts the faces at the levels. ``vertices`` is the printed algorithm: it
        collects the vertices of each band and joins them along edges.
    spacing : {"value", "distance", "area"}
        How the levels are spaced, see :func:`~core.skeleton.levels.band_levels`.
    root : bool
        Join the centroid to the nodes of the first band (chapter 5) or not (chapter 4).
    **params
        Parameters of the field.

    Returns
    -------
    SkeletalGraph
        Loops and components are counted without the root.

    Raises
    ------
    ParameterError
        If a name or a value is not allowed.
    MeshError
        If the mesh has no faces.

    Notes
    -----
    With exact bands a closed, orientable, connected surface never has more loops than its genus,
    at any resolution and on any tessellation. The printed ``vertices`` have no such bound: where
    an edge spans more than one band its components fall apart and false loops appear.

    The cost is O(n + n·s), where s is the mean number of levels that a face crosses.

    References
    ----------
    Zhang, *Geometric Smoothing and Modeling of 3D Graphics*, table 5.1.

    Examples
    --------
    >>> from core.mesh import primitives
    >>> skeletal_graph(primitives.torus(), "height", 8, x=1, z=0)
    SkeletalGraph(10 nodes, 10 arcs, 1 loops, 1 components)
    """
    values = scalar_field(mesh, field, **params)
    levels = band_levels(mesh, values, resolution, spacing)
    return graph_of(mesh, values, levels, bands=bands, root=root)


def graph_of(
    mesh: TriangleMesh,
    field: ScalarField,
    levels: FloatArray,
    *,
    bands: Bands = "exact",
    root: bool = False,
) -> SkeletalGraph:
    """Draw the skeletal graph of a field that is already there, for a change of resolution.

    Parameters
    ----------
    mesh : TriangleMesh
        The mesh of the field.
    field : ScalarField
        A normalised field.
    levels : (R − 1,) float64 ndarray
        Ascending levels, as from :func:`~core.skeleton.levels.band_levels`.
    bands, root
        As for :func:`skeletal_graph`.

    Returns
    -------
    SkeletalGraph
        The graph.

    Raises
    ------
    ParameterError
        If `bands` is not one of the two.
    MeshError
        If the mesh has no faces, or the field belongs to another mesh.
    """
    if bands not in get_args(Bands):
        raise ParameterError(f"bands={bands} is not one of {', '.join(get_args(Bands))}.")
    check_field(mesh, field)
    parts = (_exact_graph if bands == "exact" else _vertex_graph)(mesh, field, levels)
    top = len(parts.nodes) if root else None
    if root:
        parts = _with_root(mesh, parts)
    for array in (*parts[:-1], *parts.pieces):
        frozen(array)
    return SkeletalGraph(
        nodes=parts.nodes,
        arcs=parts.arcs,
        band=parts.band,
        area=parts.area,
        component=parts.component,
        root=top,
        resolution=len(levels) + 1,
        field=field.name,
        bands=bands,
        pieces=parts.pieces,
    )


def check_field(mesh: TriangleMesh, field: ScalarField) -> None:
    """Raise MeshError unless the mesh has faces and the field has one value for each vertex."""
    if not len(mesh.faces):
        raise MeshError("The mesh has no faces; a graph needs a surface.")
    if len(field.values) != len(mesh.vertices):
        raise MeshError(
            f"The field has {len(field.values)} values; the mesh has {len(mesh.vertices)} vertices."
        )


class _Parts(NamedTuple):
    nodes: FloatArray
    arcs: IntArray
    band: IntArray
    area: FloatArray
    component: IntArray
    pieces: Pieces


def _exact_graph(mesh: TriangleMesh, field: ScalarField, levels: FloatArray) -> _Parts:
    bands = vertex_bands(field.values, levels)
    sides = mesh.topology.face_edges
    found = band_components(bands, mesh.edges, mesh.faces, sides, surface_vertices(mesh))
    starts, members = face_pieces(bands, mesh.edges, mesh.faces, sides, found.starts, found.nodes)
    pieces = Pieces(starts, members, found.nodes[: len(bands)].copy(), levels.copy())
    sums = node_moments(
        mesh.vertices, mesh.faces, field.values, bands, levels, starts, members, len(found.bands)
    )
    nodes = _centroids(mesh, field, sums, pieces)
    component = label_components(len(nodes), found.arcs)
    return _Parts(nodes, found.arcs, found.bands, sums[:, 0].copy(), component, pieces)


def _centroids(
    mesh: TriangleMesh, field: ScalarField, sums: FloatArray, pieces: Pieces
) -> FloatArray:
    has_area = sums[:, 0] > 0
    nodes = np.divide(
        sums[:, 1:], sums[:, :1], out=np.zeros((len(sums), 3)), where=has_area[:, None]
    )
    # Peaks exactly on a level and collapsed faces have no area; the mean of the corners is left.
    for node in np.flatnonzero(~has_area):
        nodes[node] = cut_pieces(mesh, field, pieces, pieces.nodes == node).points.mean(axis=0)
    return nodes


def _vertex_graph(mesh: TriangleMesh, field: ScalarField, levels: FloatArray) -> _Parts:
    bands = vertex_bands(field.values, levels)
    inside = np.equal(*bands[mesh.edges].T)
    within = mesh.edges[inside]
    frozen(within)
    found = band_components(bands, within, NO_FACES, NO_FACES, surface_vertices(mesh))
    count = len(found.bands)
    # An edge may skip bands; it joins the components at its ends all the same.
    arcs = distinct_pairs(np.sort(found.nodes[mesh.edges[~inside]], axis=1), count)
    corners = found.nodes[mesh.faces].ravel()
    member = found.nodes[found.nodes >= 0]
    points = mesh.vertices[found.nodes >= 0]
    sums = np.stack([np.bincount(member, points[:, x], count) for x in range(3)], axis=1)
    return _Parts(
        nodes=sums / np.bincount(member, minlength=count)[:, None],
        arcs=arcs,
        band=found.bands,
        area=np.bincount(corners, np.repeat(face_areas(mesh) / 3, 3), count).astype(np.float64),
        component=label_components(count, arcs),
        pieces=Pieces(
            np.arange(0, len(corners) + 1, 3, dtype=np.int32), corners, found.nodes, levels.copy()
        ),
    )


def _with_root(mesh: TriangleMesh, parts: _Parts) -> _Parts:
    """Append the centroid and join it to the nodes of the first band, table 5.1 steps 5 and 6."""
    first = np.flatnonzero(parts.band == 0).astype(np.int32)
    spokes = np.stack([np.full_like(first, len(parts.nodes)), first], axis=1)
    centre = mesh.vertices[surface_vertices(mesh)].mean(axis=0)
    return parts._replace(
        nodes=np.vstack([parts.nodes, centre]),
        arcs=np.vstack([parts.arcs, spokes]),
        band=np.append(parts.band, np.int32(ROOT_BAND)),
        area=np.append(parts.area, 0.0),
        component=np.append(parts.component, np.int32(ROOT_BAND)),
    )
