"""A bearing bracket with sharp edges: genus 5 (four bolt holes and the bore), z up.

A base plate with rounded corners and a chamfered rim, a tapering upright with a bore through a
boss on either side, and two ribs. It is symmetric in x and y; the bore runs along y. Every vertex
lies on the planes, cylinders and cones of the drawing, those on an edge on both of its surfaces.
"""

from itertools import pairwise

import numpy as np

from resources.models.panels import (
    Array,
    Cone,
    Cylinder,
    Frame,
    Panel,
    arc,
    flat_panel,
    line,
    loop,
    mirror,
    panel,
    weld,
)
from resources.models.surface import Mesh

SPACING = 0.044

LENGTH, WIDTH, HEIGHT = 1.4, 0.8, 0.3  # base: half, half, whole
CORNER, CHAMFER = 0.3, 0.06
BOLT, BOLT_X, BOLT_Y = 0.12, 1.03, 0.43
SINK, SHELF = 0.2, 0.2  # upper part of a bolt hole: radius, lowest z

FOOT, CROWN, SIDE = 0.85, 0.66, 0.25  # upright: half width below, radius on top, half thickness
AXIS = 1.2  # z of the bore
BORE, BOSS, BOSS_END, BEVEL = 0.3, 0.5, 0.4, 0.05
RIB, RIB_TOP, RIB_END = 0.08, 0.62, 0.62  # half thickness, highest z, farthest y

HALF = (-np.pi / 2, np.pi / 2)
QUARTER = (-np.pi / 4, np.pi / 4)
FRONT = (0.0, -1.0, 0.0)
UP = (0.0, 0.0, 1.0)

Circle = tuple[float, float]  # radius and height in a frame


def machine_part() -> Mesh:
    """Make the mesh."""
    corners = mirror(base_corner() + bolt_hole(), 0, 1)
    ends = mirror([*base_end(), upright_side()], 0)
    faces = mirror([*base_side(), front(), *boss(), *rib()], 1)
    return weld([bottom(), deck(), crown(), *bore(), *corners, *ends, *faces])


def bottom() -> Panel:
    """Underside of the base."""
    return flat(rim(CORNER, 0), *[circle(around, (BOLT, 0)) for around in bolts()])


def deck() -> Panel:
    """Upper side of the base, around the foot of the upright and its ribs."""
    right = [(FOOT, SIDE), (RIB, SIDE), (RIB, RIB_END)]
    left = [(-x, y) for x, y in right[::-1]]
    foot = right + left + [(-x, -y) for x, y in right + left]
    sinks = [circle(around, (SINK, HEIGHT)) for around in bolts()]
    return flat(rim(CORNER - CHAMFER, HEIGHT), polygon(*[(x, y, HEIGHT) for x, y in foot]), *sinks)


def rim(radius: float, z: float) -> Array:
    """Outline of the base where its corners have the given radius."""
    quarters = [
        arc(corner(x, y), QUARTER, radius, z, SPACING)
        for x, y in ((1, 1), (-1, 1), (-1, -1), (1, -1))
    ]
    sides = [
        line(this[-1], following[0], SPACING)
        for this, following in zip(quarters, quarters[1:] + quarters[:1], strict=True)
    ]
    return loop(*[piece for pair in zip(quarters, sides, strict=True) for piece in pair])


def corner(x: int, y: int) -> Frame:
    """Axis of one rounded corner of the base."""
    center = (x * (LENGTH - CORNER), y * (WIDTH - CORNER), 0.0)
    return Frame(center, UP, np.array([x, y, 0]) / np.sqrt(2))


def base_corner() -> list[Panel]:
    """Wall and chamfer of one corner."""
    wall, around = HEIGHT - CHAMFER, corner(1, 1)
    return [
        band(around, QUARTER, (CORNER, 0), (CORNER, wall)),
        band(around, QUARTER, (CORNER, wall), (CORNER - CHAMFER, HEIGHT)),
    ]


def base_end() -> list[Panel]:
    """Wall and chamfer of one short side."""
    profile = [(LENGTH, 0), (LENGTH, HEIGHT - CHAMFER), (LENGTH - CHAMFER, HEIGHT)]
    y = WIDTH - CORNER
    return [
        flat(polygon((x, -y, z), (x, y, z), (x_next, y, z_next), (x_next, -y, z_next)))
        for (x, z), (x_next, z_next) in pairwise(profile)
    ]


def base_side() -> list[Panel]:
    """Wall and chamfer of one long side."""
    profile = [(-WIDTH, 0), (-WIDTH, HEIGHT - CHAMFER), (CHAMFER - WIDTH, HEIGHT)]
    x = LENGTH - CORNER
    return [
        flat(polygon((-x, y, z), (x, y, z), (x, y_next, z_next), (-x, y_next, z_next)))
        for (y, z), (y_next, z_next) in pairwise(profile)
    ]


def bolts() -> list[list[Frame]]:
    """Axes of the four bolt holes."""
    return [halves((x * BOLT_X, y * BOLT_Y, 0), UP, (1, 0, 0)) for x in (1, -1) for y in (1, -1)]


def bolt_hole() -> list[Panel]:
    """One bolt hole: a bore, a shelf and a wider bore."""
    around = bolts()[0]
    shelf = flat(circle(around, (SINK, SHELF)), circle(around, (BOLT, SHELF)))
    lower = sleeve(around, (BOLT, 0), (BOLT, SHELF))
    return [shelf, *lower, *sleeve(around, (SINK, SHELF), (SINK, HEIGHT))]


def shoulder() -> float:
    """Angle from the vertical at which the sides of the upright touch its round top."""
    x, z = FOOT, HEIGHT - AXIS
    return float(np.pi / 2 - np.arctan2(z, x) - np.arccos(CROWN / np.hypot(x, z)))


def axis() -> Frame:
    """Axis of the bore: heights run to the front, −y, angles from the top to the left, −x."""
    return Frame((0, 0, AXIS), FRONT, UP)


def crown() -> Panel:
    """Round top of the upright."""
    return band(axis(), (-shoulder(), shoulder()), (CROWN, -SIDE), (CROWN, SIDE))


def upright_side() -> Panel:
    """One slanting side of the upright."""
    top = axis().at(-shoulder(), CROWN, SIDE)
    back = (1, -1, 1)
    foot = np.array([FOOT, -SIDE, HEIGHT])
    return flat(polygon(foot, foot * back, top * back, top))


def front() -> Panel:
    """Front face of the upright, around the boss and the rib."""
    top = arc(axis(), (-shoulder(), shoulder()), CROWN, SIDE, SPACING)
    below = [(-FOOT, HEIGHT), (-RIB, HEIGHT), (-RIB, RIB_TOP)]
    below += [(-x, z) for x, z in below[::-1]]
    corners = [top[-1], *[(x, -SIDE, z) for x, z in below], top[0]]
    return flat(loop(top, *lines(*corners)), circle(bore_halves(), (BOSS, SIDE)))


def bore_halves() -> list[Frame]:
    """Axis of the bore for its upper and its lower half."""
    return halves((0, 0, AXIS), FRONT, UP)


def bore() -> list[Panel]:
    """Inside of the bore between the bevels."""
    end = BOSS_END - BEVEL
    return sleeve(bore_halves(), (BORE, -end), (BORE, end))


def boss() -> list[Panel]:
    """Outside, outer bevel, face and inner bevel of the boss on the front."""
    around, end = bore_halves(), BOSS_END
    ring = circle(around, (BOSS - BEVEL, end)), circle(around, (BORE + BEVEL, end))
    outside = sleeve(around, (BOSS, SIDE), (BOSS, end - BEVEL))
    outside += sleeve(around, (BOSS, end - BEVEL), (BOSS - BEVEL, end))
    return [*outside, flat(*ring), *sleeve(around, (BORE + BEVEL, end), (BORE, end - BEVEL))]


def rib() -> list[Panel]:
    """Sloping edge and both sides of the rib on the front."""
    right = np.array([(RIB, -SIDE, RIB_TOP), (RIB, -RIB_END, HEIGHT), (RIB, -SIDE, HEIGHT)])
    left = right * [-1, 1, 1]
    return [
        flat(polygon(right[0], right[1], left[1], left[0])),
        *mirror([flat(polygon(*right))], 0),
    ]


def halves(
    origin: tuple[float, ...], along: tuple[float, ...], zero: tuple[float, ...]
) -> list[Frame]:
    """The two frames whose half turns make a whole one."""
    return [Frame(origin, along, side * np.asarray(zero, float)) for side in (1, -1)]


def circle(around: list[Frame], size: Circle) -> Array:
    """A circle as a closed border."""
    return loop(*[arc(frame, HALF, *size, SPACING) for frame in around])


def sleeve(around: list[Frame], low: Circle, high: Circle) -> list[Panel]:
    """The surface between two circles about one axis, in two halves."""
    return [band(frame, HALF, low, high) for frame in around]


def band(frame: Frame, angles: tuple[float, float], low: Circle, high: Circle) -> Panel:
    """The cylinder or cone between two arcs about one axis."""
    first, last = (arc(frame, angles, *size, SPACING) for size in (low, high))
    border = loop(
        first, line(first[-1], last[-1], SPACING), last[::-1], line(last[0], first[0], SPACING)
    )
    sheet = Cylinder(frame, low[0]) if low[0] == high[0] else Cone(frame, low, high)
    return panel(sheet, border, spacing=SPACING)


def flat(*borders: Array) -> Panel:
    """A flat panel at the part's spacing."""
    return flat_panel(*borders, spacing=SPACING)


def lines(*corners: Array | tuple[float, ...]) -> list[Array]:
    """Straight lines from corner to corner."""
    return [line(a, b, SPACING) for a, b in pairwise(corners)]


def polygon(*corners: Array | tuple[float, ...]) -> Array:
    """Closed border with straight sides."""
    return loop(*lines(*corners, corners[0]))
