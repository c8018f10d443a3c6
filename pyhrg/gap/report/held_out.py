"""The output angle on held-out tests over time, before and after."""

import html

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.pages.markup import paragraph
from pyhrg.gap.diagnose import Diagnosed
from pyhrg.gap.report.figures.bins import extremes
from pyhrg.gap.report.figures.strips import Band, Labels, Size, Strip, drawing
from pyhrg.gap.report.figures.views import VIEWS, noises

Array = NDArray[np.float64]

POINTS = 400
BAND_BINS = 60
SIZE = Size(860, 170, 1.6)
ANGLE = VIEWS[0]


def held_out(found: Diagnosed) -> str:
    """A figure each."""
    drawn = [
        _figure(found, i)
        for i, test in enumerate(found.tests)
        if test.test.is_holdout and np.isfinite(found.before[i][ANGLE.channel]).any()
    ]
    if not drawn:
        return paragraph(
            "No test was held out: nothing shows how the closed gyro fares on new ones."
        )
    return f'<div class="panels one">{"".join(drawn)}</div>'


def _figure(found: Diagnosed, i: int) -> str:
    test = found.tests[i]
    strips = [_strip("gyro as believed", "c1", found, found.before[i][ANGLE.channel], i)]
    if found.closed != found.believed:
        after = found.after[i][ANGLE.channel]
        strips.append(_strip("with what was found", "c0", found, after, i))
    title = f"Residual of the output angle, {test.test.id}"
    labels = Labels("Time since power-on, s", f"Residual, {ANGLE.unit}", title)
    svg = drawing(strips, _band(found, i), SIZE, labels)
    return f"<figure><figcaption><b>{html.escape(title)}</b></figcaption>{svg}</figure>"


def _strip(label: str, colour: str, found: Diagnosed, residual: Array, i: int) -> Strip:
    log = found.tests[i].log
    rows, low, high = extremes(ANGLE.shown(residual, log.interval), POINTS)
    return Strip(label, colour, log.time[rows.astype(int)], low, high, joined=True)


def _band(found: Diagnosed, i: int) -> Band:
    test = found.tests[i]
    drawn = noises(test, ANGLE, found.noise, (i,))
    parts = np.array_split(np.arange(len(drawn)), min(BAND_BINS, len(drawn)))
    half = np.array([1.96 * np.sqrt((drawn[part] ** 2).mean()) for part in parts])
    middles = np.array([test.log.time[part].mean() for part in parts])
    return Band(middles, half, float(np.ptp(test.log.time)) / len(parts))
