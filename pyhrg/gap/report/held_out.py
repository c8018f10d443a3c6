"""Residual of the output angle on held-out tests over time, of the nominal and of the identified
gyro."""

import html

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.pages.markup import make_paragraph
from pyhrg.gap.diagnose import CampaignDiagnosis
from pyhrg.gap.report.closing import NOT_VERIFIED
from pyhrg.gap.report.figures.bins import find_extremes
from pyhrg.gap.report.figures.strips import Band, Labels, Size, Strip, draw_strips
from pyhrg.gap.report.figures.views import ANGLE, draw_view_noise
from pyhrg.records import Log

Array = NDArray[np.float64]

POINTS = 400
"""Stretches of rows of which a strip shows the lowest and the highest value."""
BAND_BINS = 60
"""Stretches of rows that the noise band is computed in."""
SIZE = Size(860, 170, 1.6)


def build_held_out(result: CampaignDiagnosis) -> str:
    """A figure for each held-out test."""
    figures = [
        _draw_test(result, i)
        for i, test in enumerate(result.tests)
        if test.test.is_holdout and np.isfinite(result.before[i][ANGLE.channel]).any()
    ]
    if not figures:
        return make_paragraph(NOT_VERIFIED)
    return f'<div class="panels one">{"".join(figures)}</div>'


def _draw_test(result: CampaignDiagnosis, i: int) -> str:
    test = result.tests[i]
    before, after = (residuals[i][ANGLE.channel] for residuals in (result.before, result.after))
    strips = [_make_strip("nominal gyro", "c1", test.log, before)]
    if result.identified != result.nominal:
        strips.append(_make_strip("identified gyro", "c0", test.log, after))
    title = f"Residual of the output angle, {test.test.id}"
    labels = Labels("Time since power-on, s", f"Residual, {ANGLE.unit}", title)
    svg = draw_strips(strips, _compute_band(result, i), SIZE, labels)
    return f"<figure><figcaption><b>{html.escape(title)}</b></figcaption>{svg}</figure>"


def _make_strip(label: str, colour: str, log: Log, residual: Array) -> Strip:
    rows, low, high = find_extremes(ANGLE.convert(residual, log.interval), POINTS)
    return Strip(label, colour, log.time[rows.astype(int)], low, high, is_joined=True)


def _compute_band(result: CampaignDiagnosis, i: int) -> Band:
    test = result.tests[i]
    noise = draw_view_noise(test, ANGLE, result.noise, (i,))
    parts = np.array_split(np.arange(len(noise)), min(BAND_BINS, len(noise)))
    half = np.array([1.96 * np.sqrt((noise[part] ** 2).mean()) for part in parts])
    middles = np.array([test.log.time[part].mean() for part in parts])
    return Band(middles, half, float(np.ptp(test.log.time)) / len(parts))
