"""Distance between the positions of the nominal and of the identified device, in missions."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.missions import StudyMission, plan_mission
from ins_eval.mission_model.weights_cache import load_mission_weights
from ins_eval.position.diagnosis import DiagnosedGyro
from ins_eval.position.triad_errors import (
    Gyro,
    ResidualBound,
    bound_residual_error,
    compute_error_parts,
    compute_noise_rms,
    draw_power_on_angles,
    measure_gyro,
)
from ins_eval.study.cosimulated import Agreement, compare_errors, cosimulate, sample_truth
from ins_eval.study.gyros.drawn_triad import DrawnTriad
from ins_eval.study.scores.resampling import Estimate, bootstrap
from ins_eval.trajectories import catalogue
from ins_eval.trajectories.errors import TrajectoryError
from pyhrg.common.arrays import Array
from pyhrg.fmu import GyroFmu

COSIMULATED_TRIADS = 2
"""Number of triads that are co-simulated, in the first mission. Chosen."""
COSIMULATION_INTERVAL = 0.02
"""Interval of the increments in the co-simulation, s. Chosen."""
MIN_CHECKED_DISTANCE = 1.0
"""Distance below which its linear model is not checked, m, because so short a distance is
immaterial. Chosen."""


@dataclass(frozen=True)
class PositionRequest:
    """What is computed.

    Attributes:
        missions: names of ready missions, or files.
        hours: duration of the navigation.
        triads: number of triads.
        seed: seed of the power-on angles and of the bootstrap intervals.
    """

    missions: Sequence[str | Path]
    hours: float
    triads: int
    seed: int


@dataclass(frozen=True)
class MissionGap:
    """Distance between the positions of the nominal and the identified device in a mission,
    horizontal, m.

    Attributes:
        time: (k,) s since alignment.
        distance: (k,) its rms over triads.
        at_end: that rms at the mission's end, with its interval.
        nominal_budget, identified_budget: rms error of each device at the end, by named part.
        residual_bound: position error that the residual of held-out tests could cause; None without
            such tests.
    """

    name: str
    time: Array
    distance: Array
    at_end: Estimate
    nominal_budget: dict[str, float]
    identified_budget: dict[str, float]
    residual_bound: ResidualBound | None


@dataclass(frozen=True)
class MissionGaps:
    """The distance in every mission that was asked for.

    Attributes:
        cosimulation: the distance by the linear model compared with that by co-simulation, in the
            first mission; None where the distance is shorter than `MIN_CHECKED_DISTANCE`.
    """

    request: PositionRequest
    diagnosis: DiagnosedGyro
    missions: tuple[MissionGap, ...]
    cosimulation: Agreement | None


def compute_mission_gaps(
    fmu: GyroFmu,
    diagnosis: DiagnosedGyro,
    request: PositionRequest,
    report: Callable[[str], None] = lambda text: None,
) -> MissionGaps:
    """Position errors of the nominal and the identified device by the FMU `HRGSlow`, compared in
    each mission."""
    missions = [_plan_mission(source, request.hours) for source in request.missions]
    gyros = measure_gyro(fmu, diagnosis.nominal), measure_gyro(fmu, diagnosis.identified)
    angles = draw_power_on_angles(request.triads, request.seed)
    in_flight = [gyro.compute_flight_coefficients(angles) for gyro in gyros]
    gaps = []
    for mission in missions:
        report(f"position: {mission.name}")
        weights = load_mission_weights(mission)
        parts = [compute_error_parts(weights, coefficients) for coefficients in in_flight]
        gaps.append(_compare_devices(weights, gyros, parts, request.seed, diagnosis))
    cosimulation = None
    if gaps[0].at_end.value >= MIN_CHECKED_DISTANCE:
        report(f"position: {missions[0].name}, co-simulated")
        cosimulation = _check_linearity(fmu, missions[0], gyros, angles[:COSIMULATED_TRIADS])
    return MissionGaps(request, diagnosis, tuple(gaps), cosimulation)


def _plan_mission(source: str | Path, hours: float) -> StudyMission:
    if not catalogue.find_mission_file(source).is_file():
        names = ", ".join(catalogue.list_trajectories())
        raise TrajectoryError(f"{source}: found no such mission, expected {names}, or a file")
    return plan_mission(source, hours)


def _compare_devices(
    weights: MissionWeights,
    gyros: tuple[Gyro, Gyro],
    parts: Sequence[dict[str, Array]],
    seed: int,
    diagnosis: DiagnosedGyro,
) -> MissionGap:
    difference = _sum_parts(parts[1]) - _sum_parts(parts[0])
    residual = diagnosis.residual
    return MissionGap(
        name=weights.name,
        time=weights.time,
        distance=np.array([_compute_rms(difference[:, k]) for k in range(difference.shape[1])]),
        at_end=bootstrap(_compute_rms, [difference[:, -1]], seed),
        nominal_budget=_compute_budget(parts[0], compute_noise_rms(weights, gyros[0])),
        identified_budget=_compute_budget(parts[1], compute_noise_rms(weights, gyros[1])),
        residual_bound=None if residual is None else bound_residual_error(weights, residual.excess),
    )


def _compute_budget(parts: dict[str, Array], noise: dict[str, Array]) -> dict[str, float]:
    """Rms of each part at the mission's end, m."""
    return {
        **{name: float(_compute_rms(part[:, -1])) for name, part in parts.items()},
        **{name: float(rms[-1]) for name, rms in noise.items()},
    }


def _check_linearity(
    fmu: GyroFmu, mission: StudyMission, gyros: tuple[Gyro, Gyro], angles: Array
) -> Agreement:
    """The linear model's difference between the devices, compared with the co-simulated one."""
    truth, weights = sample_truth(mission, COSIMULATION_INTERVAL), load_mission_weights(mission)

    def fly(gyro: Gyro, start: Array) -> Array:
        flights, seeds = gyro.make_flights(start), np.zeros(2, dtype=np.uint64)
        triad = DrawnTriad((), flights, np.zeros(3), np.zeros((2, 3)), seeds)
        return cosimulate(fmu, truth, triad)

    nominal, identified = (np.stack([fly(gyro, start) for start in angles]) for gyro in gyros)
    linear = [
        _sum_parts(compute_error_parts(weights, gyro.compute_flight_coefficients(angles)))
        for gyro in gyros
    ]
    return compare_errors(linear[1] - linear[0], identified - nominal)


def _sum_parts(parts: dict[str, Array]) -> Array:
    return np.asarray(sum(parts.values()))


def _compute_rms(error: Array) -> Array:
    """Horizontal rms over triads of errors (..., r, 2)."""
    return np.asarray(np.sqrt(np.sum(error**2, axis=-1).mean(axis=-1)))
