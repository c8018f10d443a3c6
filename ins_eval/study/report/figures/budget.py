"""The budget of effects: rms of each part of the flown error, by class and calibration."""

import html
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise

import numpy as np
import pandas as pd
from numpy.typing import NDArray

from ins_eval.study.report.figures.marks import calibration_title, marked
from ins_eval.study.report.result import StudyResult
from ins_eval.study.tables import columns as c
from pyhrg.common.pages import svg

Array = NDArray[np.float64]

RESAMPLES = 1000
SEED = 0
"""Of the intervals' bootstrap."""
BAR = 140
"""Width of a stacked bar, px."""


@dataclass(frozen=True)
class Rms:
    """Root mean square over flights with its 95 % interval, m."""

    value: float
    low: float
    high: float


def rms(rows: pd.DataFrame, north: str, east: str) -> Rms:
    """Of a radial error; the bootstrap draws triads, all flights of one together."""
    squares = rows[north] ** 2 + rows[east] ** 2
    by_triad = squares.groupby(rows[c.TRIAD]).agg(["sum", "count"]).to_numpy(float)
    drawn = _draws(len(by_triad)) @ by_triad
    low, high = np.quantile(np.sqrt(drawn[:, 0] / drawn[:, 1]), (0.025, 0.975))
    return Rms(float(np.sqrt(squares.mean())), float(low), float(high))


@lru_cache
def _draws(n: int) -> Array:
    """(RESAMPLES, n) how often each of n triads is drawn."""
    counts = np.random.default_rng(SEED).multinomial(n, np.full(n, 1 / n), RESAMPLES)
    return counts.astype(float)


def budget(result: StudyResult) -> str:
    """Bars and figures as one table."""
    rows = "".join(
        _row(str(name), str(calibration), flights)
        for (name, calibration), flights in result.table.groupby([c.CLASS, c.CALIBRATION])
    )
    heads = ("Class", "Calibration", "Shares of the mean square", *c.PARTS, "flown", "flights")
    head = "".join(f'<th scope="col">{h}</th>' for h in heads)
    return (
        f'{_legend()}<div class="wide"><table class="matrix"><caption>rms of each part and of the '
        "flown error, m, with 95 % intervals (bootstrap over triads, "
        f"{RESAMPLES:,} draws, seed {SEED}); both halves. Parts add as vectors: shares are of the "
        "sum of their mean squares."
        f"</caption><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table></div>"
    )


def _row(name: str, calibration: str, flights: pd.DataFrame) -> str:
    parts = {key: rms(flights, c.part(key, "north"), c.part(key, "east")) for key in c.PARTS}
    flown = rms(flights, c.FLOWN_NORTH, c.FLOWN_EAST)
    cells = "".join(
        f"<td><b>{svg.number(r.value)}</b><br><small>{svg.number(r.low)} to "
        f"{svg.number(r.high)}</small></td>"
        for r in (*parts.values(), flown)
    )
    return (
        f'<tr{marked(name, calibration)}><th scope="row">{html.escape(name)}</th>'
        f"<td>{html.escape(calibration_title(calibration))}</td><td>{_bar(parts)}</td>{cells}"
        f"<td>{len(flights):,}</td></tr>"
    )


def shares(parts: Mapping[str, Rms]) -> dict[str, float]:
    """Of the sum of mean squares."""
    total = sum(r.value**2 for r in parts.values()) or 1.0
    return {key: r.value**2 / total for key, r in parts.items()}


def _bar(parts: Mapping[str, Rms]) -> str:
    held = shares(parts)
    ends = np.cumsum([0.0, *held.values()]) * BAR
    blocks = "".join(
        f'<rect class="p{place}" x="{start:.1f}" width="{end - start:.1f}" height="18"/>'
        for place, (start, end) in enumerate(pairwise(ends))
    )
    label = ", ".join(f"{key} {share:.0%}" for key, share in held.items())
    return (
        f'<svg class="shares" width="{BAR}" height="18" role="img" aria-label="{label}">'
        f"{blocks}</svg>"
    )


def _legend() -> str:
    entries = "".join(
        f'<li><svg width="14" height="14" aria-hidden="true"><rect class="p{place}" width="14" '
        f'height="14"/></svg> {html.escape(f"{key}: {what}")}</li>'
        for place, (key, what) in enumerate(c.PARTS.items())
    )
    return f'<ul class="legend" aria-label="Parts of the error">{entries}</ul>'
