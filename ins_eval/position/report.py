"""The position gap in sentences (the result, the method, what limits it), and as a section of a
diagnosis's page: plots, tables, a document.
"""

import html
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from ins_eval.mission_model.missions import CASE_WARM_UP, WARM_UP
from ins_eval.position.position import MissionGap, MissionGaps
from ins_eval.position.triad_errors import CASE_RISE
from pyhrg.common.pages import svg
from pyhrg.common.units import HOUR
from pyhrg.gap.report.sections import Section

LINEARITY_SHARE = 0.02
"""Difference between the linear model and the co-simulation, as a share of the latter, beyond which
a warning is given. Chosen."""


def write_sentences(gaps: MissionGaps) -> list[str]:
    """The result, how it was computed, and its reservations."""
    return [_state_result(gaps), _state_method(gaps), *_list_reservations(gaps)]


def _state_result(gaps: MissionGaps) -> str:
    end = f"after {gaps.request.hours:g} h (or at the mission's end)"
    if not gaps.diagnosis.is_changed:
        return (
            "The diagnosis changes nothing but noise: without noise, the nominal and the "
            f"identified device are equal, and their positions are 0 m apart {end}, in every "
            "mission."
        )
    distances = ", ".join(
        f"{svg.format_interval(m.at_end.value, m.at_end.low, m.at_end.high)} m in {m.name}"
        for m in gaps.missions
    )
    return (
        "Distance between the positions that the nominal and the identified device predict, "
        f"{end}: {distances}; rms over power-on angles with its 95 % interval."
    )


def _state_method(gaps: MissionGaps) -> str:
    request = gaps.request
    text = (
        "Each triad has three such gyros along forward, right and down. They are not calibrated, "
        f"and each has a power-on angle of its own: {request.triads} triads, seed {request.seed}. "
        f"They are aligned at rest. From power-on the case warms by {CASE_RISE:g} K (time constant "
        f"{CASE_WARM_UP:g} s), and the resonator follows it (time constant {WARM_UP:g} s). Maps "
        "are measured on the FMU; the linear error model gives the position."
    )
    cosimulation = gaps.cosimulation
    if cosimulation is None:
        return text
    return (
        f"{text} As a check, {cosimulation.triads} of the triads are co-simulated with the FMU and "
        f"the nonlinear navigator in {gaps.missions[0].name}: the linear model's distance differs "
        f"by {100 * cosimulation.share:.2g} %."
    )


def _list_reservations(gaps: MissionGaps) -> Iterator[str]:
    diagnosis = gaps.diagnosis
    if gaps.cosimulation is not None and gaps.cosimulation.share > LINEARITY_SHARE:
        yield (
            "Errors this large are no longer linear: the figures are accurate to "
            f"{100 * gaps.cosimulation.share:.2g} %."
        )
    if diagnosis.equivalents:
        names = ", ".join(name.replace("_", " ") for name in diagnosis.equivalents)
        yield (
            f"In the campaign's tests the named causes are confounded with {names}. The figures "
            "hold for the named causes; another effect of the class may give a larger or smaller "
            "distance."
        )
    if diagnosis.verdict == "unexplained":
        yield (
            "Something outside the catalogue takes part. Neither device holds it; the residual of "
            "held-out tests bounds it."
        )
    if diagnosis.nominal.misalignment != diagnosis.identified.misalignment:
        yield (
            "The identified misalignment of the input axis belongs to the test bench, and no "
            "figure here contains it."
        )
    lags = {device.thermal_lag for device in (diagnosis.nominal, diagnosis.identified)}
    for lag in sorted(lags - {WARM_UP}):
        yield f"The gyro's thermal lag is {lag:g} s; the linear model assumes {WARM_UP:g} s."
    yield _state_residual(gaps)


def _state_residual(gaps: MissionGaps) -> str:
    residual = gaps.diagnosis.residual
    if residual is None:
        return "No held-out test says how much position error the unexplained part could cause."
    relation = "exceeds" if residual.rms > residual.floor_high else "does not exceed"
    bounds = [(m.name, m.residual_bound) for m in gaps.missions if m.residual_bound]
    steady = ", ".join(f"{_metres(bound.steady)} in {name}" for name, bound in bounds)
    largest = ", ".join(f"{_metres(bound.any_course)} in {name}" for name, bound in bounds)
    return (
        f"The residual of held-out tests {relation} the noise floor (95 %). Its part above the "
        "floor's lower end, with the same rms in a mission, would cause at most these position "
        f"errors: {steady}, if it is a steady bias of each gyro with the worst signs; {largest}, "
        "whatever its course. Residuals that average out within 100 s are not seen."
    )


def _metres(value: float) -> str:
    return f"{svg.format_number(value)} m"


SCHEMA = "hrg-gap-position/1"
TITLE = "What the gap is worth in metres"


def build_section(gaps: MissionGaps) -> Section:
    """The section `position` of the page, with the content of `position.json`."""
    text = "".join(f"<p>{html.escape(sentence)}</p>" for sentence in write_sentences(gaps))
    panels = ""
    if gaps.diagnosis.is_changed:
        limits = svg.find_decades(np.concatenate([m.distance for m in gaps.missions]))
        drawn = "".join(_draw_panel(m, limits) for m in gaps.missions)
        panels = f'<div class="panels">{drawn}</div>'
    tables = f"{_tabulate_distances(gaps)}{_tabulate_budgets(gaps)}"
    return Section("position", TITLE, f"{text}{panels}{tables}", build_document(gaps))


def _draw_panel(mission: MissionGap, limits: tuple[float, float]) -> str:
    hours = mission.time / HOUR
    x = svg.make_horizontal_scale(0.0, float(hours[-1]), log=False)
    y = svg.make_vertical_scale(*limits)
    name = html.escape(mission.name)
    curve = svg.draw_line(x(hours), y(np.maximum(mission.distance, limits[0])))
    return (
        f'<figure class="c0"><figcaption><b>{name}</b></figcaption>'
        f'<svg viewBox="0 0 {svg.WIDTH} {svg.HEIGHT}" role="img" aria-label="{name}: distance '
        "between the positions of the nominal and the identified device over time; the table below "
        f'has its value at the end">{svg.draw_frame(x, y, "navigation, h", "distance, rms, m")}'
        f'<path fill="none" stroke="currentColor" stroke-width="2.5" d="{curve}"/></svg></figure>'
    )


def _tabulate_distances(gaps: MissionGaps) -> str:
    number = svg.format_number
    rows = []
    for m in gaps.missions:
        end, bound = m.at_end, m.residual_bound
        bounds = (number(bound.steady), number(bound.any_course)) if bound else ("–", "–")
        value, *ends = svg.format_estimate(end.value, end.low, end.high)
        after = number(m.time[-1] / HOUR)
        rows.append((html.escape(m.name), after, value, " to ".join(ends), *bounds))
    head = ("Mission", "after, h", "distance, rms, m", "95 %")
    return _build_table(
        "Distance between the positions of the nominal and the identified device, and bounds for "
        f"the residual; horizontal, {gaps.request.triads} triads, seed {gaps.request.seed}",
        (*head, "residual, if steady, m", "residual, at most, m"),
        rows,
    )


def _tabulate_budgets(gaps: MissionGaps) -> str:
    rows = [
        (
            html.escape(part),
            *(
                svg.format_number(budget[part]) if budget[part] else "0"
                for m in gaps.missions
                for budget in (m.nominal_budget, m.identified_budget)
            ),
        )
        for part in gaps.missions[0].nominal_budget
    ]
    head = ["Part"]
    for m in gaps.missions:
        head += [f"{html.escape(m.name)}, nominal", "identified"]
    return _build_table("Position error budget: rms of each part at the end, m", head, rows)


def _build_table(title: str, head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    heads = "".join(f'<th scope="col">{cell}</th>' for cell in head)
    body = "".join(
        f'<tr><th scope="row">{first}</th>{"".join(f"<td>{cell}</td>" for cell in others)}</tr>'
        for first, *others in rows
    )
    return (
        f'<div class="wide"><table><caption>{html.escape(title)}</caption>'
        f"<thead><tr>{heads}</tr></thead><tbody>{body}</tbody></table></div>"
    )


def build_document(gaps: MissionGaps) -> dict[str, Any]:
    """The content of `position.json`."""
    cosimulation, request = gaps.cosimulation, gaps.request
    return {
        "schema": SCHEMA,
        "device": gaps.diagnosis.device,
        "hours": request.hours,
        "triads": request.triads,
        "seed": request.seed,
        "warming_K": CASE_RISE,
        "missions": [_describe_mission(m) for m in gaps.missions],
        "cosimulated": None
        if cosimulation is None
        else {
            "mission": gaps.missions[0].name,
            "triads": cosimulation.triads,
            "missed_rms_m": cosimulation.flown,
            "linear_less_cosimulated_rms_m": cosimulation.difference,
        },
        "said": write_sentences(gaps),
    }


def _describe_mission(mission: MissionGap) -> dict[str, Any]:
    bound = mission.residual_bound
    return {
        "mission": mission.name,
        "missed_rms_m": mission.at_end.value,
        "missed_interval_95_m": [mission.at_end.low, mission.at_end.high],
        "time_s": mission.time.tolist(),
        "missed_rms_over_time_m": mission.distance.tolist(),
        "budget_before_rms_m": mission.nominal_budget,
        "budget_after_rms_m": mission.identified_budget,
        "leftover_steady_m": None if bound is None else bound.steady,
        "leftover_at_most_m": None if bound is None else bound.any_course,
    }
