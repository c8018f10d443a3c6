"""The gap in metres as a section of a diagnosis: words, a drawing, tables, and a document."""

import html
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from ins_eval.mission_model.missions import CASE_WARM_UP, WARM_UP
from ins_eval.position.gyro import RISE
from ins_eval.position.position import InMission, Position
from pyhrg.common.pages import svg
from pyhrg.common.units import HOUR
from pyhrg.gap.report.sections import Section

SCHEMA = "hrg-gap-position/1"
TITLE = "What the gap is worth in metres"
LINEAR = 0.02
"""Share by which the linear model may miss before the section warns of it."""


def section(found: Position) -> Section:
    """All of it."""
    said = "".join(f"<p>{html.escape(text)}</p>" for text in sentences(found))
    drawn = _panels(found) if found.diagnosis.moved else ""
    return Section(TITLE, f"{said}{drawn}{_missed(found)}{_budgets(found)}", document(found))


def sentences(found: Position) -> list[str]:
    """What was found, how, and with which reservations."""
    return [_headline(found), _method(found), *_reservations(found)]


def _headline(found: Position) -> str:
    after = f"after {found.asked.hours:g} h (or at the mission's end)"
    if not found.diagnosis.moved:
        return (
            "Nothing was found that moves the gyro without noise: before and after are the same "
            f"gyro, and the belief misses 0 m {after}, in every mission."
        )
    told = ", ".join(
        f"{_metres(m.at_end.value)} in {m.name} "
        f"({svg.number(m.at_end.low)} to {svg.number(m.at_end.high)})"
        for m in found.missions
    )
    return (
        "The position that the believed simulation predicts is from what the closed one predicts, "
        f"{after}: {told}; rms over power-on angles with its 95 % interval."
    )


def _method(found: Position) -> str:
    asked = found.asked
    text = (
        "Three such gyros along forward, right and down, none of them calibrated, each with a "
        f"power-on angle of its own: {asked.triads} triads, seed {asked.seed}. They are aligned at "
        f"rest; from power-on the case warms by {RISE:g} K (time constant {CASE_WARM_UP:g} s), the "
        f"resonator behind it ({WARM_UP:g} s). Maps are read off the FMU, the position is the "
        "linear error model's"
    )
    if found.sample is None:
        return f"{text}."
    sample = found.sample
    return (
        f"{text}. Flown for real, FMU and navigator, {sample.triads} of them in "
        f"{found.missions[0].name}: the linear model misses {100 * sample.share:.2g} % of what "
        "they are apart by."
    )


def _reservations(found: Position) -> Iterator[str]:
    diagnosis = found.diagnosis
    if found.sample is not None and found.sample.share > LINEAR:
        yield (
            f"Errors this large are no longer linear: figures are good to "
            f"{100 * found.sample.share:.2g} %."
        )
    if diagnosis.equivalents:
        yield (
            "The campaign could not tell what was found from "
            f"{', '.join(name.replace('_', ' ') for name in diagnosis.equivalents)}; figures are "
            "those of what was named, and another of the class may carry further or less far."
        )
    if diagnosis.verdict == "unexplained":
        yield (
            "Something outside the catalogue takes part. It is in neither gyro; what is left on "
            "held-out tests bounds it."
        )
    if diagnosis.before.misalignment != diagnosis.after.misalignment:
        yield "The tilt of the input axis that was found is the bench's, and in no figure here."
    lags = {device.thermal_lag for device in (diagnosis.before, diagnosis.after)} - {WARM_UP}
    for lag in sorted(lags):
        yield f"The gyro's thermal lag is {lag:g} s; the linear figures are for {WARM_UP:g} s."
    yield _rest(found)


def _rest(found: Position) -> str:
    rest = found.diagnosis.rest
    if rest is None:
        return "No held-out test says what the rest of the gap is worth."
    seen = "More than noise" if rest.rms > rest.most else "No more than noise may leave"
    pairs = [(m.name, m.leftover) for m in found.missions if m.leftover]
    steady = ", ".join(f"{_metres(left.steady)} in {name}" for name, left in pairs)
    most = ", ".join(f"{_metres(left.most)} in {name}" for name, left in pairs)
    return (
        f"{seen} is left on held-out tests. What it may hold beyond the least that noise leaves "
        "(95 %), had it the same rms in a mission, would be worth, as a steady bias of each gyro, "
        f"signs as bad as may be, {steady}; whatever its course, at most {most}. What passes "
        "within 100 s is not seen."
    )


def _panels(found: Position) -> str:
    limits = svg.decades(np.concatenate([m.missed for m in found.missions]))
    drawn = "".join(_panel(m, limits) for m in found.missions)
    return f'<div class="panels">{drawn}</div>'


def _panel(mission: InMission, limits: tuple[float, float]) -> str:
    hours = mission.time / HOUR
    x, y = svg.across(0.0, float(hours[-1]), log=False), svg.up(*limits)
    name = html.escape(mission.name)
    curve = svg.line(x(hours), y(np.maximum(mission.missed, limits[0])))
    return (
        f'<figure class="c0"><figcaption><b>{name}</b></figcaption>'
        f'<svg viewBox="0 0 {svg.WIDTH} {svg.HEIGHT}" role="img" aria-label="{name}: how far the '
        f'belief misses over time; the table below has the end">'
        f"{svg.frame(x, y, 'navigating, h', 'missed by the belief, rms, m')}"
        f'<path fill="none" stroke="currentColor" stroke-width="2.5" d="{curve}"/></svg></figure>'
    )


def _missed(found: Position) -> str:
    rows = [
        (
            html.escape(m.name),
            svg.number(m.time[-1] / HOUR),
            svg.number(m.at_end.value),
            f"{svg.number(m.at_end.low)} to {svg.number(m.at_end.high)}",
            *(
                ("–", "–")
                if m.leftover is None
                else (svg.number(m.leftover.steady), svg.number(m.leftover.most))
            ),
        )
        for m in found.missions
    ]
    head = ("Mission", "after, h", "missed, rms, m", "95 %", "left if steady, m", "left at most, m")
    return _table(
        f"How far the belief misses, and what is left; horizontal, {found.asked.triads} triads, "
        f"seed {found.asked.seed}",
        head,
        rows,
    )


def _budgets(found: Position) -> str:
    names = list(found.missions[0].before)
    rows = [
        (
            html.escape(name),
            *(
                svg.number(gyros[name]) if gyros[name] else "0"
                for m in found.missions
                for gyros in (m.before, m.after)
            ),
        )
        for name in names
    ]
    head = ["Part"]
    for m in found.missions:
        head += [f"{html.escape(m.name)}, before", "after"]
    return _table("Position error budget: rms of each part at the end, m", head, rows)


def _table(title: str, head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    heads = "".join(f'<th scope="col">{cell}</th>' for cell in head)
    body = "".join(
        f'<tr><th scope="row">{first}</th>{"".join(f"<td>{cell}</td>" for cell in rest)}</tr>'
        for first, *rest in rows
    )
    return (
        f'<div class="wide"><table><caption>{html.escape(title)}</caption>'
        f"<thead><tr>{heads}</tr></thead><tbody>{body}</tbody></table></div>"
    )


def _metres(value: float) -> str:
    return f"{svg.number(value)} m"


def document(found: Position) -> dict[str, Any]:
    """Content of `position.json`."""
    sample = found.sample
    return {
        "schema": SCHEMA,
        "device": found.diagnosis.device,
        "hours": found.asked.hours,
        "triads": found.asked.triads,
        "seed": found.asked.seed,
        "warming_K": RISE,
        "missions": [_mission(m) for m in found.missions],
        "cosimulated": None
        if sample is None
        else {
            "mission": found.missions[0].name,
            "triads": sample.triads,
            "missed_rms_m": sample.flown,
            "linear_less_cosimulated_rms_m": sample.apart,
        },
        "said": sentences(found),
    }


def _mission(mission: InMission) -> dict[str, Any]:
    left = mission.leftover
    return {
        "mission": mission.name,
        "missed_rms_m": mission.at_end.value,
        "missed_interval_95_m": [mission.at_end.low, mission.at_end.high],
        "time_s": mission.time.tolist(),
        "missed_rms_over_time_m": mission.missed.tolist(),
        "budget_before_rms_m": mission.before,
        "budget_after_rms_m": mission.after,
        "leftover_steady_m": None if left is None else left.steady,
        "leftover_at_most_m": None if left is None else left.most,
    }
