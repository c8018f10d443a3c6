"""How the flown error grows: median and 5 to 95 % of the flights, by class and calibration."""

import html
from dataclasses import dataclass

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ins_eval.common.metrics import FEWEST_FOR_MEDIAN, median_interval
from ins_eval.study.report.figures.marks import calibration_title, colour, marked
from ins_eval.study.report.result import StudyResult
from ins_eval.study.tables import columns as c
from pyhrg.common.pages import svg
from pyhrg.common.pages.markup import paragraph

Array = NDArray[np.float64]

SHARES = (0.05, 0.5, 0.95)


@dataclass(frozen=True)
class Growth:
    """hours: (k,); quantiles: (k, 3) m, of `SHARES`; low, high: of the last median's 95 %
    interval (NaN: too few flights); n: flights that reach the last hour."""

    hours: Array
    quantiles: Array
    low: float
    high: float
    n: int


def growth(flights: pd.Series) -> Growth:
    """Of flights' errors every `GROWTH_STEP_HOURS`; those that end sooner count while they last."""
    errors = [np.asarray(values, dtype=float) for values in flights]
    longest = max(map(len, errors))
    padded = np.full((len(errors), longest), np.nan)
    for row, values in zip(padded, errors, strict=True):
        row[: len(values)] = values
    last = padded[:, -1][np.isfinite(padded[:, -1])]
    low, high = median_interval(last) if len(last) >= FEWEST_FOR_MEDIAN else (np.nan, np.nan)
    hours = c.GROWTH_STEP_HOURS * np.arange(1.0, longest + 1.0)
    quantiles: Array = np.nanquantile(padded, SHARES, axis=0).T
    return Growth(hours, quantiles, low, high, len(last))


def panels(result: StudyResult) -> str:
    """A panel a class, and the figures at the end as a table."""
    grown = {
        (str(mission_class), str(calibration)): growth(rows[c.GROWTH])
        for (mission_class, calibration), rows in _lasting(result).groupby([c.CLASS, c.CALIBRATION])
    }
    if not grown:
        return paragraph("All flights are shorter than 10 min.")
    limits = svg.decades(np.concatenate([g.quantiles.ravel() for g in grown.values()]))
    drawn = "".join(
        _figure(result, name, {k: g for (n, k), g in grown.items() if n == name}, limits)
        for name in dict.fromkeys(name for name, _ in grown)
    )
    return f'<div class="panels">{drawn}</div>{_table(grown)}'


def _lasting(result: StudyResult) -> pd.DataFrame:
    """Flights of a step at least."""
    return result.table[result.table[c.GROWTH].map(len) > 0]


def _figure(
    result: StudyResult, name: str, grown: dict[str, Growth], limits: tuple[float, float]
) -> str:
    x = svg.across(0.0, max(g.hours[-1] for g in grown.values()), log=False)
    y = svg.up(*limits)
    curves = "".join(_curve(g, x, y, key) for key, g in grown.items())
    title = html.escape(name)
    return (
        f'<figure{marked(name)} class="growth {colour(result, name)}"><figcaption><b>{title}</b>'
        f'</figcaption><svg viewBox="0 0 {svg.WIDTH} {svg.HEIGHT}" role="img" '
        f'aria-label="{title}: growth of the error over time; the table below has its figures">'
        f"{svg.frame(x, y, 'navigating, h', 'horizontal error, m')}{curves}</svg></figure>"
    )


def _curve(grown: Growth, x: svg.Scale, y: svg.Scale, calibration: str) -> str:
    at = x(grown.hours)
    low, middle, high = y(np.maximum(grown.quantiles, y.low)).T
    band = svg.line(np.concatenate([at, at[::-1]]), np.concatenate([low, high[::-1]]))
    return (
        f'<g{marked(calibration=calibration)} class="{html.escape(calibration)}">'
        f'<path class="band" d="{band}Z"/><path class="median" d="{svg.line(at, middle)}"/>'
        f'<text x="{at[-1] - 4:.0f}" y="{middle[-1] - 6:.0f}" text-anchor="end">'
        f"{html.escape(calibration)}</text></g>"
    )


def _table(grown: dict[tuple[str, str], Growth]) -> str:
    rows = "".join(_row(name, calibration, g) for (name, calibration), g in grown.items())
    heads = ("Class", "Calibration", "hours", "median, m", "95 % interval", "5 to 95 %, m", "n")
    head = "".join(f'<th scope="col">{h}</th>' for h in heads)
    return (
        '<details><summary>At the end, as a table</summary><div class="wide"><table>'
        "<caption>Horizontal error at the end; the median's interval from order statistics; "
        f"n flights, both halves</caption><thead><tr>{head}</tr></thead><tbody>{rows}</tbody>"
        "</table></div></details>"
    )


def _row(name: str, calibration: str, grown: Growth) -> str:
    low, middle, high = map(svg.number, grown.quantiles[-1])
    cells = (
        calibration_title(calibration),
        svg.number(grown.hours[-1]),
        middle,
        f"{svg.number(grown.low)} to {svg.number(grown.high)}",
        f"{low} to {high}",
        f"{grown.n:,}",
    )
    data = "".join(f"<td>{html.escape(cell)}</td>" for cell in cells)
    return f'<tr{marked(name, calibration)}><th scope="row">{html.escape(name)}</th>{data}</tr>'
