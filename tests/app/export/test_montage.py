"""Figures of panes: where things stand, what is on them, and the files."""

from dataclasses import replace

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.image import imread
from PIL import Image

from app.export.montage import montage_figure
from app.export.montage_files import montage_pixels, save_montage
from app.export.montage_panes import Source
from app.export.montage_plan import Cell, Montage, montage_layout
from app.export.pictures import PictureError
from app.scene.colours import DARK
from app.scene.panes import Look, Pane
from core.mesh import primitives

BALL = primitives.sphere(2)
POINTS = BALL.vertices.astype(np.float32)
CELLS = tuple(Cell(id_, id_.title()) for id_ in ("original", "noisy", "mean", "median"))
SOURCE = Source(tuple(Pane(c.pane, "", "", "#000000", POINTS) for c in CELLS), Look(BALL.topology))
MONTAGE = Montage(CELLS, columns=3, width=9, dpi=60)


def test_captions_have_letters():
    many = Montage(CELLS * 7)
    assert [many.caption(i) for i in (0, 1, 25, 26)] == [
        "(a) Original", "(b) Noisy", "(z) Noisy", "(aa) Mean",
    ]  # fmt: skip
    assert replace(many, letters=False).caption(1) == "Noisy"
    assert Montage((Cell("mean", ""),)).caption(0) == "(a)"


def test_pictures_are_square_side_by_side_and_a_short_last_row_is_centred():
    layout = montage_layout(MONTAGE, with_bar=False)
    assert layout.cell_width == pytest.approx(layout.cell_height)
    first, third, last = (layout.cell(MONTAGE, i) for i in (0, 2, 3))
    assert first[1] == third[1] > last[1]
    assert third[0] + third[2] == pytest.approx(9 - first[0])
    assert last[0] + last[2] / 2 == pytest.approx(4.5)
    with_bar = montage_layout(MONTAGE, with_bar=True)
    assert with_bar.cell_width < layout.cell_width


def test_fewer_pictures_than_columns_fill_the_width():
    pair = replace(MONTAGE, cells=CELLS[:2])
    layout = montage_layout(pair, with_bar=False)
    first, last = (layout.cell(pair, i) for i in (0, 1))
    assert last[0] + last[2] == pytest.approx(9 - first[0])


def test_the_size_in_centimetres_and_dpi_is_the_size_in_pixels():
    picture = montage_pixels(montage_figure(replace(MONTAGE, height=6, dpi=127), SOURCE))
    assert picture.shape == (300, 450, 4)


@pytest.mark.parametrize(
    "montage", [Montage(()), replace(MONTAGE, width=1), Montage(CELLS, height=1)]
)
def test_what_cannot_be_drawn_is_one_sentence(montage):
    with pytest.raises(PictureError, match=r"^The figure .*\.$"):
        montage_figure(montage, SOURCE)


def test_every_pane_is_drawn_in_its_place():
    montage = replace(MONTAGE, dpi=80)
    picture = montage_pixels(montage_figure(montage, SOURCE)).astype(int)
    layout = montage_layout(montage, with_bar=False)
    for place in range(4):
        left, bottom, wide, high = np.array(layout.cell(montage, place)) / 2.54 * 80
        row = round(picture.shape[0] - bottom - high / 2)
        assert picture[row, round(left + wide / 2), 0] < 230
        corner = round(picture.shape[0] - bottom - 3), round(left + 3)
        assert picture[corner][0] == 255


def test_the_grounds():
    white, clear, dark = (
        montage_pixels(montage_figure(replace(MONTAGE, ground=ground), source))
        for ground, source in (
            ("white", SOURCE),
            ("transparent", SOURCE),
            ("theme", replace(SOURCE, look=Look(BALL.topology, theme=DARK))),
        )
    )
    assert tuple(white[1, 1]) == (255, 255, 255, 255)
    assert clear[1, 1, 3] == 0
    assert clear[..., 3].max() == 255
    assert dark[1, 1, 0] < 60


def test_coloured_panes_get_one_bar():
    values = np.linspace(0, 1, len(POINTS))
    panes = tuple(replace(pane, values=values) for pane in SOURCE.panes)
    look = replace(SOURCE.look, colour_title="Normal angle\n(°)", colour_range=(0, 1))
    source = Source(panes, look)
    assert len(montage_figure(MONTAGE, source).axes) == 5
    assert len(montage_figure(replace(MONTAGE, bar=False), source).axes) == 4
    texts = [text.get_text() for text in montage_figure(MONTAGE, source).texts]
    assert texts[0] == "(a) Original"
    assert "Normal angle" in texts[-1]


def test_files_have_the_resolution_and_are_the_preview(tmp_path):
    figure = montage_figure(MONTAGE, SOURCE)
    for suffix in (".png", ".pdf", ".tiff", ".tif"):
        save_montage(figure, tmp_path / f"f{suffix}")
    saved = np.round(imread(tmp_path / "f.png") * 255).astype(int)
    assert np.abs(saved - montage_pixels(figure).astype(int)).max() <= 1
    with Image.open(tmp_path / "f.tiff") as tiff:
        assert tiff.info["dpi"] == (60, 60)
    assert (tmp_path / "f.pdf").read_bytes().startswith(b"%PDF")


def test_a_wrong_suffix_or_place_is_one_sentence(tmp_path):
    figure = montage_figure(MONTAGE, SOURCE)
    with pytest.raises(PictureError, match=r"f\.gif: figures are not written"):
        save_montage(figure, tmp_path / "f.gif")
    with pytest.raises(PictureError, match=r"cannot be written: No such file"):
        save_montage(figure, tmp_path / "no" / "f.png")


def test_a_caption_that_does_not_fit_is_wrapped_below_its_picture():
    words = "Bilateral filter of the noisy cow after twelve iterations, seen from the left"
    long = replace(MONTAGE, cells=(*CELLS[:3], Cell("median", words)))
    layout = montage_layout(long, with_bar=False)
    lines = long.caption_lines(3, layout.cell_width)
    assert " ".join(lines) == f"(d) {words}"
    assert len(lines) > 2
    assert long.caption_lines(0, layout.cell_width) == ["(a) Original"]
    plain = montage_layout(MONTAGE, with_bar=False)
    assert layout.height > plain.height

    figure = montage_figure(long, SOURCE)
    canvas = FigureCanvasAgg(figure)
    text = next(text for text in figure.texts if text.get_text().startswith("(d)"))
    box = text.get_window_extent(canvas.get_renderer())
    left, _, wide, _ = (length * 60 / 2.54 for length in layout.cell(long, 3))
    assert left - 3 <= box.x0
    assert box.x1 <= left + wide + 3
    assert box.y0 >= 0


def test_a_word_wider_than_its_picture_is_parted():
    lines = replace(MONTAGE, cells=(Cell("mean", "x" * 80),)).caption_lines(0, 2.0)
    assert len(lines) > 3
    assert "".join(lines).endswith("x" * 80)


def test_words_with_a_no_break_space_stay_together():
    caption = "Euclidean distance, R\u00a0=\u00a022"
    lines = replace(MONTAGE, cells=(Cell("mean", caption),)).caption_lines(0, 4.0)
    assert lines == ["(a) Euclidean distance,", "R\u00a0=\u00a022"]
