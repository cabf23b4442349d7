"""The reference page: every entry of every registry has its place."""

import pytest

from app.export.reference import STATISTICS, entry_title, reference_page
from app.export.statistics_plots import PLOTS
from core.fields import FIELDS
from core.metrics import METRICS
from core.smoothing import METHODS


@pytest.mark.parametrize("entry", [*METHODS, *METRICS, *FIELDS, *STATISTICS])
def test_every_entry_has_a_heading(entry):
    assert f"\n## {entry_title(entry)}" in reference_page()


def test_every_plot_of_the_statistics_has_an_entry():
    assert set(PLOTS) <= set(STATISTICS)


def test_an_entry_has_formula_parameters_and_source():
    page = reference_page()
    part = page[page.index("## Geodesic distances") : page.index("## Laplacian spectrum")]
    for text in ("`neighbours` (1 to 100; default 8)", "*Source:* Zhang", "heat method"):
        assert text in part
    assert ":func:" not in page
    assert METHODS["diffusion"].formula in page


def test_a_switch_is_written_as_it_is_set():
    assert "`clamp_negative` (true or false; default true)" in reference_page()
