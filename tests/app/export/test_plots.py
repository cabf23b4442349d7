"""The error plot: what it draws, and what it writes to files."""

import math
from xml.etree import ElementTree

import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image

from app.export.chart import ErrorChart, ErrorCurve, method_of
from app.export.plots import draw_errors, save_error_plot
from app.scene.colours import DARK, LIGHT
from core.io import SaveError
from core.metrics import METRICS

METRIC = METRICS["visual_error"]
FALLING = ErrorCurve("mean", "Mean filter", "#e69f00", (0.4, 0.2, 0.1), iteration=1)
RISING = ErrorCurve("bilateral", "Bilateral", "#cc79a7", (0.4, 0.6, 0.8), iteration=2)
BURST = ErrorCurve("diffusion", "Diffusion", "#d55e00", (0.4, 9.0, 1e6), iteration=2, diverged=3)


def drawn(*curves, size=(6.0, 1.5), noisy_value=0.4, **options):
    """Draw curves and return their axes, laid out."""
    figure = Figure(figsize=size)
    axes = figure.add_subplot()
    draw_errors(axes, curves, noisy_value, METRIC, **options)
    FigureCanvasAgg(figure).draw()
    return axes


def parts(axes):
    return {artist.get_gid(): artist for artist in (*axes.lines, *axes.texts) if artist.get_gid()}


def texts(axes):
    return [text.get_text() for text in axes.texts]


def test_line_marker_and_noisy_input_stand_where_the_numbers_say():
    axes = drawn(FALLING)
    assert parts(axes)["mean.line"].get_xydata().tolist() == [[0, 0.4], [1, 0.2], [2, 0.1]]
    assert parts(axes)["mean.marker"].get_xydata().tolist() == [[1, 0.2]]
    level = [line for line in axes.lines if list(line.get_ydata()) == [0.4, 0.4]]
    assert level
    assert level[0].get_linestyle() == "--"


def test_labels_name_metric_unit_methods_and_noisy_input():
    axes = drawn(FALLING, RISING)
    assert axes.get_title(loc="left") == "Visual error (ℓ̄²)"
    assert axes.get_xlabel() == "iteration"
    assert texts(axes) == ["Mean filter", "Bilateral", "noisy input"]


@pytest.mark.parametrize("size", [(3.6, 1.3), (9.0, 1.5), (8.0, 4.0)])
def test_legend_covers_no_curve_and_nothing_is_cut_off(size):
    axes = drawn(FALLING, RISING, BURST, size=size)
    figure = axes.figure.bbox
    plot = axes.get_window_extent()
    for text in axes.texts:
        box = text.get_window_extent()
        assert figure.x0 <= box.x0
        assert box.x1 <= figure.x1 + 1
        assert figure.y0 <= box.y0
        assert box.y1 <= figure.y1 + 1
        if str(text.get_gid()).endswith("legend"):
            assert box.x0 > plot.x1


def test_selected_line_is_heavy_and_its_label_bold():
    axes = drawn(FALLING, RISING, selected="bilateral")
    found = parts(axes)
    assert found["bilateral.line"].get_linewidth() > found["mean.line"].get_linewidth()
    weights = {text.get_text(): text.get_fontweight() for text in axes.texts}
    assert weights["Bilateral"] == "bold"
    assert weights["Mean filter"] == "normal"


@pytest.mark.parametrize("log", [False, True])
def test_diverging_run_leaves_the_others_readable(log):
    axes = drawn(FALLING, BURST, log=log)
    low, high = axes.get_ylim()
    assert low <= 0.1
    assert 0.4 < high <= 20 * 0.4 * 1.2
    assert "diverged at 3" in texts(axes)
    assert parts(axes)["diffusion.cross"].get_xydata().tolist() == [[2, high]]


def test_only_diverging_runs_are_shown_as_they_are():
    assert drawn(BURST, noisy_value=None).get_ylim()[1] > 0


def test_logarithmic_scale_leaves_out_what_is_not_positive():
    exact = ErrorCurve("mean", "Mean filter", "#e69f00", (0.4, 0.0, 0.1), iteration=2)
    axes = drawn(exact, log=True)
    assert axes.get_yscale() == "log"
    assert 0 < axes.get_ylim()[0] < 0.1
    assert drawn(log=True, noisy_value=0.0).get_yscale() == "linear"


def test_values_that_are_not_finite_do_not_stretch_the_plot():
    wild = ErrorCurve("mean", "Mean filter", "#e69f00", (0.4, math.inf, math.nan), iteration=0)
    assert drawn(wild).get_ylim()[1] < 1


def test_drawing_again_replaces_what_was_drawn():
    axes = drawn(FALLING, RISING, log=True)
    draw_errors(axes, [FALLING], 0.4, METRIC, DARK)
    assert texts(axes) == ["Mean filter", "noisy input"]
    assert axes.get_yscale() == "linear"
    assert axes.get_facecolor() == drawn(FALLING, theme=DARK).get_facecolor()


def test_nothing_to_show_is_an_empty_plot():
    axes = drawn(noisy_value=None)
    assert texts(axes) == []


def test_every_artist_of_a_method_says_so():
    axes = drawn(FALLING, BURST)
    owners = {method_of(artist) for artist in (*axes.lines, *axes.texts)}
    assert owners == {"mean", "diffusion", None}


def test_frame_is_equal_while_only_markers_move():
    def frame(curve, **options):
        return ErrorChart((curve, RISING), 0.4, METRIC, LIGHT, **options).frame

    moved = ErrorCurve("mean", "Mean filter", "#e69f00", (0.4, 0.2, 0.1), iteration=2)
    assert frame(FALLING) == frame(moved)
    assert frame(FALLING) != frame(FALLING, log=True)
    assert frame(FALLING) != frame(FALLING, selected="mean")


def test_frame_stays_while_a_run_goes_on():
    def frame(*values):
        curve = ErrorCurve("mean", "Mean filter", "#e69f00", values, iteration=1)
        return ErrorChart((curve,), 0.4, METRIC, LIGHT, log=True, reach=9).frame

    assert frame(0.4, 0.21) == frame(0.4, 0.21, 0.2, 0.22)
    assert frame(0.4, 0.21) != frame(0.4, 0.21, 0.01)
    assert frame(0.4).last == 9
    assert frame(*[0.3] * 20).last == 19


def test_svg_holds_text_as_text_and_is_the_same_every_time(tmp_path):
    for name in ("first.svg", "second.svg"):
        save_error_plot(tmp_path / name, [FALLING, BURST], 0.4, METRIC)
    first = (tmp_path / "first.svg").read_text(encoding="utf-8")
    assert first == (tmp_path / "second.svg").read_text(encoding="utf-8")
    words = "".join(ElementTree.fromstring(first).itertext())
    for label in ("Mean filter", "noisy input", "Visual error", "diverged at 3"):
        assert label in words


def test_png_has_the_size_asked_for(tmp_path):
    save_error_plot(tmp_path / "plot.png", [FALLING], 0.4, METRIC, size=(4, 2), dpi=150)
    with Image.open(tmp_path / "plot.png") as image:
        assert image.size == (600, 300)


def test_pdf_embeds_fonts(tmp_path):
    save_error_plot(tmp_path / "plot.PDF", [FALLING], 0.4, METRIC)
    data = (tmp_path / "plot.PDF").read_bytes()
    assert data.startswith(b"%PDF")
    assert b"/FontFile2" in data


def test_unknown_suffix_is_refused(tmp_path):
    with pytest.raises(SaveError, match=r"plot\.bmp: plots are not .* use \.png \.svg \.pdf"):
        save_error_plot(tmp_path / "plot.bmp", [FALLING], 0.4, METRIC)
