"""The command line: output, files, exit status, and what it does not import."""

import json
import subprocess
import sys

import pytest

from app.cli import main
from core.io import save_mesh
from core.mesh import primitives


@pytest.fixture
def ball_file(tmp_path):
    path = tmp_path / "ball.ply"
    save_mesh(primitives.sphere(2), path)
    return str(path)


def call(capsys, *arguments):
    with pytest.raises(SystemExit) as stop:
        main([str(argument) for argument in arguments])
    output = capsys.readouterr()
    return stop.value.code, output.out, output.err


def test_compare_prints_one_json_object(capsys, ball_file):
    status, out, err = call(
        capsys, "compare", ball_file, "--methods", "mean,diffusion", "--iterations", 4,
        "--sigma", 0.1, "--seed", 3, "--json",
    )  # fmt: skip
    result = json.loads(out)
    assert (status, err) == (0, "")
    assert (result["model"]["vertices"], result["model"]["faces"]) == (162, 320)
    assert result["noise"] == {"sigma": 0.1, "seed": 3}
    assert [method["id"] for method in result["methods"]] == ["mean", "diffusion"]
    for method in result["methods"]:
        assert len(method["visual_error"]) == 5
        assert method["visual_error"][0] == result["noisy"]["visual_error"]
        assert method["seconds_per_iteration"] > 0
        assert method["diverged"] is None


def test_compare_prints_a_table(capsys, ball_file):
    status, out, _ = call(capsys, "compare", ball_file, "--iterations", 1)
    assert status == 0
    for text in ("Noisy input", "Weighted Laplacian", "Vertex diffusion", "Visual error"):
        assert text in out


def test_settings_reach_the_method(capsys, ball_file):
    out = call(
        capsys, "compare", ball_file, "--methods", "laplacian", "--iterations", 2,
        "--set", "laplacian.step=0", "--json",
    )[1]  # fmt: skip
    errors = json.loads(out)["methods"][0]["visual_error"]
    assert errors[0] == errors[1] == errors[2]


def test_output_folder_gets_pictures_plot_tables_and_meshes(capsys, ball_file, tmp_path):
    folder = tmp_path / "out"
    call(capsys, "compare", ball_file, "--methods", "mean", "--iterations", 1, "-o", folder)
    names = {path.name for path in folder.iterdir()}
    assert names == {
        "panes.png", "montage.png", "montage.pdf", "errors.png", "errors.svg", "table.csv",
        "table.md", "result.json",
        "study.burnish", "noisy.ply", "mean.ply",
    }  # fmt: skip


def test_methods_lists_every_parameter(capsys):
    status, out, _ = call(capsys, "methods")
    assert status == 0
    for text in (
        "weighted_laplacian",
        "gradient_scale = 50",
        "sigma_c = auto",
        "raw_units = false",
    ):
        assert text in out
    assert "True" not in out


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["compare", "gone.ply"], "gone.ply"),
        (["compare", "BALL", "--sigma", "7"], "noise.sigma=7.0 is not allowed; use 0 to 1"),
        (["compare", "BALL", "--methods", "magic"], "magic is not a method"),
        (["compare", "BALL", "--set", "mean"], "not of the form id.parameter=value"),
        (["compare", "BALL", "--set", "mean.size=1"], "mean.size is not a parameter"),
        (["compare", "BALL", "--set", "laplacian.step=1"], "laplacian does not take part"),
        (["compare", "BALL", "--iterations", "-1"], "iterations=-1 is not allowed"),
        (["compare", "BALL", "--nonsense"], "nonsense"),
        (["compare"], "requires an argument"),
        (["compare", "BALL", "--noisy", "gone.obj"], "gone.obj"),
    ],
)
def test_bad_input_is_one_line_and_status_2(capsys, ball_file, arguments, message):
    words = [ball_file if word == "BALL" else word for word in arguments]
    status, out, err = call(capsys, *words)
    assert (status, out) == (2, "")
    assert message in err
    assert err.count("\n") == 1
    assert "Traceback" not in err


def test_too_little_memory_is_one_line_and_status_2(capsys, ball_file, monkeypatch):
    def refuse(*_, **__):
        raise MemoryError

    monkeypatch.setattr("core.comparison.run", refuse)
    status, out, err = call(capsys, "compare", ball_file)
    assert (status, out) == (2, "")
    assert err.startswith("burnish: There is not enough memory")
    assert err.count("\n") == 1


def test_help_imports_neither_qt_nor_vtk_nor_the_kernels():
    code = (
        "import sys; from app.cli import app; app('--help', exit_on_error=False);"
        "bad = {'PySide6', 'vtkmodules', 'pyvista', 'matplotlib', 'numba'} & set(sys.modules);"
        "sys.exit(str(bad) if bad else 0)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "compare" in done.stdout
