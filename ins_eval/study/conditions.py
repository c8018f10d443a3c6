"""Conditions in which the claims are not expected to hold; they are scored apart from the classes.

The gyros are the study's own, calibrated at the mean. The predictors are those of the study, made
on its training triads; they do not know the condition.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from ins_eval.mission_model.gyro_map import TERMS, evaluate_terms
from ins_eval.mission_model.missions import StudyMission, plan_mission
from ins_eval.mission_model.position_errors import TriadBlock
from ins_eval.study.gyros.drawn_triad import (
    AXES,
    DrawnTriad,
    TriadDistribution,
    draw_triad,
    make_triad_seed,
    tabulate_triads,
)
from ins_eval.study.gyros.drift import Flight, draw_flight
from ins_eval.study.gyros.makers_calibration import calibrate_gyro
from ins_eval.study.gyros.population import Population
from ins_eval.study.predictors.fixed_mean import CONSTANT_BIAS
from ins_eval.study.specification import Study
from pyhrg.common.units import DEG_PER_H, DEG_PER_SQRT_H, YEAR
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu

Generator = np.random.Generator

STALE_AGE = 5 * YEAR
"""Time from calibration to flight of a stale calibration, s. Chosen."""
LEVEL_FLIGHT_HOURS = 1.0
"""Duration of the straight and level flight, h. Chosen."""


@dataclass(frozen=True)
class DriveNoise(Population):
    """Well-trimmed gyros with noisy drives.

    Attributes:
        smallest_walk, largest_walk: bounds of the angle random walk, log-uniform, rad/sqrt(s).
    """

    smallest_walk: float
    largest_walk: float

    def draw(self, generator: Generator) -> Device:
        """A gyro as it is built, before the maker's calibration."""
        device = super().draw(generator)
        low, high = np.log([self.smallest_walk, self.largest_walk])
        return replace(device, angle_random_walk=float(np.exp(generator.uniform(low, high))))


NOISY_DRIVES = DriveNoise(
    1e-3 * DEG_PER_H,
    1e-2 * DEG_PER_H,
    smallest_walk=3e-3 * DEG_PER_SQRT_H,
    largest_walk=3e-2 * DEG_PER_SQRT_H,
)
"""Gyros whose noise hides their maps. Chosen."""


@dataclass(frozen=True)
class ConditionSample:
    """Triads of the study that fly in the conditions.

    Attributes:
        drawn: the triads by number.
        triads: the drawn triads as arrays.
        distribution: what they are drawn from.
        fmu: `HRGSlow`.
    """

    study: Study
    distribution: TriadDistribution
    fmu: GyroFmu
    drawn: Mapping[int, DrawnTriad]
    triads: TriadBlock


@dataclass(frozen=True)
class Condition:
    """A condition.

    Attributes:
        title: mission class of the condition in the results.
        what: sentence that says what differs.
        mission: name of a ready mission.
        hours: duration of the mission, h; None for the study's.
        triads: function that makes the condition's triads from those of the study.
    """

    title: str
    what: str
    mission: str
    hours: float | None
    triads: Callable[[ConditionSample], TriadBlock]

    def plan(self, study: Study) -> StudyMission:
        hours = study.hours if self.hours is None else min(self.hours, study.hours)
        return plan_mission(self.mission, hours)


def _remove_power_on_bias(sample: ConditionSample) -> TriadBlock:
    """A constant is subtracted: the bench's bias map at the angle where each pattern starts."""
    triads = sample.triads
    terms = evaluate_terms(triads.start_angle)
    bias = np.einsum("rat,rta->ra", terms, triads.fitted_map[:, :TERMS])
    in_flight = triads.in_flight.copy()
    in_flight[:, CONSTANT_BIAS] -= bias
    return replace(triads, in_flight=in_flight)


def _calibrate_at_fixed_position(sample: ConditionSample) -> TriadBlock:
    """The maker takes out the mean bias of the fixed-position test in place of that over the
    circumference; the bench's figures are those of the gyros that he hands over."""
    triads = sample.triads
    in_flight, fitted = triads.in_flight.copy(), triads.fitted_map.copy()
    for coefficients in (in_flight, fitted):
        coefficients[:, CONSTANT_BIAS] -= triads.fixed_bias
    unbiased = np.zeros_like(triads.fixed_bias)
    return replace(triads, in_flight=in_flight, fitted_map=fitted, fixed_bias=unbiased)


def _self_calibrate(sample: ConditionSample) -> TriadBlock:
    """Each gyro calibrates its map in the power-on in which it flies; the bench measured it
    before."""
    plan = sample.distribution.calibration

    def fly(drawn: DrawnTriad, axis: int, seed: int) -> Flight:
        flight = drawn.flights[axis]
        return replace(flight, device=calibrate_gyro(sample.fmu, flight.device, "map", seed, plan))

    return _fly_again(sample, fly)


def _fly_years_later(sample: ConditionSample) -> TriadBlock:
    """Triads of the same gyros that fly `STALE_AGE` after their calibration and their bench."""
    drift = replace(sample.distribution.drift, age=STALE_AGE)

    def fly(drawn: DrawnTriad, axis: int, seed: int) -> Flight:
        return draw_flight(drawn.calibrated[axis], drift, np.random.default_rng(seed))

    return _fly_again(sample, fly)


def _draw_noisy_triads(sample: ConditionSample) -> TriadBlock:
    """Gyros with dominant drive noise, from the same seeds."""
    noisy = replace(sample.distribution, population=NOISY_DRIVES)
    seeds = [make_triad_seed(sample.study.seed, number) for number in sample.drawn]
    return tabulate_triads(sample.fmu, [draw_triad(sample.fmu, noisy, seed) for seed in seeds])


def _fly_again(
    sample: ConditionSample, fly: Callable[[DrawnTriad, int, int], Flight]
) -> TriadBlock:
    """The triads in other flights, each from its triad, the axis of the gyro, and a seed."""

    def make_seed(number: int, axis: int) -> int:
        sequence = np.random.SeedSequence(sample.study.seed, spawn_key=(number, axis))
        return int(sequence.generate_state(1, np.uint64)[0] >> 1)

    triads = [
        replace(each, flights=tuple(fly(each, a, make_seed(number, a)) for a in range(AXES)))
        for number, each in sample.drawn.items()
    ]
    return tabulate_triads(sample.fmu, triads)


CONDITIONS = (
    Condition(
        "straight and level for an hour",
        "the pattern stays near its power-on angle, so that only the map's value there matters",
        "straight-and-level",
        LEVEL_FLIGHT_HOURS,
        lambda sample: sample.triads,
    ),
    Condition(
        "straight and level for an hour, bias at power-on taken out",
        "as before; the user subtracts the bias of the bench's map at the power-on angle",
        "straight-and-level",
        LEVEL_FLIGHT_HOURS,
        _remove_power_on_bias,
    ),
    Condition(
        "self-calibrated",
        "gyros calibrate their maps in the power-on in which they fly; the bench measured them "
        "before",
        "aircraft",
        None,
        _self_calibrate,
    ),
    Condition(
        "calibration five years old",
        "five years between bench and flight; the predictors expect the drift of the study",
        "aircraft",
        None,
        _fly_years_later,
    ),
    Condition(
        "drive noise dominating",
        "maps of 0.001 to 0.01 deg/h under an angle random walk of 0.003 to 0.03 deg/sqrt(h)",
        "aircraft",
        None,
        _draw_noisy_triads,
    ),
    *(
        Condition(
            f"calibrated at the fixed position, {mission}",
            "the maker takes out the mean bias at the start angle, by the fixed-position test, in "
            "place of the mean over the circumference",
            mission,
            None,
            _calibrate_at_fixed_position,
        )
        for mission in ("car", "aircraft")
    ),
)
