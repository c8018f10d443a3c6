"""The section of residuals by coordinate: panels, and pickers of channel, test and coordinate."""

from pyhrg.common.pages.markup import make_choice, make_paragraph
from pyhrg.gap.diagnose import CampaignDiagnosis
from pyhrg.gap.report.figures.panels import ALL, Panel, compute_panels, draw_panel
from pyhrg.gap.report.figures.views import AXES, VIEWS
from pyhrg.gap.report.held_out import has_closing
from pyhrg.gap.report.places import sum_shares

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
