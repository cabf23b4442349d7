"""Height along a direction, the field that Reeb graphs were first drawn with."""

import numpy as np

from core.arrays import FloatArray
from core.fields.centred import centred_vertices
from core.fields.spec import FieldSpec
from core.mesh import TriangleMesh
from core.parameters import ParameterError, Params, param


class HeightParams(Params):
    """Direction of the height; only its direction counts, not its length."""

    x: float = param(0.0, low=-1, high=1, step=0.1, help="First coordinate of the direction.")
    y: float = param(0.0, low=-1, high=1, step=0.1, help="Second coordinate of the direction.")
    z: float = param(1.0, low=-1, high=1, step=0.1, help="Third coordinate of the direction.")


def evaluate(mesh: TriangleMesh, params: HeightParams) -> FloatArray:
    """Height h(v) = ⟨v − c, d⟩ / ‖d‖ over the centroid, (m,), in model units.

    Parameters
    ----------
    mesh : TriangleMesh
        The mesh.
    params : HeightParams
        The direction d.

    Raises
    ------
    ParameterError
        If the direction is (0, 0, 0).

    Notes
    -----
    It turns with the direction, not with the model: unlike the distances it is not invariant
    to rotation.

    References
    ----------
    Shinagawa, Kunii, Kergosien, "Surface coding based on Morse theory", 1991; thesis §4.3.1.
    """
    direction = np.array([params.x, params.y, params.z])
    length = np.linalg.norm(direction)
    if length == 0:
        raise ParameterError("height: the direction is (0, 0, 0); one of x, y, z must not be 0.")
    heights: FloatArray = centred_vertices(mesh) @ (direction / length)
    return heights


SPEC = FieldSpec(
    id="height",
    title="Height",
    params=HeightParams,
    evaluate=evaluate,
    summary="Height along a direction.",
    formula="h(v) = ⟨v − c, d⟩ / ‖d‖",
    reference="Shinagawa, Kunii, Kergosien 1991; thesis §4.3.1",
    is_squared=False,
)
