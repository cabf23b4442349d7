"""Studies: what they hold, how they run, and the thesis' three experiments."""

import numpy as np
import pytest

from core.comparison import run
from core.io import LoadError, save_mesh
from core.mesh import TriangleMesh, primitives
from core.noise import NoiseParams, add_noise
from core.parameters import ParameterError
from core.smoothing import METHODS
from core.study import MethodChoice, Study


@pytest.fixture
def ball_file(tmp_path):
    path = tmp_path / "ball.ply"
    save_mesh(primitives.sphere(3), path)
    return path


def test_a_study_survives_json(ball_file):
    study = Study(
        model=str(ball_file),
        methods=(MethodChoice(method="diffusion", iterations=3, params={"gradient_scale": 20}),),
    )
    assert Study.model_validate_json(study.model_dump_json()) == study


def test_skeletons_do_not_make_another_comparison(ball_file):
    study = Study(model=str(ball_file))
    skeleton = study.skeleton.model_copy(update={"opacity": 0.5})
    assert study.model_copy(update={"skeleton": skeleton}).compares_like(study)
    assert not study.model_copy(update={"metric": "vertex_rms"}).compares_like(study)


def test_a_study_is_frozen():
    with pytest.raises(ValueError, match="frozen"):
        Study().model = "other"


def test_run_gives_every_error_of_every_iteration(ball_file):
    study = Study(model=str(ball_file), noise=NoiseParams(sigma=0.2))
    result = run(study)
    assert [m.choice.method for m in result.methods] == [m for m in METHODS if m != "laplacian"]
    for method in result.methods:
        assert method.iterations == 6
        assert len(method.errors["visual_error"]) == 7
        assert method.errors["visual_error"][0] == result.comparison.noisy_errors["visual_error"]
        assert method.seconds_per_iteration > 0
        assert method.diverged is None


def test_a_diverging_method_keeps_its_last_good_mesh_and_disturbs_nobody(ball_file):
    wild = MethodChoice(
        method="diffusion",
        iterations=20,
        params={"form": "printed", "raw_units": True, "c": 1000},
    )
    calm = MethodChoice(method="mean", iterations=4)
    far = primitives.sphere(3)
    save_mesh(far.with_vertices(far.vertices + 30), ball_file)
    diverged, fine = run(Study(model=str(ball_file), methods=(wild, calm))).methods
    assert diverged.diverged == diverged.iterations + 1
    assert np.isfinite(diverged.mesh.vertices).all()
    assert len(diverged.errors["visual_error"]) == diverged.iterations + 1
    assert (fine.diverged, fine.iterations) == (None, 4)


def test_a_noisy_file_takes_the_place_of_noise(ball_file, tmp_path):
    noisy = add_noise(primitives.sphere(3), 0.3)
    path = tmp_path / "noisy.obj"
    save_mesh(noisy, path)
    result = run(Study(model=str(ball_file), noisy=str(path), methods=()))
    assert result.comparison.noisy.vertices == pytest.approx(noisy.vertices)


def test_a_noisy_file_that_does_not_match_is_refused(ball_file, tmp_path):
    path = tmp_path / "other.ply"
    save_mesh(primitives.torus(), path)
    with pytest.raises(ParameterError, match="288 vertices and the original 642"):
        run(Study(model=str(ball_file), noisy=str(path)))
    ball = primitives.sphere(3)
    save_mesh(TriangleMesh(ball.vertices, (ball.faces + 1) % 642), path)
    with pytest.raises(ParameterError, match="other faces"):
        run(Study(model=str(ball_file), noisy=str(path)))


def test_a_missing_model_is_one_sentence(tmp_path):
    with pytest.raises(LoadError, match=r"gone\.ply"):
        run(Study(model=str(tmp_path / "gone.ply")))


@pytest.mark.parametrize(
    ("model", "iterations", "noisy", "diffusion", "others"),
    [
        ("cow_92864.ply", 18, 0.0022, 0.0021, {"median": 0.0045}),
        ("rocker_arm_40177.obj", 12, 0.0013, 0.0013, {"median": 0.0045}),
        ("foot_bones_2154.ply", 3, 0.0021, 0.0021, {}),
    ],
)
def test_the_thesis_experiments(shared_models, model, iterations, noisy, diffusion, others):
    choices = tuple(
        MethodChoice(method=m, iterations=iterations) for m in METHODS if m != "laplacian"
    )
    result = run(Study(model=str(shared_models / model), methods=choices))
    final = {m.choice.method: m.errors["visual_error"][-1] for m in result.methods}
    assert result.comparison.noisy_errors["visual_error"] == pytest.approx(noisy, rel=0.05)
    assert final["diffusion"] == pytest.approx(diffusion, rel=0.05)
    assert final["diffusion"] < result.comparison.noisy_errors["visual_error"]
    assert min(final, key=final.get) == "diffusion"
    for method, error in others.items():
        assert final[method] == pytest.approx(error, rel=0.05)
    angles = {m.choice.method: m.errors["normal_angle"] for m in result.methods}
    assert angles["diffusion"][-1] < angles["diffusion"][0]


def test_printed_diffusion_in_raw_units_diverges_on_the_cow(shared_models):
    wild = MethodChoice(
        method="diffusion", iterations=18, params={"form": "printed", "raw_units": True}
    )
    calm = MethodChoice(method="median", iterations=2)
    diverged, fine = run(
        Study(model=str(shared_models / "cow_92864.ply"), methods=(wild, calm))
    ).methods
    assert diverged.diverged is not None
    assert diverged.diverged <= 5
    assert fine.diverged is None


def test_model_units_change_the_error_and_nothing_else(ball_file):
    ball = primitives.sphere(3)
    save_mesh(ball.with_vertices(10 * ball.vertices), ball_file)
    choices = (MethodChoice(method="mean", iterations=2),)
    relative = run(Study(model=str(ball_file), methods=choices))
    absolute = run(Study(model=str(ball_file), methods=choices, model_units=True))
    unit = relative.comparison.original.mean_edge_length
    ours, theirs = absolute.methods[0], relative.methods[0]
    assert np.array_equal(ours.mesh.vertices, theirs.mesh.vertices)
    for error, expected in zip(ours.errors["vertex_rms"], theirs.errors["vertex_rms"], strict=True):
        assert error == pytest.approx(unit * expected)
    assert ours.errors["visual_error"] != theirs.errors["visual_error"]
    assert ours.errors["normal_angle"] == theirs.errors["normal_angle"]
