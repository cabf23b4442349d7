"""``burnish doctor``, and repairs as words, in studies and in scripts."""

import contextlib
import io
import json
import shlex

import numpy as np
import pytest

from app.cli import main
from app.export.study_script import script_of
from app.repair_words import repair_words, repairs_of
from app.study_words import command_of
from core.comparison import run
from core.doctor import RepairChoice, examine
from core.io import load_mesh, save_mesh
from core.mesh import TriangleMesh, primitives
from core.noise import add_noise
from core.study import MethodChoice, Study
from core.study_files import StudyFileError, read_study_file, write_study_file


@pytest.fixture(autouse=True)
def _own_cache(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))


@pytest.fixture
def bad(tmp_path):
    """A torus with a face twice, one turned round, and a hole around a vertex."""
    ring = primitives.torus(16, 10)
    faces = ring.faces[(ring.faces != 40).all(axis=1)].copy()
    faces[7] = faces[7, ::-1]
    path = tmp_path / "bad one.ply"
    used = np.arange(len(ring.vertices)) != 40
    number = np.cumsum(used) - 1
    faces = number[np.concatenate([faces, faces[100:101]])]
    save_mesh(TriangleMesh(ring.vertices[used], faces), path)
    return path


def call(capsys, *words):
    with pytest.raises(SystemExit) as stop:
        main([str(word) for word in words])
    output = capsys.readouterr()
    return stop.value.code, output.out, output.err


def test_says_what_is_wrong_and_which_repair_helps(capsys, bad):
    code, out, _ = call(capsys, "doctor", bad)
    assert code == 0
    assert "1 face lies exactly on an earlier one.  [--repair duplicate_faces]" in out
    assert "1 boundary loop with 6 edges; 1 small hole to fill.  [--repair fill_holes]" in out


def test_says_that_nothing_is_wrong(capsys, tmp_path):
    save_mesh(primitives.sphere(1), tmp_path / "ball.ply")
    assert "Nothing is wrong with it." in call(capsys, "doctor", tmp_path / "ball.ply")[1]


def test_repairs_and_writes(capsys, bad, tmp_path):
    out = tmp_path / "whole.ply"
    code, text, _ = call(capsys, "doctor", bad, "--repair", "all,fill_holes", "-o", out)
    assert code == 0
    assert "Removed 1 face that lay on others." in text
    assert "Filled 1 hole with 4 faces." in text
    assert examine(load_mesh(out)).findings == ()
    assert load_mesh(out).genus == 1


def test_json_has_both_reports(capsys, bad):
    visit = json.loads(call(capsys, "doctor", bad, "--repair", "all", "--json")[1])
    assert not visit["sound"]
    assert visit["after"]["sound"]
    assert [done["repair"] for done in visit["repairs"]] == ["duplicate_faces", "orient"]
    finding = next(f for f in visit["findings"] if f["id"] == "duplicate_faces")
    assert finding["count"] == 1
    assert len(finding["vertices"]) == 3
    assert finding["repair"] == "duplicate_faces"


def test_tells_what_loading_changed(capsys, tmp_path):
    path = tmp_path / "square.off"
    path.write_text("OFF\n5 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n9 9 9\n4 0 1 2 3\n")
    out = call(capsys, "doctor", path)[1]
    assert "When loading: 1 polygon triangulated." in out
    assert "When loading: 1 unreferenced vertex dropped." in out


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("polish", "polish is not a repair; allowed: degenerate_faces"),
        ("fill_holes:most_edges=1", "fill_holes.most_edges=1 is not allowed; use 3 to 200"),
        ("fill_holes:30", "is not of the form repair:parameter=value"),
        ("split:share=1", "split.share is not a parameter; allowed: none"),
    ],
)
@pytest.mark.parametrize("command", ["doctor", "compare"])
def test_refuses_in_one_line(capsys, bad, command, words, message):
    code, out, err = call(capsys, command, bad, "--repair", words)
    assert (code, out) == (2, "")
    assert message in err
    assert len(err.splitlines()) == 1


def test_words_and_choices_are_the_same_thing():
    choices = (
        RepairChoice(repair="split"),
        RepairChoice(repair="fill_holes", params={"most_edges": 60}),
        RepairChoice(repair="small_components", params={"share": 0.05}),
        RepairChoice(repair="fill_holes"),
    )
    words = repair_words(choices)
    assert words == "split,fill_holes:most_edges=60,small_components:share=0.05,fill_holes"
    assert repairs_of(words, lambda: pytest.fail("no mesh is needed")) == choices
    assert repairs_of("none", lambda: pytest.fail("no mesh is needed")) == ()


@pytest.fixture
def study(bad):
    return Study(
        model=str(bad),
        repairs=(
            RepairChoice(repair="duplicate_faces"),
            RepairChoice(repair="orient"),
            RepairChoice(repair="fill_holes", params={"most_edges": 20}),
        ),
        methods=(MethodChoice(method="bilateral", iterations=3),),
    )


@pytest.mark.parametrize("separate", [False, True])
def test_study_command_and_script_give_the_same_numbers(capsys, study, tmp_path, separate):
    if separate:
        path = tmp_path / "noisy.ply"
        save_mesh(add_noise(load_mesh(study.model), 0.1), path)
        study = study.model_copy(update={"noisy": str(path)})
    result = run(study)
    expected = result.methods[0].errors["visual_error"]
    assert result.comparison.original.genus == 1
    assert "Filled 1 hole with 4 faces." in result.report

    file = tmp_path / "one.burnish"
    write_study_file(study, file)
    by_file = json.loads(call(capsys, "compare", "--study", file, "--json")[1])
    words = shlex.split(command_of(study))[1:]
    by_words = json.loads(call(capsys, *words, "--json")[1])
    assert by_file["methods"][0]["visual_error"] == list(expected)
    assert by_words["methods"][0]["visual_error"] == list(expected)
    assert by_words["model"]["changes"] == list(result.report)

    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(script_of(study), "script", "exec"), {})
    assert f"visual_error={expected[-1]!r}" in printed.getvalue()


def test_repairs_of_the_command_line_take_the_place_of_the_studys(capsys, study, tmp_path):
    file = tmp_path / "one.burnish"
    write_study_file(study, file)
    plain = json.loads(call(capsys, "compare", "--study", file, "--repair", "none", "--json")[1])
    assert plain["model"]["faces"] == len(load_mesh(study.model).faces)


def test_older_files_without_repairs_open(study, tmp_path):
    file = tmp_path / "old.burnish"
    write_study_file(study, file)
    plain = json.loads(file.read_text())
    del plain["study"]["repairs"]
    file.write_text(json.dumps(plain))
    assert read_study_file(file).study.repairs == ()


def test_a_file_with_a_repair_that_is_not_known_is_refused(study, tmp_path):
    file = tmp_path / "new.burnish"
    write_study_file(study, file)
    file.write_text(file.read_text().replace('"orient"', '"polish"'))
    with pytest.raises(StudyFileError, match="polish is not a repair"):
        read_study_file(file)
