"""That the Qt binding itself is sound: what a long session rests on."""

import sys

from PySide6.QtCore import QObject


def test_methods_that_return_nothing_do_not_use_up_none(qtbot):
    # PySide6 6.12 on Python 3.11 gave back a reference to None with every such call; after some
    # ten thousand calls the process was ended.
    thing = QObject()
    before = sys.getrefcount(None)
    for _ in range(1000):
        thing.setObjectName("name")
    assert sys.getrefcount(None) > before - 500
