"""Panels of the residuals against each coordinate, by channel and by test: mean residuals in bins
of the coordinate, with the 95 % band of noise in each bin.
"""

import html
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array

from pyhrg.common.arrays import Array
from pyhrg.gap.campaign_diagnosis import CampaignDiagnosis
from pyhrg.gap.evidence.noise.noise_hypothesis import NORMAL_95
from pyhrg.gap.findings.localisation import sum_shares
from pyhrg.gap.report.figures.strips import Band, Labels, Size, Strip, draw_strips
from pyhrg.gap.report.figures.views import (
    AXES,
    FULL_TURN,
    VIEWS,
    Axis,
    View,
    compute_axis_values,
    draw_view_noise,
    find_moving_axes,
)


@dataclass(frozen=True)
class Residual:
    """Residual of a channel in a test, in the unit of its view.

    before, after: (n,) of the nominal and of the identified gyro; NaN where record and simulation
        are not compared.
    noise: (n, d) simulated noise of the channel, d independent draws.
    """

    before: Array
    after: Array
    noise: Array


@dataclass(frozen=True)
class Bins:
    """Sums over the rows of each of b bins.

    edges: (b + 1,) of the bins, in the coordinate's unit.
    counts: (b,) rows.
    before, after: (b,) residual of the nominal and of the identified gyro.
    noise: (b, d) simulated noise.
    """

    edges: Array
    counts: Array
    before: Array
    after: Array
    noise: Array

    def __add__(self, other: "Bins") -> "Bins":
        """Sums over the rows of two tests, in the same bins."""
        names = ("counts", "before", "after", "noise")
        return Bins(self.edges, *(getattr(self, name) + getattr(other, name) for name in names))

    @property
    def means(self) -> "Means":
        """Mean residual of the bins that have rows."""
        kept = self.counts > 0
        n = self.counts[kept]
        centres = (self.edges[1:] + self.edges[:-1])[kept] / 2
        band = NORMAL_95 * np.sqrt((self.noise[kept] ** 2).mean(axis=1)) / n
        width = float(self.edges[1] - self.edges[0])
        return Means(centres, width, self.before[kept] / n, self.after[kept] / n, band)


@dataclass(frozen=True)
class Means:
    """Mean residual in each bin that has rows, (b,) each.

    centres: of the bins, in the coordinate's unit.
    width: of a bin.
    before, after: mean residual of the nominal and of the identified gyro.
    band: half width of the interval around zero that holds the mean of noise with 95 % probability.
    """

    centres: Array
    width: float
    before: Array
    after: Array
    band: Array

    def count_outside(self, values: Array) -> int:
        """Number of bins whose value lies outside the band."""
        return int((np.abs(values) > self.band).sum())


def compute_edges(axis: Axis, low: float, high: float) -> Array:
    """(b + 1,) edges of bins over a range, whose ends are the centres of the first and of the last
    bin. The bins of an angle cover a full turn."""
    if axis.is_angle:
        return np.linspace(0.0, FULL_TURN, axis.bins + 1)
    half = (high - low) / (axis.bins - 1) / 2
    return np.linspace(low - half, high + half, axis.bins + 1)


def sum_in_bins(values: Array, edges: Array, axis: Axis, residual: Residual) -> Bins:
    """Sums over the rows of each bin, by the coordinate's value (n,) at each row. Rows outside all
    bins and rows that are not compared are left out."""
    place = np.mod(values, FULL_TURN) if axis.is_angle else values
    rows = np.isfinite(residual.before) & np.isfinite(residual.after) & np.isfinite(place)
    index = np.searchsorted(edges, place[rows], side="right") - 1
    index[place[rows] == edges[-1]] = len(edges) - 2
    b = len(edges) - 1
    # noise is drawn for all rows and summed over the rows that are compared
    sums = csr_array((np.ones(len(index)), (index, np.arange(len(index)))), shape=(b, len(index)))
    return Bins(
        edges,
        np.bincount(index, minlength=b).astype(float),
        sums @ residual.before[rows],
        sums @ residual.after[rows],
        sums @ residual.noise[rows],
    )


def find_extremes(values: Array, count: int) -> tuple[Array, Array, Array]:
    """Middle row, lowest and highest value of each stretch of rows that has values (n,); NaN is
    none. There are at most `count` stretches."""
    stretches = np.array_split(np.arange(len(values)), min(count, len(values)))
    kept = [s for s in (s[np.isfinite(values[s])] for s in stretches) if len(s)]
    return (
        np.array([s[len(s) // 2] for s in kept], dtype=float),
        np.array([values[s].min() for s in kept]),
        np.array([values[s].max() for s in kept]),
    )


ALL = "all"
"""Stands for all tests together."""
SIZE = Size(420, 112, 5)
MAX_PANELS = 330
"""Largest number of panels of single tests, which keeps the page below 3 MB (chosen)."""


@dataclass(frozen=True)
class Panel:
    """A view against an axis, of one test (its id) or of all (`ALL`)."""

    test: str
    view: View
    axis: Axis
    means: Means


@dataclass(frozen=True)
class Panels:
    """All panels, and the tests that have no panels of their own for lack of room."""

    panels: tuple[Panel, ...]
    left_out: tuple[str, ...]


def compute_panels(result: CampaignDiagnosis) -> Panels:
    """Mean residuals of all views against all coordinates that change, for all tests together and
    for each test."""
    values = [compute_axis_values(test, result.nominal) for test in result.tests]
    edges = _compute_common_edges(values)
    room, single = MAX_PANELS, []
    left_out = []
    pooled: dict[tuple[View, Axis], Bins] = {}
    for i in _order_tests(result):
        axes = find_moving_axes(values[i])
        fits = len(axes) * len(VIEWS) <= room
        room -= len(axes) * len(VIEWS) if fits else 0
        left_out += [] if fits else [result.tests[i].test.id]
        for number, view in enumerate(VIEWS):
            residual = _compute_residual(result, i, view, number)
            for axis in axes if fits else ():
                own = values[i][axis.key]
                limits = compute_edges(axis, float(np.nanmin(own)), float(np.nanmax(own)))
                means = sum_in_bins(own, limits, axis, residual).means
                single.append(Panel(result.tests[i].test.id, view, axis, means))
            for axis, limits in edges.items():
                bins = sum_in_bins(values[i][axis.key], limits, axis, residual)
                key = (view, axis)
                pooled[key] = pooled[key] + bins if key in pooled else bins
    together = [Panel(ALL, view, axis, bins.means) for (view, axis), bins in pooled.items()]
    kept = tuple(p for p in (*together, *single) if len(p.means.centres))
    return Panels(kept, tuple(left_out))


def draw_panel(panel: Panel, has_after: bool) -> str:
    """A figure with its caption; `has_after` where the identified gyro differs from the nominal
    one."""
    m, view, axis = panel.means, panel.view, panel.axis
    strips = [Strip("nominal gyro", "c1", m.centres, m.before, m.before)]
    counts = f"outside the band: {m.count_outside(m.before)} of {len(m.centres)} bins"
    if has_after:
        strips.append(Strip("identified gyro", "c0", m.centres, m.after, m.after))
        counts += f" before, {m.count_outside(m.after)} after"
    tests = "all tests" if panel.test == ALL else panel.test
    title = f"{view.title} against {axis.title[0].lower()}{axis.title[1:]}"
    labels = Labels(
        f"{axis.title}, {axis.unit}", f"{view.title}, {view.unit}", f"{title}, {tests}; {counts}"
    )
    svg = draw_strips(strips, Band(m.centres, m.band, m.width), SIZE, labels)
    hidden = "" if panel.test == ALL else " hidden"
    return (
        f'<figure data-test="{html.escape(panel.test)}" data-view="{view.key}" '
        f'data-axis="{axis.key}"{hidden}><figcaption><b>{html.escape(title)}</b>, '
        f'{html.escape(tests)}<br><span class="weak">{counts}</span></figcaption>{svg}</figure>'
    )


def _compute_residual(result: CampaignDiagnosis, i: int, view: View, number: int) -> Residual:
    test = result.tests[i]
    before, after = (
        view.convert(residuals[i][view.channel], test.log.interval)
        for residuals in (result.before, result.after)
    )
    return Residual(before, after, draw_view_noise(test, view, result.noise, (i, number)))


def _compute_common_edges(values: Sequence[dict[str, Array]]) -> dict[Axis, Array]:
    """Edges of bins for all tests together, of the axes that change within or between tests."""
    edges = {}
    for axis in AXES:
        pooled = np.concatenate([each[axis.key] for each in values])
        low, high = float(np.nanmin(pooled)), float(np.nanmax(pooled))
        if high - low > axis.smallest_range:
            edges[axis] = compute_edges(axis, low, high)
    return edges


def _order_tests(result: CampaignDiagnosis) -> list[int]:
    """Indices of the tests: held-out ones first, then by their share of the gap."""
    shares = sum_shares(result.diagnosis.where, lambda place: place.test)
    tests = [t.test for t in result.tests]
    return sorted(
        range(len(tests)), key=lambda i: (not tests[i].is_holdout, -shares[tests[i].id], i)
    )
