"""The error budget: rms of each part of the flown error, by class and calibration."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise

import numpy as np
import pandas as pd

from ins_eval.study.report.distances import NMI
from ins_eval.study.report.figures.parts import (
    Row,
    format_interval,
    make_filter_attributes,
    make_legend,
    make_table,
    name_calibration,
)
from ins_eval.study.study_data import StudyData
from ins_eval.study.tables import columns as c
from pyhrg.common.arrays import Array

RESAMPLES = 1000
SEED = 0
"""Seed of the intervals' bootstrap."""
BAR = 140
"""Width of a stacked bar, px."""
CAPTION = (
    f"rms of each part and of the flown error, {NMI}, with 95 % intervals (bootstrap over triads, "
    f"{RESAMPLES:,} draws, seed {SEED}). Parts add as vectors: shares are of the sum "
    "of their mean squares."
)


@dataclass(frozen=True)
class Rms:
    """Root mean square over flights with its 95 % interval."""

    value: float
    low: float
    high: float


def estimate_rms(rows: pd.DataFrame, north: str, east: str) -> Rms:
    """Rms of a horizontal error; the bootstrap draws triads with all their flights."""
    squares = rows[north] ** 2 + rows[east] ** 2
    by_triad = squares.groupby(rows[c.TRIAD]).agg(["sum", "count"]).to_numpy(float)
    sums = _draw_counts(len(by_triad)) @ by_triad
    low, high = np.quantile(np.sqrt(sums[:, 0] / sums[:, 1]), (0.025, 0.975))
    return Rms(float(np.sqrt(squares.mean())), float(low), float(high))


@lru_cache
def _draw_counts(n: int) -> Array:
    """(RESAMPLES, n) how often each of n triads is drawn."""
    counts = np.random.default_rng(SEED).multinomial(n, np.full(n, 1 / n), RESAMPLES)
    return counts.astype(float)


def compute_shares(parts: Mapping[str, Rms]) -> dict[str, float]:
    """Share of each part in the sum of mean squares."""
    total = sum(r.value**2 for r in parts.values()) or 1.0
    return {key: r.value**2 / total for key, r in parts.items()}


def render_budget(data: StudyData) -> str:
    """Bars and figures in one table."""
    colours = [f"c{place}" for place in range(len(c.PARTS))]
    texts = [f"{key}: {what}" for key, what in c.PARTS.items()]
    legend = make_legend(
        (("", *entry) for entry in zip(colours, texts, strict=True)), "Parts of the error"
    )
    header = ("Class", "Calibration", "Shares of the mean square", *c.PARTS, "flown", "flights")
    groups = dict(iter(data.table.groupby([c.CLASS, c.CALIBRATION])))
    rows = (
        _make_row(name, calibration, groups[name, calibration])
        for calibration in data.calibrations
        for name in data.classes
        if (name, calibration) in groups
    )
    return legend + make_table(CAPTION, header, rows)


def _make_row(name: str, calibration: str, flights: pd.DataFrame) -> Row:
    parts = {
        key: estimate_rms(flights, c.name_part(key, "north"), c.name_part(key, "east"))
        for key in c.PARTS
    }
    flown = estimate_rms(flights, c.FLOWN_NORTH, c.FLOWN_EAST)
    cells = [
        name_calibration(calibration),
        _draw_bar(parts),
        *(format_interval(r.value, r.low, r.high) for r in (*parts.values(), flown)),
        f"{len(flights):,}",
    ]
    return Row(name, cells, make_filter_attributes(name, calibration))


def _draw_bar(parts: Mapping[str, Rms]) -> str:
    shares = compute_shares(parts)
    ends = np.cumsum([0.0, *shares.values()]) * BAR
    blocks = "".join(
        f'<rect class="c{place}" x="{start:.1f}" width="{end - start:.1f}" height="18"/>'
        for place, (start, end) in enumerate(pairwise(ends))
    )
    label = ", ".join(f"{key} {share:.0%}" for key, share in shares.items())
    return (
        f'<svg class="shares" width="{BAR}" height="18" role="img" aria-label="{label}">'
        f"{blocks}</svg>"
    )
