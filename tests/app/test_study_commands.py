"""A study as file, command line and script: three ways to the same numbers."""

import contextlib
import io
import json
import shlex

import pytest

from app.cli import main
from app.export.study_script import script_of
from app.study_words import command_of, study_of_words
from core.comparison import run
from core.io import save_mesh
from core.mesh import primitives
from core.noise import NoiseParams, add_noise
from core.study import MethodChoice, Study
from core.study_files import write_study_file


@pytest.fixture(autouse=True)
def _own_cache(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))


@pytest.fixture
def study(tmp_path):
    path = tmp_path / "a ball's.ply"
    save_mesh(primitives.sphere(2), path)
    return Study(
        model=str(path),
        noise=NoiseParams(sigma=0.1234567890123, seed=3),
        methods=(
            MethodChoice(method="mean", iterations=3),
            MethodChoice(method="median", iterations=2, enabled=False),
            MethodChoice(method="bilateral", iterations=2, params={"sigma_c": 1.5}),
            MethodChoice(
                method="diffusion", iterations=4, params={"gradient_scale": 14.0, "form": "printed"}
            ),
        ),
    )


@pytest.fixture
def file(study, tmp_path):
    path = tmp_path / "one.burnish"
    write_study_file(study, path)
    return path


def call(capsys, *words):
    with pytest.raises(SystemExit) as stop:
        main([str(word) for word in words])
    output = capsys.readouterr()
    return stop.value.code, output.out, output.err


def errors(result):
    return {method["id"]: method["visual_error"] for method in result["methods"]}


def expected(study):
    results = run(study).methods
    return {result.choice.method: list(result.errors["visual_error"]) for result in results}


def test_compare_runs_a_study_file(capsys, study, file):
    status, out, err = call(capsys, "compare", "--study", file, "--json")
    assert (status, err) == (0, "")
    assert errors(json.loads(out)) == expected(study)


def test_the_command_line_of_a_study_gives_its_numbers(capsys, study, file):
    words = shlex.split(call(capsys, "study", file)[1])
    assert words[:2] == ["burnish", "compare"]
    out = call(capsys, *words[1:], "--json")[1]
    assert errors(json.loads(out)) == expected(study)


@pytest.mark.parametrize("model_units", [False, True])
def test_the_script_of_a_study_gives_its_numbers(capsys, study, file, model_units):
    study = study.model_copy(update={"model_units": model_units})
    write_study_file(study, file)
    script = call(capsys, "study", file, "--as", "python")[1]
    results = run(study).methods
    assert printed_by(script) == {
        "noisy": {name: values[0] for name, values in results[0].errors.items()},
        **{r.choice.method: {n: v[-1] for n, v in r.errors.items()} for r in results},
    }


def printed_by(script):
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(script, "script", "exec"), {"__name__": "script"})
    rows = (line.split() for line in printed.getvalue().splitlines())
    return {
        name: {id_: float(value) for id_, value in (pair.split("=") for pair in pairs)}
        for name, *pairs in rows
    }


def test_a_bundled_model_a_noisy_file_and_no_method_are_described_too(tmp_path):
    from core.io import load_sample

    scan = tmp_path / "scan.ply"
    save_mesh(add_noise(load_sample("double_torus"), 0.1), scan)
    study = Study(model="sample:double_torus", noisy=str(scan), methods=())
    words = shlex.split(command_of(study))
    assert words == ["burnish", "compare", "sample:double_torus", "--noisy", str(scan),
                     "--methods", "none"]  # fmt: skip
    assert study_of_words(words[2], noisy=words[4], methods=words[6]) == study
    noisy = run(study).comparison.noisy_errors
    assert printed_by(script_of(study)) == {"noisy": noisy}


def test_a_method_that_diverges_is_told_by_the_script(study, capsys):
    wild = {"form": "printed", "gradient_scale": 0.01}
    choice = MethodChoice(method="diffusion", iterations=9, params=wild)
    study = study.model_copy(update={"methods": (choice,)})
    diverged = run(study).methods[0].diverged
    exec(compile(script_of(study), "script", "exec"), {"__name__": "script"})
    assert f"diffusion diverged at iteration {diverged}" in capsys.readouterr().out


def test_options_change_what_they_name(file, study):
    changed = study_of_words(
        None, file=file, noise={"sigma": 0.2, "seed": None}, methods="median,mean",
        settings=["mean.iterations=7"],
    )  # fmt: skip
    assert changed.noise == NoiseParams(sigma=0.2, seed=3)
    assert [(c.method, c.iterations, c.enabled) for c in changed.methods] == [
        ("median", 2, True),
        ("mean", 7, True),
    ]


def test_a_missing_model_can_be_named(capsys, study, file, tmp_path):
    moved = tmp_path / "moved.ply"
    (tmp_path / "a ball's.ply").rename(moved)
    status, out, err = call(capsys, "compare", "--study", file, "--json")
    assert (status, out) == (2, "")
    assert "is not at" in err
    assert "Name the file to use before --study." in err
    out = call(capsys, "compare", moved, "--study", file, "--json")[1]
    assert errors(json.loads(out)) == expected(study.model_copy(update={"model": str(moved)}))


def test_a_changed_model_is_used_only_when_named(capsys, file, tmp_path):
    ball = tmp_path / "a ball's.ply"
    save_mesh(primitives.sphere(1), ball)
    status, _, err = call(capsys, "compare", "--study", file)
    assert status == 2
    assert "is not the one the study was saved with" in err
    assert err.count("\n") == 1
    assert call(capsys, "compare", ball, "--study", file)[0] == 0


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["compare", "--study", "gone.burnish"], "gone.burnish: there is no such file."),
        (["study", "gone.burnish"], "gone.burnish: there is no such file."),
        (["study", "FILE", "--as", "cake"], "cake"),
        (["compare", "--study", "FILE", "--set", "median.size=1"], "median does not take part"),
    ],
)
def test_bad_words_are_one_line_and_status_2(capsys, file, words, message):
    status, out, err = call(capsys, *(str(file) if w == "FILE" else w for w in words))
    assert (status, out) == (2, "")
    assert message in err
    assert err.count("\n") == 1
