"""Levels: the values at which a field is cut into bands."""

from collections.abc import Callable
from functools import partial
from typing import Literal, TypeAlias, get_args

import numpy as np

from core.arrays import FloatArray, IntArray
from core.fields import ScalarField
from core.kernels import kernel
from core.mesh import TriangleMesh
from core.mesh.geometry import face_areas
from core.parameters import ParameterError

Spacing = Literal["value", "distance", "area"]
"""Equal steps of the field, of its root, or of the surface area."""

LevelRule: TypeAlias = Callable[[int], FloatArray]
"""Gives the R − 1 levels of a resolution R."""

RESOLUTION_LIMIT = 1024
_AREA_SAMPLES = 512


def band_levels(
    mesh: TriangleMesh, field: ScalarField, resolution: int = 22, spacing: Spacing = "value"
) -> FloatArray:
    """Place the R − 1 levels that cut a field into R bands.

    Parameters
    ----------
    mesh : TriangleMesh
        The mesh of the field.
    field : ScalarField
        A normalised field.
    resolution : int
        Number of bands R, 1 to 1024; more bands show finer features.
    spacing : {"value", "distance", "area"}
        Equal steps of the field, which for the distance fields is the squared distance (thesis);
        equal steps of the distance, its root (the field itself where it is no square); or bands
        of equal area, to within a thousandth of the surface.

    Returns
    -------
    (R − 1,) float64 ndarray
        Normalised values in ascending order. Band k holds the values from level k up to, but
        without, level k + 1; the last band includes the largest value.

    Raises
    ------
    ParameterError
        If the resolution or the spacing is not allowed.

    References
    ----------
    Zhang, *Geometric Smoothing and Modeling of 3D Graphics*, table 5.1, steps 2 and 3.
    """
    return level_rule(mesh, field, spacing)(resolution)


def level_rule(mesh: TriangleMesh, field: ScalarField, spacing: Spacing = "value") -> LevelRule:
    """Prepare the levels of a field for many resolutions, as under a slider.

    Parameters
    ----------
    mesh, field, spacing
        As for :func:`band_levels`.

    Returns
    -------
    callable
        ``rule(resolution)`` gives the levels.

    Raises
    ------
    ParameterError
        If the spacing is not allowed; the rule raises it if the resolution is not.
    """
    if spacing not in get_args(Spacing):
        raise ParameterError(f"spacing={spacing} is not one of {', '.join(get_args(Spacing))}.")
    place = _equal_values
    if spacing == "distance" and field.is_squared and not field.is_constant:
        place = partial(_equal_distances, *field.raw_range)
    elif spacing == "area":
        place = partial(_equal_areas, *_area_samples(mesh, field))

    def rule(resolution: int) -> FloatArray:
        if not 1 <= resolution <= RESOLUTION_LIMIT:
            raise ParameterError(
                f"resolution={resolution} is not allowed; use 1 to {RESOLUTION_LIMIT}."
            )
        return place(np.arange(1, resolution) / resolution)

    return rule


def vertex_bands(values: FloatArray, levels: FloatArray) -> IntArray:
    """Band of each vertex, (m,) int32: the number of levels that are not above its value."""
    return np.searchsorted(levels, values, side="right").astype(np.int32)


def _equal_values(shares: FloatArray) -> FloatArray:
    return shares


def _equal_distances(low: float, high: float, shares: FloatArray) -> FloatArray:
    near, far = np.sqrt(low), np.sqrt(high)
    levels: FloatArray = ((near + shares * (far - near)) ** 2 - low) / (high - low)
    return levels


def _equal_areas(samples: FloatArray, below: FloatArray, shares: FloatArray) -> FloatArray:
    total = below[-1]
    return np.interp(shares, below / total, samples) if total > 0 else shares


def _area_samples(mesh: TriangleMesh, field: ScalarField) -> tuple[FloatArray, FloatArray]:
    """Values of the field in ascending order, and the area of the surface up to each."""
    # Quantiles of the vertices put many samples where many faces are.
    values = np.sort(field.values)
    picks = np.linspace(0, len(values) - 1, min(_AREA_SAMPLES, len(values))).astype(np.intp)
    samples = np.unique(values[picks])
    return samples, area_below(field.values, mesh.faces, face_areas(mesh), samples)


@kernel
def _share_below(low: float, middle: float, high: float, level: float) -> float:
    """Share of a triangle's area where its linear field is at most `level`."""
    if level >= high:
        return 1.0
    if level <= low:
        return 0.0
    if level <= middle:
        return (level - low) / (middle - low) * (level - low) / (high - low)
    return 1.0 - (high - level) / (high - middle) * (high - level) / (high - low)


@kernel
def area_below(
    values: FloatArray, faces: IntArray, areas: FloatArray, samples: FloatArray
) -> FloatArray:
    """Area of the surface where the field is at most each of the ascending samples, (s,)."""
    total = np.zeros(len(samples))
    for t in range(len(faces)):
        a, b, c = values[faces[t, 0]], values[faces[t, 1]], values[faces[t, 2]]
        low, high = min(a, b, c), max(a, b, c)
        middle = max(min(a, b), min(max(a, b), c))
        k = np.searchsorted(samples, low)
        before = 0.0
        # Each face adds only the growth from sample to sample; the running sum does the rest.
        while k < len(samples) and before < 1.0:
            share = _share_below(low, middle, high, samples[k])
            total[k] += areas[t] * (share - before)
            before = share
            k += 1
    return np.cumsum(total)
