"""validation.png: entries of a legend differ, log axes are named, distances are in nmi and km."""

from itertools import combinations

import pytest
from matplotlib.axes import Axes
from matplotlib.colors import to_hex
from matplotlib.figure import Figure

from ins_eval.study.report.lead_case import read_lead_case
from ins_eval.study.summary.figure import draw_lead, draw_scatter
from tests.ins_eval.study.report.colours import SMALLEST_DIFFERENCE, measure_difference
from tests.ins_eval.study.report.synthetic import synthetic


@pytest.fixture(scope="module", params=["lead", "scatter"])
def axes(request: pytest.FixtureRequest) -> Axes:
    drawn = Figure().subplots()
    data = synthetic(4)
    if request.param == "lead":
        case = read_lead_case(data.about)
        assert case
        draw_lead(drawn, case)
    else:
        draw_scatter(drawn, data, "mean")
    return drawn


def test_entries_differ_in_colour_or_marker(axes: Axes) -> None:
    """Colours are those of tests, markers those of classes."""
    handles, labels = axes.get_legend_handles_labels()
    assert len(set(labels)) == len(labels) > 3
    for one, other in combinations(handles, 2):
        colours = (to_hex(each.get_color()) for each in (one, other))
        apart = measure_difference(*colours) > SMALLEST_DIFFERENCE
        assert apart or one.get_marker() != other.get_marker()


def test_log_axes_are_named_and_distances_have_both_units(axes: Axes) -> None:
    for axis in (axes.xaxis, axes.yaxis):
        text = axis.get_label_text()
        assert (axis.get_scale() == "log") == text.endswith(", log axis")
        assert "nmi" not in text or "nmi (1 nmi = 1.852 km)" in text
