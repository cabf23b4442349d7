"""Two rings melted into one smooth surface of genus 2, lying flat, z up.

The long side faces a camera at (1, 1, 1).
"""

import numpy as np

from resources.models.implicit import Field, ring, union
from resources.models.surface import Mesh, even_mesh

VERTICES = 5_000
BOX = np.array([-2.4, -2.4, -0.6]), np.array([2.4, 2.4, 0.6])
RADIUS, THICKNESS = 1.0, 0.38


def double_torus() -> Mesh:
    """Make the mesh."""
    return even_mesh(body(), BOX, VERTICES, cell=0.04)


def body() -> Field:
    """Two rings side by side along (1, −1, 0)."""
    apart = 0.76 * RADIUS
    rings = [ring([side * apart, -side * apart, 0], RADIUS, THICKNESS) for side in (1, -1)]
    return union(0.45, *rings)
