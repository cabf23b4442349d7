"""Light and dark: contrast of what can be checked, and following the system."""

import pytest
from matplotlib.colors import to_rgba
from PySide6.QtCore import QEvent, QObject, QRegularExpression, QSettings, Qt
from PySide6.QtGui import QColor, QGuiApplication, QPalette
from PySide6.QtWidgets import QAbstractButton, QCheckBox, QToolButton

from app.ui.preferences import open_preferences
from app.ui.preferences_general import GeneralPage
from app.ui.theme import current_theme

LEAST_RATIO = 3.0
TEXT_RATIO = 4.5
TITLE_BUTTON = QRegularExpression("^qt_dockwidget_")


def luminance(colour):
    """Relative luminance of WCAG 2.1."""

    def linear(share):
        return share / 12.92 if share <= 0.04045 else ((share + 0.055) / 1.055) ** 2.4

    parts = (linear(part) for part in colour.getRgbF()[:3])
    return sum(weight * part for weight, part in zip((0.2126, 0.7152, 0.0722), parts, strict=True))


def ratio(one, other):
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


def outline(check):
    """Colour in the middle of the left edge of a check box, as it is drawn."""
    image = check.grab().toImage()
    scale = image.devicePixelRatio()
    return QColor(image.pixel(0, round(check.height() * scale / 2)))


def contrast(button, ground):
    """How much the strongest ink of a button's icon stands out."""
    icon = button.icon().pixmap(button.size()).toImage()
    inks = [icon.pixelColor(x, y) for x in range(icon.width()) for y in range(icon.height())]
    return max(ratio(ink, ground) for ink in inks if ink.alpha() > 200)


@pytest.mark.parametrize("mode", ["light", "dark"])
def test_an_unchecked_box_stands_out_from_the_ground(user, qtbot, mode):
    user.window.actions_[f"theme_{mode}"].trigger()
    box = QCheckBox(user.window)
    box.setFixedSize(box.sizeHint())
    box.show()
    qtbot.wait(50)
    for role in (QPalette.ColorRole.Window, QPalette.ColorRole.Base):
        assert ratio(outline(box), user.window.palette().color(role)) >= LEAST_RATIO


@pytest.mark.parametrize("mode", ["light", "dark"])
def test_pale_text_can_be_read(user, mode):
    user.window.actions_[f"theme_{mode}"].trigger()
    palette = user.window.palette()
    pale = palette.color(QPalette.ColorRole.PlaceholderText)
    assert ratio(pale, palette.color(QPalette.ColorRole.Window)) >= TEXT_RATIO


@pytest.mark.parametrize("mode", ["light", "dark"])
def test_the_buttons_of_a_panel_stand_out_from_its_title(user, qtbot, mode):
    user.window.actions_[f"theme_{mode}"].trigger()
    ground = user.window.palette().color(QPalette.ColorRole.Window)
    for button in user.denoise.docks[0].findChildren(QAbstractButton, TITLE_BUTTON):
        assert contrast(button, ground) >= TEXT_RATIO


@pytest.mark.parametrize("mode", ["light", "dark"])
def test_the_buttons_of_a_file_dialog_stand_out(user, mode):
    user.window.actions_[f"theme_{mode}"].trigger()
    user.window.actions_["open"].trigger()
    (dialog,) = user.file_dialogs()
    ground = user.window.palette().color(QPalette.ColorRole.Window)
    for name in ("toParentButton", "newFolderButton", "listModeButton", "detailModeButton"):
        assert contrast(dialog.findChild(QToolButton, name), ground) >= TEXT_RATIO
    dialog.reject()


@pytest.mark.parametrize("mode", ["light", "dark"])
def test_the_theme_is_a_preference(user, qtbot, mode):
    choice = open_preferences(user.window).findChild(GeneralPage).theme
    choice.setFocus()
    qtbot.keyClick(choice, Qt.Key.Key_End if mode == "dark" else Qt.Key.Key_Home)
    qtbot.keyClicks(choice, mode)
    assert QSettings().value("theme_mode") == mode
    assert current_theme().dark == (mode == "dark")


@pytest.fixture
def system(monkeypatch):
    """Let the desktop ask for a scheme; a virtual screen has no desktop, so it is played."""

    def ask(scheme):
        monkeypatch.setattr("app.ui.theme.system_is_dark", lambda: scheme == Qt.ColorScheme.Dark)
        QGuiApplication.styleHints().colorSchemeChanged.emit(scheme)

    return ask


def test_the_window_follows_the_system_while_it_is_open(user, ball_file, system):
    user.open(ball_file)
    window = user.window
    window.actions_["theme_system"].trigger()
    seen = []
    for scheme in (Qt.ColorScheme.Dark, Qt.ColorScheme.Light):
        system(scheme)
        user.rest()
        ground = window.denoise.viewport.grid.renderer("original").GetBackground2()
        seen.append((window.palette().window().color().lightness(), max(ground)))
        plot, panel = window.denoise.plot.figure, to_rgba(current_theme().panel)
        user.wait(lambda plot=plot, panel=panel: plot.get_facecolor() == panel)
        assert window.statistics.theme is current_theme()
    assert seen[0][0] < 128 < seen[1][0]
    assert seen[0][1] < 0.5 < seen[1][1]


def test_a_chosen_theme_stays_whatever_the_system_says(user, system):
    user.window.actions_["theme_dark"].trigger()
    system(Qt.ColorScheme.Light)
    assert current_theme().dark
    assert QSettings().value("theme_mode") == "dark"
    assert user.window.actions_["theme_dark"].isChecked()
    user.window.actions_["theme_light"].trigger()
    assert not current_theme().dark


class Polishing(QObject):
    """Counts how often a widget gets another style."""

    def __init__(self, widget):
        super().__init__()
        self.count = 0
        widget.installEventFilter(self)

    def eventFilter(self, _, event):  # noqa: N802 (the name is Qt's)
        self.count += event.type() == QEvent.Type.StyleChange
        return False


def test_a_theme_that_is_there_already_is_not_set_again(user):
    user.window.actions_["theme_dark"].trigger()
    seen = Polishing(user.denoise.table)
    for _ in range(2):
        user.window.theme.refresh()
    assert seen.count == 0
    user.window.actions_["theme_light"].trigger()
    assert seen.count > 0
