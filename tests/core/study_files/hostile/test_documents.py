"""Studies from strangers: nothing runs, and nothing else is read."""

import copy
import json
import random
import sys
from contextlib import contextmanager

import pytest

from core.study_files import MissingModelError, document, read_study_file

VALUES = [
    *(None, True, -1, 0, 1.5, 1e308, float("nan"), float("inf"), 2**63, 10**400, "", "\0", "a\nb"),
    *("\ud800", "x" * 5000, "../../etc/passwd", [], [[]], {}, {"a": {"b": {}}}, [None], "\x1b[2J"),
]
RUNS = (
    "exec",
    "compile",
    "import",
    "os.",
    "subprocess.",
    "socket.",
    "ctypes.",
    "pickle.",
    "shutil",
)

# Hooks of this kind stay for ever; this one has something to do only while somebody watches.
_watchers: list[list[tuple[str, object]]] = []


def _audit(event: str, arguments: tuple[object, ...]) -> None:
    for events in _watchers:
        events.append((event, arguments[0] if arguments else None))


sys.addaudithook(_audit)


@contextmanager
def watching():
    """Collect what Python does meanwhile: files opened, code run, programs started."""
    events: list[tuple[str, object]] = []
    _watchers.append(events)
    try:
        yield events
    finally:
        _watchers.remove(events)


def places(tree, path=()):
    """Every place in a tree of JSON."""
    for key, value in tree.items() if isinstance(tree, dict) else enumerate(tree):
        yield (*path, key)
        if isinstance(value, dict | list):
            yield from places(value, (*path, key))


def changed(tree, path, value):
    tree = copy.deepcopy(tree)
    *way, last = path
    place = tree
    for key in way:
        place = place[key]
    place[last] = value
    return tree


def test_every_value_may_be_any_other(file, plain, tmp_path, outcome):
    rng = random.Random(7)
    for place in list(places(plain)):
        for value in rng.sample(VALUES, 8):
            file.write_text(json.dumps(changed(plain, place, value)))
            sentence = outcome(file, tmp_path / "cache")
            assert sentence.isprintable()
            assert not sentence or sentence.startswith("a.burnish: ")
            assert len(sentence) < 5500


@pytest.mark.parametrize("name", ["a\nb", "\x1b[31m", "x" * 10_000, "__class__"])
def test_unknown_fields_of_any_name_are_one_sentence(name, file, plain, tmp_path, refused):
    file.write_text(json.dumps({**plain, name: {"py/object": "os.system"}}))
    sentence = refused(file, tmp_path)
    assert sentence.isprintable()
    assert "which this Burnish does not know" in sentence
    assert len(sentence) < 200


@pytest.mark.parametrize("depth", [10, 300, 600, 900, 990, 2000])
def test_values_may_be_nested_deep(depth, file, plain, tmp_path, refused):
    text = json.dumps(plain).replace('"visual_error"', "[" * depth + "]" * depth)
    file.write_text(text)
    assert refused(file, tmp_path).startswith("a.burnish: ")


def test_nothing_runs_and_no_other_file_is_opened(file, plain, tmp_path, outcome):
    for name, value in (("metric", "__import__('os').system('id')"), ("model", "/etc/passwd")):
        hostile = changed(plain, ("study", name), value)
        file.write_text(json.dumps(hostile))
        outcome(file, tmp_path / "cache")  # what is loaded on first use is loaded now
        with watching() as events:
            assert outcome(file, tmp_path / "cache")
        assert {str(what) for event, what in events if event == "open"} == {str(file)}
        assert not [event for event, _ in events if event.startswith(RUNS)]


@pytest.mark.parametrize(
    "place",
    [
        *("/etc/passwd", "../../../../../../etc/passwd", "/dev/zero", "/proc/self/environ", "~"),
        *("//host/a.ply", "\\\\host\\a.ply", "/\\host/a.ply", "\\/host\\a.ply", "http://host/x"),
        *("packed:a.ply/../../x", "a.ply\0.txt", "a.ply/", ".", "..", "x" * 5000 + ".ply"),
    ],
)
def test_what_is_no_model_is_not_even_looked_for(place, file, plain, tmp_path, outcome):
    file.write_text(json.dumps(changed(plain, ("study", "model"), place)))
    with watching() as events:
        sentence = outcome(file, tmp_path / "cache")
    assert "is not the place of a model" in sentence or "is not at" in sentence
    assert {str(what) for event, what in events if event == "open"} == {str(file)}


def test_a_secret_called_like_a_model_is_compared_and_not_read_further(
    file, plain, tmp_path, refused
):
    secret = tmp_path / "secret.ply"
    secret.write_text("the code is 1234")
    file.write_text(json.dumps(changed(plain, ("study", "model"), "../secret.ply")))
    with watching() as events:
        sentence = refused(file, tmp_path / "cache")
    assert "is not the one the study was saved with" in sentence
    assert "1234" not in sentence
    assert str(secret) not in [str(what) for event, what in events if event == "open"]


def test_every_older_version_has_a_way_to_this_one():
    assert set(document.MIGRATIONS) == set(range(1, document.FORMAT_VERSION))


def test_an_old_version_that_is_damaged_is_one_sentence(file, tmp_path, monkeypatch, refused):
    this = document.FORMAT_VERSION
    monkeypatch.setattr(document, "FORMAT_VERSION", this + 1)
    monkeypatch.setitem(document.MIGRATIONS, this, lambda plain: plain["missing"]["field"])
    assert refused(file, tmp_path) == f"a.burnish: is damaged (it says format version {this})."


@pytest.mark.parametrize("version", [0, -1, 1.0, True, None, "1", [], 10**400, 3, 999])
def test_versions_that_are_not_known_are_told(version, file, plain, tmp_path, refused):
    file.write_text(json.dumps({**plain, "version": version}))
    assert "version" in refused(file, tmp_path)


def test_a_missing_model_with_a_strange_name_is_one_line(file, plain, tmp_path):
    file.write_text(json.dumps(changed(plain, ("study", "model"), "a\nb\x1b[2J.ply")))
    with pytest.raises(MissingModelError) as caught:
        read_study_file(file).locate(tmp_path)
    assert str(caught.value).isprintable()
