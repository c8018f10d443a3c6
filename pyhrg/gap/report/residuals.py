"""Residuals of the nominal and of the identified gyro: by coordinate, with pickers of channel, test
and coordinate, and over time on held-out tests.
"""

import html

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.pages.markup import make_choice, make_paragraph
from pyhrg.gap.campaign_diagnosis import CampaignDiagnosis
from pyhrg.gap.evidence.noise.noise_hypothesis import NORMAL_95
from pyhrg.gap.findings.localisation import sum_shares
from pyhrg.gap.report.closing import NOT_VERIFIED
from pyhrg.gap.report.figures.panels import ALL, Panel, compute_panels, draw_panel, find_extremes
from pyhrg.gap.report.figures.strips import Band, Labels, Size, Strip, draw_strips
from pyhrg.gap.report.figures.views import ANGLE, AXES, VIEWS, View, draw_view_noise
from pyhrg.records import Log

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


def draw_largest(result: CampaignDiagnosis) -> str:
    """A figure of the channel and the test with the largest share of the gap; of the output angle
    in the last test, a held-out one if any is, where there is no gap."""
    shares = sum_shares(result.diagnosis.where, lambda place: (place.test, place.channel))
    last = (result.tests[-1].test.id, ANGLE.channel)
    name, channel = max(shares, key=lambda key: shares[key], default=last)
    i = [test.test.id for test in result.tests].index(name)
    view = next(view for view in VIEWS if view.channel == channel)
    if not np.isfinite(result.before[i][channel]).any():
        return ""
    return f'<div class="panels one">{_draw_test(result, i, view)}</div>'


def _draw_test(result: CampaignDiagnosis, i: int, view: View = ANGLE) -> str:
    test = result.tests[i]
    before, after = (residuals[i][view.channel] for residuals in (result.before, result.after))
    strips = [_make_strip("nominal gyro", "c1", test.log, before, view)]
    if has_closing(result):
        strips.append(_make_strip("identified gyro", "c0", test.log, after, view))
    title = f"{view.title}, record less simulation, {test.test.id}"
    labels = Labels("Time since power-on, s", f"Residual, {view.unit}", title)
    svg = draw_strips(strips, _compute_band(result, i, view), SIZE, labels)
    return f"<figure><figcaption><b>{html.escape(title)}</b></figcaption>{svg}</figure>"


def has_closing(result: CampaignDiagnosis) -> bool:
    """Whether the identified gyro, with its terms, differs from the nominal one."""
    return result.identified != result.nominal or bool(result.diagnosis.terms)


def _make_strip(label: str, colour: str, log: Log, residual: Array, view: View) -> Strip:
    rows, low, high = find_extremes(view.convert(residual, log.interval), POINTS)
    return Strip(label, colour, log.time[rows.astype(int)], low, high, is_joined=True)


def _compute_band(result: CampaignDiagnosis, i: int, view: View) -> Band:
    test = result.tests[i]
    noise = draw_view_noise(test, view, result.noise, (i,))
    parts = np.array_split(np.arange(len(noise)), min(BAND_BINS, len(noise)))
    half = np.array([NORMAL_95 * np.sqrt((noise[part] ** 2).mean()) for part in parts])
    middles = np.array([test.log.time[part].mean() for part in parts])
    return Band(middles, half, float(np.ptp(test.log.time)) / len(parts))


LEAD = (
    "Mean residual (record less simulation) in bins of each coordinate. The grey band holds 95 % "
    "of the bins where there is only noise: one bin in twenty lies outside by chance. The upper "
    "and the lower strip have scales of their own where their ranges differ much."
)


def build_residuals(result: CampaignDiagnosis) -> str:
    """A lead, pickers that are hidden until the script runs, and panels by channel."""
    drawn = compute_panels(result)
    has_after = has_closing(result)
    groups = "".join(
        f'<div class="view" data-group="{view.key}"><h3>{view.title}</h3><div class="panels">'
        f"{''.join(draw_panel(p, has_after) for p in drawn.panels if p.view == view)}</div></div>"
        for view in VIEWS
    )
    left_out = f"Tests without panels of their own, for lack of room: {', '.join(drawn.left_out)}."
    notes = make_paragraph(left_out, "weak") if drawn.left_out else ""
    none = '<p id="none" hidden>This coordinate does not change in that test.</p>'
    return f"{make_paragraph(LEAD)}{_build_pickers(result, drawn.panels)}{none}{groups}{notes}"


def _build_pickers(result: CampaignDiagnosis, drawn: tuple[Panel, ...]) -> str:
    tests = dict.fromkeys(p.test for p in drawn if p.test != ALL)
    moving = {p.axis for p in drawn}
    axes = {a.key: a.title for a in AXES if a in moving}
    return (
        '<form id="filters" hidden aria-label="Which residuals are shown">'
        + make_choice("view", "Channel", {v.key: v.title for v in VIEWS}, _pick_view(result))
        + make_choice("test", "Test", {ALL: "all tests", **{t: t for t in tests}}, ALL)
        + make_choice("axis", "Coordinate", {ALL: "all", **axes}, ALL)
        + "</form>"
    )


def _pick_view(result: CampaignDiagnosis) -> str:
    """The view that is shown first: of the channel with the largest share of the gap. The output
    angle is shown as a rate, which shows when a gap arises."""
    shares = sum_shares(result.diagnosis.where, lambda place: place.channel)
    largest = max(shares, key=lambda c: shares[c], default="gyro_angle")
    return next(v.key for v in reversed(VIEWS) if v.channel == largest)
