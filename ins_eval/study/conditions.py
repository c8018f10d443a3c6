"""Where the thesis is not expected to hold: conditions flown and judged apart from the classes.

The gyros are the study's own, calibrated at the mean. Predictors are those of the study, made on
its training half; they know nothing of the condition.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np

from ins_eval.mission_model.gyro_map import TERMS, terms
from ins_eval.mission_model.missions import StudyMission, study_mission
from ins_eval.mission_model.triads import Triads
from ins_eval.study.block import Kind, Triad, gathered, triad, triad_seed
from ins_eval.study.gyros.drift import Flight
from ins_eval.study.gyros.maker import calibrated_gyro
from ins_eval.study.gyros.population import Population
from ins_eval.study.specification import Study
from pyhrg.common.units import DEG_PER_H, DEG_PER_SQRT_H
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu

Generator = np.random.Generator

CONSTANT = 0
"""Place of a constant bias among the coefficients in flight."""
HOUR_OF_FLIGHT = 1.0
"""Straight and level, h."""


@dataclass(frozen=True)
class DriveNoise(Population):
    """Well-trimmed gyros with noisy drives: least, most: angle random walk, rad/sqrt(s)."""

    least: float
    most: float

    def draw(self, generator: Generator) -> Device:
        """A gyro as it is built."""
        device = super().draw(generator)
        low, high = np.log([self.least, self.most])
        return replace(device, angle_random_walk=float(np.exp(generator.uniform(low, high))))


NOISY = DriveNoise(
    1e-3 * DEG_PER_H, 1e-2 * DEG_PER_H, least=3e-3 * DEG_PER_SQRT_H, most=3e-2 * DEG_PER_SQRT_H
)


@dataclass(frozen=True)
class Sample:
    """What conditions are made of: triads of the study by number, the same as arrays, their kind,
    and the FMU."""

    study: Study
    kind: Kind
    fmu: GyroFmu
    drawn: Mapping[int, Triad]
    triads: Triads


@dataclass(frozen=True)
class Condition:
    """title: its class in results; what: differs, a sentence; mission: a ready one; hours: of it,
    None as long as the study's; triads: that fly, from the study's."""

    title: str
    what: str
    mission: str
    hours: float | None
    triads: Callable[[Sample], Triads]

    def flying(self, study: Study) -> StudyMission:
        """Its mission."""
        hours = study.hours if self.hours is None else min(self.hours, study.hours)
        return study_mission(self.mission, hours)


def _as_they_are(sample: Sample) -> Triads:
    return sample.triads


def _less_bias_at_start(sample: Sample) -> Triads:
    """A constant is taken out: the bias that the bench's map has where each pattern starts."""
    triads = sample.triads
    waves = terms(triads.start_angle)
    known = np.einsum("rat,rta->ra", waves, triads.known[:, :TERMS])
    less = triads.in_flight.copy()
    less[:, CONSTANT] -= known
    return replace(triads, in_flight=less)


def _self_calibrated(sample: Sample) -> Triads:
    """Each gyro maps itself in the power-on in which it flies; the bench saw it before."""

    def mapped(number: int, axis: int, flight: Flight) -> Flight:
        seed = _seed(sample.study, number, axis)
        own = calibrated_gyro(sample.fmu, flight.device, "map", seed, sample.kind.calibration)
        return replace(flight, device=own)

    def triad_of(number: int, drawn: Triad) -> Triad:
        flights = (mapped(number, axis, flight) for axis, flight in enumerate(drawn.flights))
        return replace(drawn, flights=tuple(flights))

    return gathered(sample.fmu, [triad_of(*each) for each in sample.drawn.items()])


def _noisy(sample: Sample) -> Triads:
    """The same seeds, gyros whose drive noise dominates."""
    kind = replace(sample.kind, population=NOISY)
    seeds = [triad_seed(sample.study.seed, number) for number in sample.drawn]
    return gathered(sample.fmu, [triad(sample.fmu, kind, seed) for seed in seeds])


def _seed(study: Study, number: int, axis: int) -> int:
    """Of a gyro's tests on itself."""
    sequence = np.random.SeedSequence(study.seed, spawn_key=(number, axis))
    return int(sequence.generate_state(1, np.uint64)[0] >> 1)


CONDITIONS = (
    Condition(
        "straight and level for an hour",
        "the pattern stays near its power-on angle; what flies is the map's value there",
        "straight-and-level",
        HOUR_OF_FLIGHT,
        _as_they_are,
    ),
    Condition(
        "straight and level for an hour, bias at power-on taken out",
        "as before, by a user who takes out the bias that the bench's map has where it starts",
        "straight-and-level",
        HOUR_OF_FLIGHT,
        _less_bias_at_start,
    ),
    Condition(
        "self-calibrated",
        "gyros map themselves in the power-on in which they fly; the bench saw them before",
        "aircraft",
        None,
        _self_calibrated,
    ),
    Condition(
        "drive noise dominating",
        "maps of 0.001 to 0.01 deg/h under an angle random walk of 0.003 to 0.03 deg/sqrt(h)",
        "aircraft",
        None,
        _noisy,
    ),
)
