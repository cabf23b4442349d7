"""A camera from the clipboard from which nothing can be seen does not reach the renderer."""

import pytest
from PySide6.QtWidgets import QApplication, QMessageBox

SEEN = '"focal_point": [0, 0, 0], "view_up": [0, 1, 0]'


@pytest.mark.parametrize(
    "text",
    [
        f'{{"position": [NaN, 0, 1], {SEEN}}}',
        f'{{"position": [0, 0, 1e308], {SEEN}}}',
        f'{{"position": [0, 1, 0], {SEEN}}}',
    ],
)
def test_it_is_refused_and_the_view_stays(user, ball_file, text):
    user.open(ball_file)
    pose = user.denoise.desk.stage.pose
    QApplication.clipboard().setText(text)
    user.window.actions_["paste_camera"].trigger()
    user.wait(lambda: [b for b in user.window.findChildren(QMessageBox) if b.isVisible()])
    box = next(b for b in user.window.findChildren(QMessageBox) if b.isVisible())
    assert "camera" in box.text() + box.informativeText()
    box.close()
    assert user.denoise.desk.stage.pose == pose
