"""The position gap in sentences: the result, the method, and what limits it."""

from collections.abc import Iterator

from ins_eval.mission_model.missions import CASE_WARM_UP, WARM_UP
from ins_eval.position.gyro import CASE_RISE
from ins_eval.position.position import MissionGaps
from pyhrg.common.pages import svg

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
