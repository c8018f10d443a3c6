"""Residuals before and after against each coordinate, channel by channel, test by test."""

import html
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.gap.diagnose import Diagnosed
from pyhrg.gap.report.figures.bins import Bins, Means, Residual, edges, gathered
from pyhrg.gap.report.figures.strips import Band, Labels, Size, Strip, drawing
from pyhrg.gap.report.figures.views import AXES, VIEWS, Axis, View, along, moving, noises

Array = NDArray[np.float64]

ALL = "all"
SIZE = Size(420, 112, 5)
MOST = 330
"""Panels of single tests; a page of more is heavy."""


@dataclass(frozen=True)
class Panel:
    """A view against an axis; test: its id, or `ALL`."""

    test: str
    view: View
    axis: Axis
    means: Means


@dataclass(frozen=True)
class Panels:
    """All of them, and the tests that have none of their own for want of room."""

    panels: tuple[Panel, ...]
    left_out: tuple[str, ...]


def panels(found: Diagnosed) -> Panels:
    """Gather all residuals."""
    where = [along(test, found.believed) for test in found.tests]
    bounds = _bounds(where)
    room, own = MOST, []
    left_out = []
    pooled: dict[tuple[View, Axis], Bins] = {}
    for i in _order(found):
        axes = moving(where[i])
        fits = len(axes) * len(VIEWS) <= room
        room -= len(axes) * len(VIEWS) if fits else 0
        left_out += [] if fits else [found.tests[i].test.id]
        for number, view in enumerate(VIEWS):
            residual = _residual(found, i, view, number)
            own += [_own(found, i, view, a, where[i], residual) for a in axes if fits]
            for axis, limits in bounds.items():
                bins = gathered(where[i][axis.key], limits, axis, residual)
                key = (view, axis)
                pooled[key] = pooled[key] + bins if key in pooled else bins
    every = [Panel(ALL, view, axis, bins.means) for (view, axis), bins in pooled.items()]
    return Panels(tuple(p for p in (*every, *own) if len(p.means.at)), tuple(left_out))


def markup(panel: Panel, put_in: bool) -> str:
    """A figure with its caption.

    Args:
        panel: of residuals.
        put_in: whether anything was put into the gyro; else there is no after.
    """
    m, view, axis = panel.means, panel.view, panel.axis
    strips = [Strip("gyro as believed", "c1", m.at, m.before, m.before)]
    counts = f"outside the band: {m.outside(m.before)} of {len(m.at)} bins"
    if put_in:
        strips.append(Strip("with what was found", "c0", m.at, m.after, m.after))
        counts += f" before, {m.outside(m.after)} after"
    of = "all tests" if panel.test == ALL else panel.test
    title = f"{view.title} against {axis.title[0].lower()}{axis.title[1:]}"
    labels = Labels(
        f"{axis.title}, {axis.unit}", f"{view.title}, {view.unit}", f"{title}, {of}; {counts}"
    )
    svg = drawing(strips, Band(m.at, m.band, m.width), SIZE, labels)
    hidden = "" if panel.test == ALL else " hidden"
    return (
        f'<figure data-test="{html.escape(panel.test)}" data-view="{view.key}" '
        f'data-axis="{axis.key}"{hidden}><figcaption><b>{html.escape(title)}</b>, '
        f'{html.escape(of)}<br><span class="weak">{counts}</span></figcaption>{svg}</figure>'
    )


def _residual(found: Diagnosed, i: int, view: View, number: int) -> Residual:
    test, noise = found.tests[i], found.noise
    before, after = (
        view.shown(residuals[i][view.channel], test.log.interval)
        for residuals in (found.before, found.after)
    )
    return Residual(before, after, noises(test, view, noise, (i, number)))


def _own(
    found: Diagnosed, i: int, view: View, axis: Axis, where: dict[str, Array], residual: Residual
) -> Panel:
    values = where[axis.key]
    limits = edges(axis, float(np.nanmin(values)), float(np.nanmax(values)))
    return Panel(found.tests[i].test.id, view, axis, gathered(values, limits, axis, residual).means)


def _bounds(where: Sequence[dict[str, Array]]) -> dict[Axis, Array]:
    """Bins for all tests together, of axes along which they differ."""
    found = {}
    for axis in AXES:
        together = {axis.key: np.concatenate([w[axis.key] for w in where])}
        low, high = float(np.nanmin(together[axis.key])), float(np.nanmax(together[axis.key]))
        if high - low > axis.least:
            found[axis] = edges(axis, low, high)
    return found


def _order(found: Diagnosed) -> list[int]:
    """Tests, held-out ones first, then those with most of the gap."""
    shares: dict[str, float] = {}
    for place in found.diagnosis.where:
        shares[place.test] = shares.get(place.test, 0.0) + place.share
    tests = [t.test for t in found.tests]
    return sorted(
        range(len(tests)), key=lambda i: (not tests[i].is_holdout, -shares.get(tests[i].id, 0.0), i)
    )
