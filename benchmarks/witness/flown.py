"""R2 of the position error by maps that are estimated from the channels of simulated flights.

Each gyro flies on the FMU at 1 kHz with all noise. The estimate knows the gyro as it was
calibrated, and the distribution of its drift.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from benchmarks.witness.motions import load_ride
from benchmarks.witness.study import (
    ACCELEROMETER,
    MOUNTING,
    Known,
    Score,
    predict_by_changes,
    score,
    tabulate,
)
from ins_eval.mission_model.missions import STILL, plan_mission
from ins_eval.mission_model.position_errors import TriadBlock, compute_position_errors
from ins_eval.mission_model.weights_cache import load_mission_weights
from ins_eval.study.gyros.drawn_triad import DrawnTriad
from ins_eval.study.gyros.drift import Drift, Flight
from ins_eval.study.gyros.witness_prior import make_study_drift
from ins_eval.study.predictors import true_parameters
from ins_eval.study.predictors.prediction_columns import select_time
from ins_eval.study.predictors.unpredictable import compute_unpredictable_covariance
from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.fmu import CONTROL_PERIOD, GyroFmu
from pyhrg.records.columns import COLUMNS
from pyhrg.records.log import Log
from pyhrg.witness.fit import FittedChanges, fit_changes, measure_block_noise
from pyhrg.witness.information import factor_covariance
from pyhrg.witness.prior import Prior
from pyhrg.witness.replay import read_witnesses
from pyhrg.witness.responses import FORCES, Motion

HOURS = 1.0
ROW, FINE = 0.1, 0.01
"""Length of a row of the log, and of the motion, s."""
SEED = 7


@dataclass(frozen=True)
class EstimatedGyro:
    """What a gyro's flight tells. prior: of the drift; changes: (COUNT,) the true ones."""

    fitted: FittedChanges
    prior: Prior
    changes: Array

    @property
    def error(self) -> Array:
        return self.changes - self.fitted.changes


def estimate_gyro(
    fmu: GyroFmu, device: Device, flight: Flight, known: Known, motion: Motion,
    seed: int,
) -> EstimatedGyro:  # fmt: skip
    """fmu: `HRG`; motion: of the flight from power-on, with its self-test."""
    prior = make_study_drift(device, Drift())
    fitted = fit_changes(
        fmu,
        device,
        read_witnesses(record(fmu, flight, motion, seed), device),
        prior,
        known.responses,
        measure_block_noise(fmu, device),
    )
    return EstimatedGyro(fitted, prior, known.changes + prior.mean)


def record(fmu: GyroFmu, flight: Flight, motion: Motion, seed: int) -> Log:
    """The log, in rows of `ROW`, of a motion in rows of `FINE`."""
    parts, steps = round(ROW / FINE), round(FINE / CONTROL_PERIOD)
    case = flight.case_temperature(FINE * np.arange(len(motion.rate)) - STILL)
    moving = {
        name: np.repeat(values, steps).reshape(-1, parts * steps)
        for name, values in (("angularRate", motion.rate), ("caseTemperature", case))
    }
    rotation = motion.virtual_rotation[::parts]
    time = ROW * np.arange(len(rotation))
    with fmu.power_on(flight.device.fmu_parameters(), seed, flight.power_on_angle) as gyro:
        names = [*FORCES, "frequencyOffset"]
        ends, means = gyro.record(
            moving, {"virtualRotation": rotation}, CONTROL_PERIOD, ["patternAngle"], names
        )
    fields = {column.field: np.full(len(time), np.nan) for column in COLUMNS}
    fields |= {
        "time": time + ROW,
        "virtual_rotation": rotation,
        "wave_angle": ends[:, 0],
        "amplitude_force": means[:, 0],
        "quadrature_force": means[:, 1],
        "frequency_offset": means[:, 2],
    }
    return Log(source="flight", interval=ROW, **fields)


def compute_flown_scores(
    fmu: GyroFmu,
    mission: str,
    drawn: list[DrawnTriad],
    triads: TriadBlock,
    known: list[list[Known]],
    test: float,
) -> dict[str, object]:
    """R2 and coverage by the estimates, by those of another triad, and by the true parameters; and
    the rms of the normalised errors of the estimates."""
    ride = load_ride(mission, HOURS, FINE)
    found = [
        [
            estimate_gyro(
                fmu,
                triad.calibrated[axis],
                triad.flights[axis],
                known[r][axis],
                ride.follow(axis, triad.flights[axis].power_on_angle, 0.0, test),
                1000 * SEED + 3 * r + axis,
            )
            for axis in range(3)
        ]
        for r, triad in enumerate(drawn)
    ]
    weights = select_time(load_mission_weights(plan_mission(mission, HOURS)), -1)
    flown = compute_position_errors(triads, weights, 0).radial[:, 0]
    other = compute_unpredictable_covariance(weights, triads.noise, ACCELEROMETER, MOUNTING)

    def stack(read: Callable[[EstimatedGyro], Array]) -> Array:
        return np.array([[read(each) for each in row] for row in found])

    def predict(errors: Array, covariances: Array) -> Score:
        predicted = predict_by_changes(weights, triads, known, errors, covariances, other)
        return score(tabulate(flown, predicted)[:, None])

    true, changes = stack(lambda each: each.changes), stack(lambda each: each.fitted.changes)
    posterior = stack(lambda each: each.fitted.covariance)
    ceiling = true_parameters.predict(weights, triads.in_flight, other)
    return {
        "estimated": predict(true - changes, posterior),
        "another triad's": predict(true - np.roll(changes, 1, axis=0), posterior),
        "no estimate": predict(
            true - stack(lambda each: each.prior.mean), stack(lambda each: each.prior.covariance)
        ),
        "true parameters": score(tabulate(flown, ceiling)[:, None]),
        "NEES over its degrees": float(
            np.mean([_normalize(each) for row in found for each in row])
        ),
        "smallest p": min(each.fitted.p_value for row in found for each in row),
    }


def _normalize(gyro: EstimatedGyro) -> float:
    root = factor_covariance(gyro.fitted.covariance)
    scaled = np.linalg.lstsq(root, gyro.error, rcond=1e-12)[0]
    return float(scaled @ scaled / np.linalg.matrix_rank(root, 1e-12))
