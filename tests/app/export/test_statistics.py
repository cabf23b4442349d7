"""The command ``stats``, its files, and the plots, tables and words behind them."""

import csv
import io
import json
from dataclasses import replace

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from scipy.io import mmread

from app.cli import main
from app.export.statistics_plots import PLOTS, save_statistics_plot
from app.export.statistics_series import SERIES_COLOURS, Series
from app.export.statistics_tables import plot_tables
from app.export.statistics_words import plot_words
from app.scene.colours import DARK, LIGHT
from core import mesh_statistics
from core.io import SaveError, save_mesh
from core.mesh import TriangleMesh, primitives
from core.statistics import Progress, SpectrumParams, StatisticsError, connectivity

BALL = primitives.sphere(2)


@pytest.fixture(scope="module")
def ball():
    return Series.of_statistics("ball", mesh_statistics(BALL, spectrum=SpectrumParams()))


@pytest.fixture
def ball_file(tmp_path):
    path = tmp_path / "ball.ply"
    save_mesh(BALL, path)
    return str(path)


def call(capsys, *arguments):
    with pytest.raises(SystemExit) as stop:
        main([str(argument) for argument in arguments])
    output = capsys.readouterr()
    return stop.value.code, output.out, output.err


def test_json_has_the_documented_keys(capsys, ball_file):
    status, out, err = call(capsys, "stats", ball_file, "--json")
    result = json.loads(out)
    assert (status, err) == (0, "")
    assert (result["vertices"], result["edges"], result["faces"]) == (162, 480, 320)
    assert result["average_degree"] == pytest.approx(960 / 162)
    assert result["degree"] == {"5": pytest.approx(12 / 162), "6": pytest.approx(150 / 162)}
    assert result["clustering"] == {"5": pytest.approx(0.5), "6": pytest.approx(0.4)}
    assert result["assortativity"]["5"] == 6
    assert len(result["spectrum"]["eigenvalues"]) == 162
    assert result["spectrum"]["zero_eigenvalues"] == 1
    assert sum(result["geodesic"]["counts"]) == result["geodesic"]["pairs"] == 162 * 161


def test_equal_degrees_leave_no_bare_nan(capsys, tmp_path):
    path = tmp_path / "torus.ply"
    save_mesh(primitives.torus(), path)
    out = call(capsys, "stats", path, "--json")[1]
    assert json.loads(out)["assortativity_coefficient"] is None
    assert "NaN" not in out


def test_text_says_what_a_person_wants_to_know(capsys, ball_file):
    status, out, _ = call(capsys, "stats", ball_file, "--along", "edges", "--sources", 50)
    assert status == 0
    for text in ("average degree", "5.9259", "93 % have 6", "Spectrum", "λ₂", "peak"):
        assert text in out


def test_what_is_refused_is_said_in_words_beside_all_the_rest(capsys, ball_file, monkeypatch):
    def refuse(*_):
        yield Progress(None, 0.0)
        raise StatisticsError("It does not converge.")

    monkeypatch.setattr("core.statistics.statistics.spectrum_steps", refuse)
    status, out, err = call(capsys, "stats", ball_file)
    assert (status, err) == (0, "")
    assert "Spectrum: Eigenvalues of the Laplacian, largest first. ball" in out
    assert out.count("It does not converge.") == 2
    assert "93 % have 6" in out
    result = json.loads(call(capsys, "stats", ball_file, "--json")[1])
    assert result["spectrum"] is result["normalized_spectrum"] is None
    assert set(result["refusals"]) == {"spectrum", "normalized_spectrum"}
    assert result["geodesic"]["pairs"] == 162 * 161


@pytest.mark.parametrize("plot", ["spectrum", "geodesic"])
def test_a_plot_without_a_curve_says_why_inside_its_axes(ball, plot):
    reason = "The extreme eigenvalues do not converge on this mesh, which is long and thin."
    refused = replace(ball, **{plot: None}, refusals={plot: reason})
    figure = Figure((4, 3), layout="constrained")
    axes = PLOTS[plot].draw(figure, [refused], LIGHT)
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    (text,) = axes.texts
    assert text.get_text().replace("\n", " ") == f"ball: {reason}"
    box, room = text.get_window_extent(canvas.get_renderer()), axes.bbox
    assert room.x0 <= box.x0 < box.x1 <= room.x1
    assert reason in plot_words(plot, [refused])


def test_folder_gets_figure_plots_tables_and_matrices(capsys, ball_file, tmp_path):
    folder = tmp_path / "out"
    assert call(capsys, "stats", ball_file, "-o", folder, "--matrices")[0] == 0
    names = {path.name for path in folder.iterdir()}
    plots = {f"{plot}.svg" for plot in PLOTS}
    tables = {f"{name}.csv" for name in (*PLOTS, "assortativity_histogram", "clustering_histogram")}
    matrices = {
        f"{name}{suffix}"
        for name in ("adjacency", "edge", "degree", "laplacian", "normalized_laplacian")
        for suffix in (".mtx", ".npz")
    }
    assert names == {"statistics.json", "figure.png", "figure.pdf"} | plots | tables | matrices
    laplacian = mmread(folder / "laplacian.mtx")
    assert laplacian.shape == (162, 162)
    assert np.abs(laplacian.sum(axis=0)).max() == 0


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["gone.ply"], "gone.ply"),
        (["BALL", "--along", "sea"], "geodesic.along=sea is not allowed; use neighbours or"),
        (["BALL", "--sources", "0"], "geodesic.sources=0 is not allowed"),
        (["BALL", "--matrices"], "--matrices needs a folder"),
        (["BALL", "-o", "BALL"], "cannot be written"),
    ],
)
def test_bad_input_is_one_line_and_status_2(capsys, ball_file, arguments, message):
    words = [ball_file if word == "BALL" else word for word in arguments]
    status, out, err = call(capsys, "stats", *words)
    assert (status, out) == (2, "")
    assert message in err
    assert err.count("\n") == 1


@pytest.mark.parametrize("plot", PLOTS)
@pytest.mark.parametrize("theme", [LIGHT, DARK])
def test_one_model_two_models_or_half_a_model_are_drawn(ball, plot, theme):
    other = Series.of_vertices("grid", SERIES_COLOURS[1], connectivity(primitives.grid()))
    figure = Figure(layout="constrained")
    for series in ([], [ball], [ball, other], [other]):
        axes = PLOTS[plot].draw(figure, series, theme)
        figure.canvas.draw()
        assert len(axes.figure.legends) == (len(series) == 2)
        assert plot_words(plot, series) or not series


@pytest.mark.parametrize("plot", PLOTS)
@pytest.mark.parametrize("name", ["grid", "the scan of the second day, cleaned"])
def test_legend_of_a_small_plot_covers_no_curve(ball, plot, name):
    other = Series.of_vertices(name, SERIES_COLOURS[1], connectivity(primitives.grid()))
    figure = Figure(figsize=(2.5, 1.7), dpi=100, layout="constrained")
    axes = PLOTS[plot].draw(figure, [ball, other], LIGHT)
    FigureCanvasAgg(figure).draw()
    (legend,) = figure.legends
    place = legend.get_window_extent()
    assert place.x0 >= 0
    assert place.x1 <= 250
    assert place.y0 >= axes.get_window_extent().y1


def test_bars_have_the_heights_of_the_shares(ball):
    axes = PLOTS["degree"].draw(Figure(), [ball], LIGHT)
    assert [bar.get_height() for bar in axes.patches] == pytest.approx([12 / 162, 150 / 162])


@pytest.mark.parametrize("plot", PLOTS)
def test_tables_hold_the_numbers_of_every_model(ball, plot):
    for table in plot_tables(plot, [ball, ball]):
        rows = list(csv.DictReader(io.StringIO(table.text())))
        assert len(rows) == len(table.rows) > 0
        assert tuple(rows[0]) == table.columns
        assert rows[0]["model"] == "ball"
    assert "\t" in plot_tables(plot, [ball])[0].text("\t")


@pytest.mark.parametrize("plot", PLOTS.values(), ids=PLOTS)
def test_labels_of_a_small_plot_are_whole_and_apart(ball, plot):
    figure = Figure(figsize=(2, 2), dpi=100, layout="constrained")
    canvas = FigureCanvasAgg(figure)
    axes = plot.draw(figure, [ball], LIGHT)
    canvas.draw()
    labels = [
        one for each in (axes, *axes.child_axes) for one in (each.xaxis.label, each.yaxis.label)
    ]
    boxes = [one.get_window_extent() for one in labels if one.get_text()]
    assert all(box.y0 >= 0 and box.y1 <= 200 for box in boxes)
    numbers = [tick.get_window_extent() for tick in axes.get_xticklabels() if tick.get_text()]
    for child in axes.child_axes:
        assert child.xaxis.label.get_window_extent().count_overlaps(numbers) == 0


@pytest.mark.parametrize("suffix", [".png", ".svg", ".pdf"])
def test_plots_are_written_the_same_twice(ball, tmp_path, suffix):
    first, second = tmp_path / f"a{suffix}", tmp_path / f"b{suffix}"
    for path in (first, second):
        save_statistics_plot(path, PLOTS["geodesic"], [ball])
    assert first.read_bytes() == second.read_bytes()


def test_other_suffix_is_refused(ball, tmp_path):
    with pytest.raises(SaveError, match=r"use .png .svg .pdf"):
        save_statistics_plot(tmp_path / "plot.bmp", PLOTS["degree"], [ball])


def test_hub_of_very_many_neighbours_gets_a_logarithmic_scale():
    around = np.arange(1, 101)
    faces = np.stack([np.zeros_like(around), around, np.roll(around, -1)], axis=1)
    fan = TriangleMesh(np.random.default_rng(0).standard_normal((101, 3)), faces)
    series = Series.of_vertices("fan", SERIES_COLOURS[0], connectivity(fan))
    axes = PLOTS["degree"].draw(Figure(), [series], LIGHT)
    assert axes.get_xscale() == "log"
