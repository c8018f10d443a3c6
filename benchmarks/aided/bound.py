"""What a filter with fixes can leave of a following free hour, by its covariance alone."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

import numpy as np

from benchmarks.aided.flown import (
    AIDED_HOURS,
    FIRST_JUDGED,
    FIX_SIGMA,
    FIX_SPACING,
    FREE_HOURS,
    MISSIONS,
    NO_ARM,
    STUDY_SEED,
    propagate,
)
from benchmarks.aided.known import KNOWN, learn_deviations, list_states
from benchmarks.witness.motions import load_ride
from ins_eval.aided.fixes import make_position_fixes
from ins_eval.aided.kalman.drive import measure_turn, sample_drive
from ins_eval.aided.kalman.forward import Start, run_filter
from ins_eval.aided.kalman.sensors import SensorStates
from ins_eval.error_model.dynamics import COUNT
from ins_eval.error_model.effects import ANGULAR_GAIN
from ins_eval.mission_model.missions import SETTLING, STILL, plan_mission
from ins_eval.study.cosimulated import AXES, sample_truth
from ins_eval.study.gyros.drawn_triad import (
    DrawnTriad,
    TriadDistribution,
    draw_triad,
    make_triad_seed,
)
from ins_eval.study.gyros.true_maps import read_flight_coefficients
from ins_eval.study.gyros.witness_prior import forget_unmeasured, make_study_prior
from ins_eval.study.witness.estimated_map import respond
from ins_eval.study.witness.self_test import SELF_TEST
from pyhrg.common.arrays import Array
from pyhrg.common.units import HOUR
from pyhrg.fmu import GyroFmu
from pyhrg.witness.information import accumulate_information, compute_posterior
from pyhrg.witness.responses import measure_responses

START = np.repeat([4.0, 1.0, 1e-5, 0.0], [3, 3, 3, 1])
"""Variances of the errors of an aligned start, SI. Chosen: wider than the filter finds it."""
DRAWS = 4000


@dataclass(frozen=True)
class Bound:
    """Medians of the horizontal error after the free hour, m, of one triad.

    prior: what is known of the maps before the drive; free: with the errors found; uncorrected:
    without; noise: by the sensors' noise after the last fix alone.
    """

    mission: str
    prior: str
    free: float
    uncorrected: float
    noise: float


def bound_triads(slow: GyroFmu, distribution: TriadDistribution, count: int) -> Iterator[Bound]:
    """Triads in turn on `MISSIONS`, each with all priors; slow: `HRGSlow`."""
    deviations = learn_deviations(slow, distribution, 12)
    for number in range(count):
        seed = make_triad_seed(STUDY_SEED, FIRST_JUDGED + number)
        triad = draw_triad(slow, distribution, seed)
        mission = MISSIONS[number % len(MISSIONS)]
        yield from _bound(slow, distribution, triad, mission, deviations)


def _bound(
    slow: GyroFmu,
    distribution: TriadDistribution,
    triad: DrawnTriad,
    mission: str,
    deviations: Array,
) -> Iterator[Bound]:
    planned = plan_mission(mission, AIDED_HOURS + FREE_HOURS)
    true, trajectory = sample_truth(planned).increments, planned.trajectory()
    used = true.between(round(SETTLING / true.interval), len(true))
    angle = np.array([each.power_on_angle for each in triad.flights])
    turned = np.cumsum(true.rotation, axis=0)[round(SETTLING / true.interval) - 1]
    drive = sample_drive(used, measure_turn(used, None) + turned - angle / ANGULAR_GAIN)
    last = int((AIDED_HOURS * HOUR - used.start) / drive.step)
    time = np.arange(used.start, AIDED_HOURS * HOUR, FIX_SPACING)
    fixes = make_position_fixes(time, trajectory.position(time), FIX_SIGMA)
    start = Start(trajectory.state(used.start), np.diag(START))
    states = list_states(distribution, triad, deviations)
    generator = np.random.default_rng(STUDY_SEED)
    maps = np.stack(
        [read_flight_coefficients(slow, f.device, f.rise)[KNOWN] for f in triad.flights], axis=1
    )
    unknown = np.diag(states.covariance).copy()
    unknown[: maps.size] = 0.0
    _, noise = propagate(drive, last, states, trajectory)
    for name, prior in _list_priors(slow, distribution, triad, mission).items():
        known = states if prior is None else replace(states, joint=_join(states, prior))
        found = run_filter(drive, fixes, known, start, NO_ARM, last).covariance
        without = np.zeros_like(found)
        without[:COUNT, :COUNT], without[COUNT:, COUNT:] = found[:COUNT, :COUNT], np.diag(unknown)
        errors = np.zeros(len(found))
        errors[COUNT : COUNT + maps.size] = maps.ravel()
        left = [
            propagate(drive, last, states, trajectory, *case)
            for case in ((0.0, found), (errors, without))
        ]
        left.append((np.zeros(2), noise))
        yield Bound(mission, name, *(_find_median(*each, generator) for each in left))


def _find_median(mean: Array, covariance: Array, generator: np.random.Generator) -> float:
    drawn = generator.multivariate_normal(mean, covariance, DRAWS)
    return float(np.median(np.linalg.norm(drawn, axis=1)))


def _join(states: SensorStates, maps: Array) -> Array:
    """(c, c) covariance of the coefficients whose maps have one of (3, k, k)."""
    joint = states.covariance.copy()
    for axis in range(AXES):
        own = np.arange(axis, AXES * maps.shape[1], AXES)
        joint[np.ix_(own, own)] = maps[axis]
    return joint


def _list_priors(
    slow: GyroFmu, distribution: TriadDistribution, triad: DrawnTriad, mission: str
) -> Mapping[str, Array | None]:
    """(3, k, k) covariances of the maps by what is known before the drive: the population, the
    study's bench, and the bench with the gyros' own channels until the last fix."""
    population, plan, drift = distribution.population, distribution.bench, distribution.drift
    ride = load_ride(mission, AIDED_HOURS)
    rows = round((STILL + AIDED_HOURS * HOUR) / ride.row)
    benched, witnessed = [], []
    for axis, flight in enumerate(triad.flights):
        device = forget_unmeasured(triad.calibrated[axis])
        responses = measure_responses(slow, device)
        prior = make_study_prior(responses, device, population, plan, drift).covariance
        motion = ride.follow(axis, flight.power_on_angle, flight.rise, SELF_TEST)
        information = accumulate_information(responses, motion.take(slice(0, rows)))
        response = respond(responses, flight.rise)[KNOWN]
        told = compute_posterior(prior, information)
        benched.append(response @ prior @ response.T)
        witnessed.append(response @ told @ response.T)
    return {"population": None, "bench": np.array(benched), "own channels": np.array(witnessed)}
