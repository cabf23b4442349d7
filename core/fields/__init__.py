"""Fields: one value per vertex, each field in its own file, listed here in display order."""

from core.fields import affine, euclidean, height, mixture
from core.fields.critical import CriticalVertices, critical_vertices, vertex_ranks
from core.fields.scalar import ScalarField, normalise
from core.fields.spec import FieldSpec
from core.mesh import TriangleMesh
from core.parameters import ParameterError, build_params

FIELDS: dict[str, FieldSpec] = {
    spec.id: spec for spec in (mixture.SPEC, euclidean.SPEC, affine.SPEC, height.SPEC)
}
"""All fields by id, in the order in which they are shown; the first is the default."""

__all__ = [
    "FIELDS",
    "CriticalVertices",
    "FieldSpec",
    "ScalarField",
    "critical_vertices",
    "field_spec",
    "normalise",
    "scalar_field",
    "vertex_ranks",
]


def field_spec(name: str) -> FieldSpec:
    """Look up a field by its id.

    Raises
    ------
    ParameterError
        If there is no such field; names all that there are.
    """
    if name not in FIELDS:
        raise ParameterError(f"{name} is not a field; allowed: {', '.join(FIELDS)}.")
    return FIELDS[name]


def scalar_field(mesh: TriangleMesh, name: str = "mixture", **params: object) -> ScalarField:
    """Evaluate a field on a mesh and normalise it to [0, 1].

    Parameters
    ----------
    mesh : TriangleMesh
        The mesh.
    name : str
        Id of a field in :data:`FIELDS`.
    **params
        Parameters of the field; those not given take their declared defaults.

    Returns
    -------
    ScalarField
        The normalised values, the range they had, and notes about this mesh.

    Raises
    ------
    ParameterError
        If the field or a parameter is not allowed.
    MeshError
        If the mesh has no vertices, or the values are not finite.

    Examples
    --------
    >>> from core.mesh import primitives
    >>> field = scalar_field(primitives.grid(2, 1), "height", x=1, z=0)
    >>> field.values.tolist(), field.raw_range
    ([0.0, 0.5, 1.0, 0.0, 0.5, 1.0], (-1.0, 1.0))
    """
    spec = field_spec(name)
    declared = build_params(spec.params, params, name)
    return normalise(
        mesh,
        spec.evaluate(mesh, declared),
        name,
        params=declared,
        notes=spec.notes(mesh),
        is_squared=spec.is_squared,
    )
