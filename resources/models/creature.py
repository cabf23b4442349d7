"""A young horned animal, about 1 high: smooth and closed, genus 0, facing +x, z up.

The head looks a little to its left, towards a camera at (1, 1, 1). Large calm areas (back, belly)
lie beside folds, eyes, hooves and ringed horns, so that a denoiser has something to keep.
"""

import numpy as np

from resources.models.implicit import (
    Array,
    Field,
    bump,
    cut,
    ellipsoid,
    half_space,
    mirrored,
    placed,
    project,
    raised,
    stretched,
    tube,
    union,
)
from resources.models.surface import Mesh, even_mesh

VERTICES = 15_900
BOX = np.array([-0.65, -0.40, -0.05]), np.array([0.80, 0.50, 1.25])

HEAD = np.array([0.345, 0.05, 0.765])
EYE = np.array([0.105, 0.098, 0.030])


def creature() -> Mesh:
    """Make the mesh."""
    return even_mesh(body(), BOX, VERTICES, cell=0.010, density=detail)


def detail(points: Array) -> Array:
    """Weight of a place: head and hooves get edges two thirds as long as the back."""
    near_head = bump(HEAD + np.array([0.08, 0.03, 0.05]), 0.55)(points)
    near_ground = np.clip(1 - points[:, 2] / 0.2, 0, 1)
    return 1 + 6 * np.maximum(near_head, near_ground)


def body() -> Field:
    """The whole animal."""
    return union(0.06, union(0.05, torso(), tail()), placed(head(), turned(26, -7), HEAD))


def torso() -> Field:
    """Barrel, belly, rump and neck on four legs."""
    barrel = tube([[-0.17, 0, 0.445], [0, 0, 0.43], [0.15, 0, 0.45]], [0.165, 0.178, 0.165])
    belly = ellipsoid([-0.01, 0, 0.40], [0.17, 0.17, 0.13])
    rump = ellipsoid([-0.20, 0, 0.465], [0.14, 0.155, 0.14])
    neck = tube([[0.13, 0, 0.49], [0.23, 0.01, 0.59], [0.29, 0.03, 0.71]], [0.145, 0.13, 0.125])
    legs = [front_leg(1, 0.03), front_leg(-1, -0.02), hind_leg(1, -0.03), hind_leg(-1, 0.02)]
    trunk = union(0.12, barrel, belly, rump, neck)
    skin = raised(union(0.09, trunk, *[leg for leg, _ in legs]), neck_folds)
    return union(0.01, skin, *[hoof for _, hoof in legs])


def neck_folds(points: Array) -> Array:
    """Soft rolls of skin across the throat."""
    along = (points - [0.24, 0.01, 0.58]) @ [0.587, 0.039, 0.809]
    return 0.006 * np.sin(2 * np.pi * along / 0.062) * bump([0.32, 0.03, 0.56], 0.19)(points)


def front_leg(side: int, step: float) -> tuple[Field, Field]:
    """Leg and hoof of one side, the foot set forward by `step`."""
    x, y = 0.165, 0.115 * side
    path = [[x - 0.015, 0.09 * side, 0.46], [x, y, 0.30]]
    path += [[x - 0.005 + 0.4 * step, y, 0.18], [x + step, y, 0.07]]
    return tube(path, [0.095, 0.080, 0.058, 0.057]), hoof(x + step, y)


def hind_leg(side: int, step: float) -> tuple[Field, Field]:
    """Leg and hoof of one side, bent at the hock, the foot set forward by `step`."""
    x, y = -0.205, 0.12 * side
    path = [[x + 0.025, 0.08 * side, 0.46], [x + 0.035, 0.115 * side, 0.32]]
    path += [[x - 0.02 + 0.4 * step, y, 0.185], [x + step, y, 0.07]]
    return tube(path, [0.12, 0.10, 0.062, 0.057]), hoof(x + step, y)


def hoof(x: float, y: float) -> Field:
    """A cloven hoof that stands flat on the ground."""
    whole = tube([[x - 0.004, y, 0.075], [x + 0.010, y, 0.01]], [0.057, 0.070])
    cleft = tube([[x + 0.098, y, -0.02], [x + 0.070, y, 0.085]], [0.024, 0.006])
    return cut(0.03, whole, half_space([0, 0, 0], [0, 0, 1]), cleft)


def tail() -> Field:
    """A lifted tail with a tuft."""
    path = [[-0.28, 0, 0.50], [-0.37, 0.02, 0.585], [-0.455, 0.05, 0.58]]
    path += [[-0.50, 0.07, 0.49], [-0.51, 0.075, 0.40]]
    tuft = [[-0.50, 0.07, 0.47], [-0.52, 0.078, 0.40], [-0.505, 0.087, 0.32]]
    hair = tube(tuft, [0.024, 0.042, 0.040, 0.014], pointed=True)
    return union(0.015, tube(path, [0.04, 0.028, 0.026, 0.024, 0.024]), hair)


def head() -> Field:
    """The head in its own frame: looks along +x, the middle of the skull at the origin."""
    bare = skull()
    face = union(0.02, cut(0.03, bare, mouth(bare), nostrils()), eyelids())
    seeing = union(0.010, face, eyes())
    ears = mirrored(placed(ear(), turned(18, 0, 6), [-0.03, 0.125, 0.045]))
    horned = union(0.02, union(0.03, seeing, ears), mirrored(horn()))
    return stretched(union(0.02, horned, forelock(bare)), [1.08] * 3)


def skull() -> Field:
    """Head without eyes, ears and horns."""
    brain = ellipsoid([0, 0, 0], [0.16, 0.152, 0.155])
    nose = tube([[0.03, 0, 0], [0.19, 0, -0.055]], [0.115, 0.08])
    muzzle = ellipsoid([0.205, 0, -0.075], [0.095, 0.108, 0.082])
    cheek = ellipsoid([0.06, 0.072, -0.065], [0.09, 0.065, 0.075])
    other = ellipsoid([0.06, -0.072, -0.065], [0.09, 0.065, 0.075])
    jaw = tube([[0, 0, -0.07], [0.18, 0, -0.11]], [0.08, 0.06])
    return union(0.08, brain, nose, muzzle, union(0.03, cheek, other), jaw)


def mouth(face: Field) -> Field:
    """A groove along the face, from one corner of the smile to the other."""
    left = np.array([[0.12, 0.12, -0.055], [0.19, 0.11, -0.098], [0.265, 0.06, -0.11]])
    path = np.concatenate([left, [[0.284, 0, -0.11]], left[::-1] * [1, -1, 1]])
    # A little above the face, so that the groove is shallow and its edges are soft.
    above = project(raised(face, lambda points: np.full(len(points), 0.005)), path)
    return tube(above, [0.013, 0.014, 0.016, 0.017, 0.016, 0.014, 0.013])


def nostrils() -> Field:
    """Two hollows in the muzzle."""
    return mirrored(ellipsoid([0.294, 0.047, -0.045], [0.024, 0.020, 0.015]))


def eyes() -> Field:
    """Two balls with a hollow for the pupil."""
    gaze = np.array([0.77, 0.53, 0.35])
    pupil = ellipsoid(EYE + 0.088 * gaze, [0.048] * 3)
    return mirrored(cut(0.008, ellipsoid(EYE, [0.050, 0.048, 0.052]), pupil))


def eyelids() -> Field:
    """Upper lids: shells around the eyes, open to the front and below."""
    up = np.array([-0.62, -0.48, 0.62])
    shell = ellipsoid(EYE, [0.063, 0.060, 0.065])
    return mirrored(cut(0.018, shell, half_space(EYE + 0.012 * up, up)))


def ear() -> Field:
    """A leaf along +y, hollow on its front."""
    middle = [[0, 0, 0], [0, 0.06, 0.012], [0, 0.13, 0.01], [0, 0.19, -0.012]]
    leaf = tube(middle, [0.030, 0.057, 0.056, 0.018], pointed=True)
    hollow = tube(
        [[0.055, 0.05, 0.01], [0.055, 0.10, 0.012], [0.06, 0.165, 0]], [0.016, 0.034, 0.014]
    )
    return cut(0.02, stretched(leaf, [0.56, 1, 1]), stretched(hollow, [0.5, 1, 1]))


def horn() -> Field:
    """A ringed horn, bent outwards and back."""
    along = np.linspace(0, 1, 41)
    rings = 0.006 * np.cos(2 * np.pi * 6 * along) * (1 - along)
    radii = np.interp(along, [0, 0.5, 1], [0.050, 0.040, 0.018]) + rings
    path = [[-0.02, 0.06, 0.08], [-0.035, 0.095, 0.18], [-0.075, 0.122, 0.245]]
    return tube([*path, [-0.125, 0.132, 0.275]], radii, pointed=True)


def forelock(face: Field) -> Field:
    """Three locks of hair that lie on the forehead."""
    sides = [(0, 0, 0, 0.01), (0.03, 0.035, 0.045, 0.065), (-0.03, -0.035, -0.045, -0.055)]
    return union(0.012, *[lock(face, *y) for y in sides])


def lock(face: Field, root: float, top: float, middle: float, end: float) -> Field:
    """One lock from the crown down, given the y of its points."""
    lying = project(face, np.array([[0, top, 0.18], [0.075, middle, 0.15], [0.125, end, 0.10]]))
    return tube([[-0.07, root, 0.10], *lying], [0.034, 0.036, 0.026, 0.012], pointed=True)


def turned(yaw: float, pitch: float = 0, roll: float = 0) -> Array:
    """Rotation matrix: roll about x, then pitch about y, then yaw about z, in degrees."""
    return _turn(2, yaw) @ _turn(1, pitch) @ _turn(0, roll)


def _turn(axis: int, degrees: float) -> Array:
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    matrix = np.array([[1.0, 0, 0], [0, c, -s], [0, s, c]])
    return np.roll(matrix, axis, axis=(0, 1))
