"""The box of the clipping range stays as it is while a mesh changes a little."""

import numpy as np

from app.scene.clipping import SteadyBox

UNIT = (-1.0, 1.0, -1.0, 1.0, -1.0, 1.0)


def test_the_box_holds_all_boxes():
    low_high = SteadyBox().around([UNIT, (0.0, 3.0, 0.0, 1.0, 0.0, 0.5)]).reshape(3, 2)
    assert (low_high[:, 0] <= -1).all()
    assert (low_high[:, 1] >= (3, 1, 1)).all()


def test_it_changes_only_where_a_mesh_leaves_it_or_becomes_much_smaller():
    box = SteadyBox()
    first = box.around([UNIT])
    for factor, changes in ((1.05, False), (0.9, False), (1.3, True), (1.2, False), (0.5, True)):
        then = box.around([np.multiply(UNIT, factor)])
        assert (not np.array_equal(then, first)) == changes
        first = then
