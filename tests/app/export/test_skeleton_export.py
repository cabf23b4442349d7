"""Pictures and films of skeletal graphs, and the report of the command line."""

import json
from itertools import pairwise

import imageio.v2 as imageio
import numpy as np
import pytest
from imageio_ffmpeg import count_frames_and_secs

from app.cli import main
from app.export.pictures import PictureError
from app.export.skeleton_films import write_film
from app.export.skeleton_pictures import growth_frames, skeleton_picture, turn_frames
from app.scene.colours import DARK
from app.scene.skeleton_panes import SkeletonLook, build_pane
from app.session.skeleton_maker import SkeletonMaker, SkeletonSource
from core.io import save_mesh
from core.mesh import primitives
from core.skeleton import FORMATS, read_graph
from core.study import SkeletonSettings, SkeletonView

SIZE = (320, 240)
LOOK = SkeletonLook(SkeletonSettings(), DARK)


@pytest.fixture(scope="module")
def pane():
    torus = primitives.torus(40, 20)
    view = SkeletonView(resolution=5)
    skeleton = SkeletonMaker().make(SkeletonSource("torus", lambda: torus), view)
    return build_pane(skeleton, np.zeros(3))


def test_a_picture_shows_surface_and_graph(pane):
    picture = skeleton_picture([pane], LOOK, None, SIZE)
    assert picture.shape == (240, 320, 3)
    bare = SkeletonLook(SkeletonSettings(show_graph=False), DARK)
    assert np.abs(picture.astype(int) - skeleton_picture([pane], bare, None, SIZE)).max() > 60


def test_no_surface_hides_the_graph(pane):
    glass, solid = (
        skeleton_picture([pane], SkeletonLook(SkeletonSettings(opacity=o)), None, SIZE)
        for o in (0.3, 1.0)
    )
    dark = [(picture.max(axis=2) < 45).sum() for picture in (glass, solid)]
    assert dark[1] > 0.8 * dark[0] > 0


def test_a_transparent_picture_composes_over_any_ground(pane):
    clear = skeleton_picture([pane], LOOK, None, SIZE, transparent=True)
    assert clear.shape == (240, 320, 4)
    assert clear[-3, 3, 3] == 0
    middle = clear[60:180, 80:240, 3]
    assert ((middle > 40) & (middle < 220)).any()


def test_a_turn_changes_from_frame_to_frame(pane):
    first, second = turn_frames([pane], LOOK, None, SIZE, 2)
    assert first.shape == second.shape
    assert (first != second).any()


def test_a_growth_has_a_frame_for_each_band_and_one_before(pane):
    frames = list(growth_frames([pane], LOOK, None, SIZE))
    assert len(frames) == 6
    assert all((a != b).any() for a, b in pairwise(frames))


@pytest.mark.parametrize("suffix", [".gif", ".mp4"])
def test_a_film_has_all_its_frames(tmp_path, suffix):
    path = tmp_path / f"film{suffix}"
    frames = [np.full((61, 81, 3), value, np.uint8) for value in (0, 120, 240)]
    assert list(write_film(path, frames, 5)) == [1, 2, 3]
    if suffix == ".mp4":
        assert count_frames_and_secs(path)[0] == 3
    else:
        with imageio.get_reader(path) as reader:
            shown = [frame[30, 40, 0] for frame in reader]
        assert shown == pytest.approx([0, 120, 240], abs=6)


def test_a_film_in_another_format_is_refused(tmp_path):
    with pytest.raises(PictureError, match=r"\.gif or \.mp4"):
        list(write_film(tmp_path / "film.avi", [], 5))


def test_a_film_that_is_stopped_leaves_the_old_one(tmp_path):
    path = tmp_path / "film.gif"
    path.write_bytes(b"old")
    frames = [np.zeros((16, 16, 3), np.uint8)] * 3
    writing = write_film(path, frames, 5)
    assert next(writing) == 1
    writing.close()
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]


@pytest.fixture(scope="module")
def torus_file(tmp_path_factory):
    path = tmp_path_factory.mktemp("models") / "torus.ply"
    save_mesh(primitives.torus(40, 20), path)
    return str(path)


def call(capsys, *arguments):
    with pytest.raises(SystemExit) as stop:
        main(["skeleton", *map(str, arguments)])
    output = capsys.readouterr()
    return stop.value.code, output.out, output.err


def test_the_command_prints_one_json_object(capsys, torus_file):
    status, out, err = call(capsys, torus_file, "--resolution", 12, "--json")
    result = json.loads(out)
    assert (status, err) == (0, "")
    assert (result["loops"], result["components"], result["genus"]) == (1, 1, 1)
    assert result["arcs"] == result["nodes"]
    assert (result["resolution"], result["field"]) == (12, "mixture")
    assert result["seconds"] > 0


def test_the_command_prints_text_and_finds_a_resolution(capsys, torus_file):
    status, out, _ = call(
        capsys, torus_file, "--resolution", "auto", "--set", "weight=0.5", "--root"
    )
    assert status == 0
    assert out.startswith("Mixture distance (λ = 0.5), R = ")
    assert "1 loops, genus 1" in out


@pytest.mark.parametrize("suffix", [suffix for suffix in FORMATS if suffix != ".swc"])
def test_the_command_writes_every_format(capsys, torus_file, tmp_path, suffix):
    path = tmp_path / f"graph{suffix}"
    assert call(capsys, torus_file, "-o", path)[0] == 0
    assert read_graph(path).loops == 1


def test_the_command_writes_a_picture(capsys, torus_file, tmp_path):
    path = tmp_path / "torus.png"
    assert call(capsys, torus_file, "-o", path)[0] == 0
    assert imageio.imread(path).shape == (1200, 1600, 4)


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--field", "foo"], "foo is not a field"),
        (["--resolution", "99"], "use 1 to 64"),
        (["--bands", "foo"], "use exact or vertices"),
        (["--spacing", "foo"], "use value or distance or area"),
        (["--set", "weight=3"], "use 0 to 1"),
        (["--set", "weight"], "not of the form"),
        (["-o", "graph.foo"], ".graphml, .json"),
        (["-o", "nowhere/graph.json"], "not a folder"),
        (["-o", "graph.swc"], "trees only"),
    ],
)
def test_bad_input_is_one_line_and_status_2(capsys, torus_file, words, message):
    status, out, err = call(capsys, torus_file, *words)
    assert (status, out) == (2, "")
    assert message in err
    assert err.count("\n") == 1
