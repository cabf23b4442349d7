"""Finding commands from a few letters."""

import pytest

from app.ui.fuzzy import ranked, score


def test_all_letters_must_occur_in_order():
    assert score("abc", "a b c") is not None
    assert score("acb", "a b c") is None
    assert score("x", "") is None
    assert score("", "anything") is not None


def test_case_and_spaces_do_not_matter():
    assert score("N A", "Normal angle") == score("na", "normal ANGLE")


@pytest.mark.parametrize(
    ("wanted", "first"),
    [
        ("sd", "Save Denoised"),
        ("shading", "Smooth Shading"),
        ("norm", "Normal angle"),
        ("cod", "Compare Sides"),
        ("came", "Save Camera"),
    ],
)
def test_beginnings_of_words_and_runs_of_letters_come_first(wanted, first):
    names = [
        "Used",
        "Compare Sides",
        "Save Denoised",
        "Smooth Shading",
        "Normal angle",
        "Snow rim",
        "Save Camera",
        "Compare Angle median",
    ]
    assert names[ranked(wanted, names)[0]] == first


def test_the_better_of_two_names_counts():
    names, paths = ["Plot", "Points"], ["File › Export › Plot", "View › Points"]
    assert ranked("plot", names, paths) == [0]
    assert ranked("file export", names, paths) == [0]


def test_without_letters_all_stay_in_order():
    assert ranked("  ", ["b", "a"]) == [0, 1]


def test_a_word_of_the_tip_comes_after_names_and_before_scattered_letters():
    names = ["About Heat Maps", "Help About Thesis", "Distance", "Open"]
    tips = ["", "", "Heat map of each vertex", "Wheat"]
    assert ranked("heat", names, names, tips) == [0, 2, 1]
    assert ranked("he", names, names, tips) == [1, 0]
