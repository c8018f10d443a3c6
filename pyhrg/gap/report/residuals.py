"""The section of residuals: panels, and what they can be picked by."""

import html
from collections.abc import Mapping

from pyhrg.common.pages.markup import paragraph
from pyhrg.gap.diagnose import Diagnosed
from pyhrg.gap.report.figures.panels import ALL, Panel, markup, panels
from pyhrg.gap.report.figures.views import AXES, VIEWS, Axis

LEAD = (
    "Mean residual, record less simulation, in bins of each coordinate. The grey band holds 95 % "
    "of bins where there is nothing but noise, so one bin in twenty lies outside by chance. The "
    "upper and the lower strip have scales of their own where they differ much."
)


def residuals(found: Diagnosed) -> str:
    """Lead, pickers (hidden until the script runs), panels by channel."""
    drawn = panels(found)
    put_in = found.closed != found.believed
    groups = "".join(
        f'<div class="view" data-group="{view.key}"><h3>{view.title}</h3><div class="panels">'
        f"{''.join(markup(p, put_in) for p in drawn.panels if p.view == view)}</div></div>"
        for view in VIEWS
    )
    notes = ""
    if drawn.left_out:
        notes = paragraph(f"Without panels of their own: {', '.join(drawn.left_out)}.", "weak")
    none = '<p id="none" hidden>That test does not move along this coordinate.</p>'
    return f"{paragraph(LEAD)}{_pickers(found, drawn.panels)}{none}{groups}{notes}"


def _pickers(found: Diagnosed, drawn: tuple[Panel, ...]) -> str:
    tests = dict.fromkeys(p.test for p in drawn if p.test != ALL)
    axes = {p.axis for p in drawn}
    return (
        '<form id="filters" hidden aria-label="Which residuals are shown">'
        + _choice("view", "Channel", {v.key: v.title for v in VIEWS}, _first(found))
        + _choice("test", "Test", {ALL: "all together", **{t: t for t in tests}}, ALL)
        + _choice("axis", "Against", {ALL: "everything"} | _titles(axes), ALL)
        + "</form>"
    )


def _titles(axes: set[Axis]) -> dict[str, str]:
    return {a.key: a.title for a in AXES if a in axes}


def _first(found: Diagnosed) -> str:
    """The view of the channel with most of the gap; of the angle's two the rate, which shows where
    a gap comes about."""
    shares: dict[str, float] = {}
    for place in found.diagnosis.where:
        shares[place.channel] = shares.get(place.channel, 0.0) + place.share
    most = max(shares, key=lambda c: shares[c], default="gyro_angle")
    return next(v.key for v in reversed(VIEWS) if v.channel == most)


def _choice(key: str, title: str, options: Mapping[str, str], first: str) -> str:
    listed = "".join(
        f'<option value="{html.escape(value)}"{" selected" if value == first else ""}>'
        f"{html.escape(text)}</option>"
        for value, text in options.items()
    )
    return f'<label>{title} <select name="{key}" autocomplete="off">{listed}</select></label>'
