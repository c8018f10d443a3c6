"""Residuals of the nominal and of the identified gyro, beside the noise floor."""

import numpy as np

from pyhrg.common.pages.markup import make_paragraph
from pyhrg.common.pages.svg import Scale, find_decades, format_interval, format_number
from pyhrg.gap.campaign_diagnosis import CampaignDiagnosis
from pyhrg.gap.findings.diagnosis import Gap, GapFigure
from pyhrg.gap.report.words import build_table

WIDTH = 240
"""Width of a drawn scale, px."""
UNITS = {
    "angle_arcsec": ("output angle, rms", "arcsec"),
    "rate_deg_h": ("rate over 100 s, rms", "deg/h"),
    "area_arcsec": ("output angle, area between its distribution and the noise's", "arcsec"),
}
NOT_VERIFIED = "No test was held out, so the identified gyro is not verified."
ROLES = {"holdout": "held out", "fit": "fitted"}
WHITE_P_VALUE = 0.01
"""p-value of the Ljung-Box test from which the residual is called white (chosen)."""


def build_closing(result: CampaignDiagnosis) -> str:
    """A table of the residuals' sizes with drawn scales, and sentences on it."""
    gap = result.diagnosis.gap
    rows = [
        row for unit, (what, name) in UNITS.items() for row in _make_rows(gap, unit, what, name)
    ]
    header = ("Residual", "Tests", "Before", "After", "Noise floor (95 %)", "")
    title = (
        "Residual of the nominal gyro (before, orange) and of the identified gyro (after, blue); "
        "noise floor grey. Nothing was fitted to held-out tests"
    )
    return build_table(title, header, rows) + "".join(
        make_paragraph(sentence) for sentence in describe_closing(gap)
    )


def describe_closing(gap: Gap) -> list[str]:
    """Sentences on the reduction of the held-out residual and on its whiteness."""
    if gap.holdout_angle_arcsec is None:
        return [NOT_VERIFIED]
    if gap.shrink_percent is None:
        sentences = [
            "On the held-out tests the angle residual of the nominal gyro lies within the 95 % "
            "interval of the noise floor: there is no excess to reduce."
        ]
    else:
        low, high = compute_reduction_interval(gap.holdout_angle_arcsec)
        sentences = [
            "On the held-out tests the excess of the angle residual over the noise floor fell by "
            f"{gap.shrink_percent:.1f} % ({low:.1f} to {high:.1f} % over the floor's 95 % "
            "interval; more than 100 % means that the residual is below the mean floor)."
        ]
    if gap.whiteness is not None:
        is_white = gap.whiteness >= WHITE_P_VALUE
        verdict = "is compatible with white noise" if is_white else "is not white"
        sentences.append(
            f"The held-out residual of the identified gyro {verdict} (Ljung-Box test over 10 rows, "
            f"p = {format_number(gap.whiteness)})."
        )
    return sentences


def compute_reduction_interval(figure: GapFigure) -> tuple[float, float]:
    """Reduction of the residual's excess over the noise floor, per cent, at the two ends of the
    floor's 95 % interval; the smaller one first."""
    ends = [100 * (figure.before - figure.after) / (figure.before - f) for f in figure.floor_95]
    return min(ends), max(ends)


def _make_rows(gap: Gap, unit: str, what: str, name: str) -> list[tuple[str, ...]]:
    figures = {role: getattr(gap, f"{role}_{unit}", None) for role in ROLES}
    known = {role: f for role, f in figures.items() if f is not None}
    limits = find_decades([v for f in known.values() for v in (f.before, f.after, *f.floor_95)])
    return [
        (
            f"{what}, {name}",
            ROLES[role],
            format_number(f.before),
            format_number(f.after),
            format_interval(f.floor, *f.floor_95),
            _draw_scale(f, limits),
        )
        for role, f in known.items()
    ]


def _draw_scale(figure: GapFigure, limits: tuple[float, float]) -> str:
    scale = Scale(limits[0], limits[1], 6, WIDTH - 6)
    ends = np.clip([*figure.floor_95, figure.before, figure.after], limits[0], limits[1])
    low, high, before, after = (float(v) for v in scale(ends))
    return (
        f'<svg class="scale" viewBox="0 0 {WIDTH} 16" width="{WIDTH}" aria-hidden="true">'
        f'<path class="axis" d="M6 8H{WIDTH - 6}"/>'
        f'<rect class="noise" x="{low:.1f}" y="2" width="{max(high - low, 1):.1f}" height="12"/>'
        f'<circle class="c1" cx="{before:.1f}" cy="8" r="4.5"/>'
        f'<circle class="c0" cx="{after:.1f}" cy="8" r="4.5"/></svg>'
    )
