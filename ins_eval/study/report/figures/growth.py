"""Growth of the flown error over time: quantiles of flights, by class and calibration."""

import html
from dataclasses import dataclass

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ins_eval.common.metrics import MIN_SAMPLE_FOR_MEDIAN, median_interval
from ins_eval.study.report.figures.filters import (
    choose_colour,
    make_filter_attributes,
    name_calibration,
)
from ins_eval.study.report.figures.parts import (
    Panel,
    Row,
    draw_axes,
    join_panels,
    make_fold,
    make_table,
)
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables import columns as c
from pyhrg.common.pages import svg
from pyhrg.common.pages.markup import make_paragraph

Array = NDArray[np.float64]

SHARES = (0.05, 0.5, 0.95)
HEADER = ("Class", "Calibration", "hours", "median, nmi", "95 % interval", "5 to 95 %, nmi", "n")
CAPTION = "Horizontal error at the end; the median's interval from order statistics; n flights"


@dataclass(frozen=True)
class Growth:
    """Quantiles of the error over time.

    hours: (k,); quantiles: (k, 3) at `SHARES`; low, high: 95 % interval of the last median, NaN
    with too few flights; n: number of flights that reach the last hour.
    """

    hours: Array
    quantiles: Array
    low: float
    high: float
    n: int


def compute_growth(flights: pd.Series) -> Growth:
    """Growth of flights from their errors every `GROWTH_STEP_HOURS`; shorter flights count while
    they last."""
    errors = [np.asarray(values, dtype=float) for values in flights]
    longest = max(map(len, errors))
    padded = np.full((len(errors), longest), np.nan)
    for row, values in zip(padded, errors, strict=True):
        row[: len(values)] = values
    last = padded[:, -1][np.isfinite(padded[:, -1])]
    low, high = median_interval(last) if len(last) >= MIN_SAMPLE_FOR_MEDIAN else (np.nan, np.nan)
    hours = c.GROWTH_STEP_HOURS * np.arange(1.0, longest + 1.0)
    quantiles: Array = np.nanquantile(padded, SHARES, axis=0).T
    return Growth(hours, quantiles, low, high, len(last))


def render_growth(data: StudyData) -> str:
    """A panel for each class, and a table of the final errors."""
    flights = data.table[data.table[c.GROWTH].map(len) > 0]
    if not len(flights):
        return make_paragraph("All flights are shorter than 10 min.")
    grown = {
        (str(mission_class), str(calibration)): compute_growth(rows[c.GROWTH])
        for (mission_class, calibration), rows in flights.groupby([c.CLASS, c.CALIBRATION])
    }
    limits = svg.find_decades(np.concatenate([g.quantiles.ravel() for g in grown.values()]))
    panels = join_panels(
        _make_panel(data, name, {k: g for (n, k), g in grown.items() if n == name}, limits)
        for name in dict.fromkeys(name for name, _ in grown)
    )
    rows = (_make_row(name, calibration, g) for (name, calibration), g in grown.items())
    return panels + make_fold("Final errors as a table", make_table(CAPTION, HEADER, rows))


def _make_panel(
    data: StudyData, name: str, grown: dict[str, Growth], limits: tuple[float, float]
) -> Panel:
    x = svg.make_horizontal_scale(0.0, max(g.hours[-1] for g in grown.values()), log=False)
    y = svg.make_vertical_scale(*limits)
    curves = "".join(_draw_curve(g, x, y, key) for key, g in grown.items())
    label = f"{name}: growth of the error over time; the table below has its figures"
    return Panel(
        title=name,
        body=draw_axes(x, y, ("navigating, h", "horizontal error, nmi"), curves, label),
        attributes=f'{make_filter_attributes(name)} class="growth {choose_colour(data, name)}"',
    )


def _draw_curve(grown: Growth, x: svg.Scale, y: svg.Scale, calibration: str) -> str:
    at = x(grown.hours)
    low, middle, high = y(np.maximum(grown.quantiles, y.low)).T
    band = svg.draw_line(np.concatenate([at, at[::-1]]), np.concatenate([low, high[::-1]]))
    name = html.escape(calibration)
    return (
        f'<g{make_filter_attributes(calibration=calibration)} class="{name}">'
        f'<path class="band" d="{band}Z"/><path class="median" d="{svg.draw_line(at, middle)}"/>'
        f'<text x="{at[-1] - 4:.0f}" y="{middle[-1] - 6:.0f}" text-anchor="end">{name}</text></g>'
    )


def _make_row(name: str, calibration: str, grown: Growth) -> Row:
    low, middle, high = map(svg.format_number, grown.quantiles[-1])
    cells = [
        name_calibration(calibration),
        svg.format_number(grown.hours[-1]),
        middle,
        f"{svg.format_number(grown.low)} to {svg.format_number(grown.high)}",
        f"{low} to {high}",
        f"{grown.n:,}",
    ]
    return Row(name, list(map(html.escape, cells)), make_filter_attributes(name, calibration))
