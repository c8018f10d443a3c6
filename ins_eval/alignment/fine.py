"""Fine alignment: a Kalman filter on the displacement of a navigator whose vehicle stands.

The measurement is that the computed displacement stays where it is, up to the vehicle's sway. A
standing vehicle's displacement is bounded and returns, so its samples are near white; its velocity
is the derivative of that and would be coloured noise: taken as white it would weigh too little.
"""

from dataclasses import dataclass

import numpy as np
from filterpy.kalman import KalmanFilter
from numpy.typing import NDArray
from scipy.optimize import minimize_scalar

from ins_eval.alignment import standing
from ins_eval.alignment.dead_reckoning import (
    FEWEST_STEPS,
    Reckoning,
    corrected,
    in_whole_steps,
    reckoned,
)
from ins_eval.alignment.result import Alignment, AlignmentError, Biases, History
from ins_eval.increments import Increments
from ins_eval.sensor_errors import SensorErrors

Array = NDArray[np.float64]

SETTLED = 1e-4
"""Correction of the start attitude below which the linear model holds, rad."""
MOST_PASSES = 6
SWAY_BOUNDS = (1e-6, 100.0)
"""Between which the vehicle's displacement is looked for, m."""
TOLERANCE = 0.05
"""Of its logarithm."""


@dataclass(frozen=True)
class Filtered:
    """state: (m, 13); covariance: (m, 13, 13); innovation: (m, 2), whitened;
    log_likelihood: of the innovations once the filter has settled."""

    state: Array
    covariance: Array
    innovation: Array
    log_likelihood: float


def fine_alignment(
    record: Increments,
    position: Array,
    errors: SensorErrors,
    coarse: Array,
    sway: float | None = None,
) -> Alignment:
    """Attitude at the end of a record of a vehicle that stands or sways.

    The filter starts from next to no knowledge of the attitude, so nothing is counted twice.

    Args:
        record: a few intervals at its beginning are left out if the steps want it.
        position: (3,) latitude, longitude (rad), height (m).
        errors: of the sensors.
        coarse: `mat_nb` (3, 3) at the record's start, within some degrees.
        sway: standard deviation of the vehicle's level displacement on each axis, m; None finds
            the likeliest.

    Raises:
        AlignmentError: too short a record, or one whose attitude does not settle.
    """
    run, result, sway = settled(record, position, errors, coarse, sway)
    attitude, both = standing.ATTITUDE, slice(standing.GYRO.start, standing.ACCELEROMETER.stop)
    mat_nb = corrected(run.track.mat_nb, result.state[:, attitude])
    covariance = result.covariance[:, attitude, attitude]
    last = result.state[-1]
    return Alignment(
        method="fine",
        time=float(run.track.time[-1]),
        mat_nb=mat_nb[-1],
        covariance=covariance[-1],
        biases=Biases(
            last[standing.GYRO], last[standing.ACCELEROMETER], result.covariance[-1, both, both]
        ),
        history=History(run.track.time, mat_nb, covariance, result.innovation),
        sway=sway,
    )


def settled(
    record: Increments, position: Array, errors: SensorErrors, coarse: Array, sway: float | None
) -> tuple[Reckoning, Filtered, float]:
    """Dead reckoning whose errors are small enough for the linear model; the sway, m.

    Raises:
        AlignmentError: too short a record, or one whose attitude does not settle.
    """
    record, each = in_whole_steps(record)
    mat_nb = coarse
    for _ in range(MOST_PASSES):
        run = reckoned(record, position, mat_nb, each)
        if sway is None:
            sway = likeliest_sway(run, errors)
        result = filtered(run, errors, sway)
        first = run.first_error(result.state[-1])[standing.ATTITUDE]
        if np.linalg.norm(first) < SETTLED:
            return run, result, sway
        mat_nb = corrected(mat_nb, first)
    raise AlignmentError(
        f"attitude still off by {np.rad2deg(np.linalg.norm(first)):.2g} deg "
        f"after {MOST_PASSES} passes: the vehicle moved, or the coarse attitude is far off"
    )


def filtered(run: Reckoning, errors: SensorErrors, sway: float) -> Filtered:
    """The Kalman filter over a run."""
    kalman = KalmanFilter(dim_x=standing.STATES, dim_z=2)
    kalman.P = standing.prior(errors)
    kalman.Q = run.noise(errors)
    kalman.H = np.eye(standing.STATES)[standing.DISPLACEMENT]
    kalman.R = sway**2 * np.eye(2)
    state, covariance, innovation, spread = [], [], [], []
    for z, transition in zip(run.displacement, run.transition, strict=True):
        kalman.predict(F=transition)
        kalman.update(z[:, None])
        state.append(kalman.x[:, 0])
        covariance.append(kalman.P)
        innovation.append(kalman.y[:, 0])
        spread.append(kalman.S)
    root = np.linalg.cholesky(np.array(spread))
    white = np.linalg.solve(root, np.array(innovation)[..., None])[..., 0]
    each = -0.5 * np.sum(white**2, axis=1) - np.log(root[:, 0, 0] * root[:, 1, 1])
    likelihood = float(each[FEWEST_STEPS // 2 :].sum())
    return Filtered(np.array(state), np.array(covariance), white, likelihood)


def likeliest_sway(run: Reckoning, errors: SensorErrors) -> float:
    """Standard deviation of the vehicle's displacement that makes the innovations likeliest, m."""
    found = minimize_scalar(
        lambda x: -filtered(run, errors, float(np.exp(x))).log_likelihood,
        bounds=np.log(SWAY_BOUNDS),
        method="bounded",
        options={"xatol": TOLERANCE},
    )
    return float(np.exp(found.x))
