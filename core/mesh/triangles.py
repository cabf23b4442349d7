"""Products of the edges of a triangle, which areas, normals and angles are made of."""

from core.arrays import FloatArray
from core.kernels import kernel


@kernel
def triangle_vector(vertices: FloatArray, i: int, j: int, k: int) -> tuple[float, float, float]:
    """(vⱼ − vᵢ) × (vₖ − vᵢ): twice the area times the unit normal of a triangle."""
    ax = vertices[j, 0] - vertices[i, 0]
    ay = vertices[j, 1] - vertices[i, 1]
    az = vertices[j, 2] - vertices[i, 2]
    bx = vertices[k, 0] - vertices[i, 0]
    by = vertices[k, 1] - vertices[i, 1]
    bz = vertices[k, 2] - vertices[i, 2]
    return ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx


@kernel
def corner_product(vertices: FloatArray, i: int, j: int, k: int) -> float:
    """⟨vⱼ − vᵢ, vₖ − vᵢ⟩ at the corner i of a triangle."""
    product = 0.0
    for x in range(3):
        product += (vertices[j, x] - vertices[i, x]) * (vertices[k, x] - vertices[i, x])
    return product
