"""A field on a mesh, normalised to [0, 1]."""

from dataclasses import dataclass

import numpy as np

from core.arrays import FloatArray, frozen
from core.fields.centred import surface_vertices
from core.mesh import MeshError, TriangleMesh
from core.parameters import Params

# Values are rounded to this many decimals of the range. Symmetric vertices then have equal
# values whatever position or attitude the model has, instead of values that differ in the last bit.
_DECIMALS = 12


@dataclass(frozen=True, eq=False)
class ScalarField:
    """One value per vertex, normalised to [0, 1].

    Attributes
    ----------
    name : str
        Id of the field.
    values : (m,) float64 ndarray
        Normalised values, read-only: 0 at the smallest raw value, 1 at the largest.
    raw_range : tuple of float
        Smallest and largest raw value on the surface; squared model units for the Euclidean
        distance, model units for the height, no unit for the others.
    params : Params or None
        What the field was computed with.
    notes : tuple of str
        Sentences about what was done differently on this mesh.
    is_squared : bool
        Whether the raw values are squared distances.
    """

    name: str
    values: FloatArray
    raw_range: tuple[float, float]
    params: Params | None = None
    notes: tuple[str, ...] = ()
    is_squared: bool = False

    @property
    def is_constant(self) -> bool:
        """Whether all vertices of the surface have one value, so that there is nothing to cut."""
        return self.raw_range[0] == self.raw_range[1]

    def raw(self, values: FloatArray | float) -> FloatArray:
        """Turn normalised values back into raw ones."""
        low, high = self.raw_range
        return low + np.asarray(values, np.float64) * (high - low)


def normalise(
    mesh: TriangleMesh,
    raw: FloatArray,
    name: str = "custom",
    *,
    params: Params | None = None,
    notes: tuple[str, ...] = (),
    is_squared: bool = False,
) -> ScalarField:
    """Normalise raw values to [0, 1]: f(v) = (d(v) − d_min) / (d_max − d_min), §4.4.4.

    Parameters
    ----------
    mesh : TriangleMesh
        The mesh. Vertices without a face do not count for the range; theirs are clipped.
    raw : (m,) array of float
        Any finite values, one a vertex.
    name, params, notes, is_squared
        Kept in the field.

    Returns
    -------
    ScalarField
        Zeros with a note where the values differ by nothing but rounding.

    Raises
    ------
    MeshError
        If there are no vertices, not one value a vertex, or a value is not finite.
    """
    values = np.asarray(raw, np.float64)
    if not len(mesh.vertices) or values.shape != (len(mesh.vertices),):
        raise MeshError(
            f"field {name}: {values.size} values for {len(mesh.vertices)} vertices; "
            "allowed is one value a vertex, and at least one vertex."
        )
    if not np.isfinite(values).all():
        raise MeshError(f"field {name} has values that are not finite on this mesh.")
    surface = values[surface_vertices(mesh)]
    low, high = float(surface.min()), float(surface.max())
    if high - low <= 10.0**-_DECIMALS * max(abs(low), abs(high)):
        notes = (*notes, f"The field {name} is constant on this mesh.")
        values, high = np.zeros(len(values)), low
    else:
        values = np.clip((values - low) / (high - low), 0, 1).round(_DECIMALS)
    frozen(values)
    return ScalarField(name, values, (low, high), params, notes, is_squared)
