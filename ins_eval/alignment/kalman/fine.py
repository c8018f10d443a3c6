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

from ins_eval.alignment.kalman import aligning_model, standing
from ins_eval.alignment.kalman.dead_reckoning import (
    FEWEST_STEPS,
    Reckoning,
    corrected,
    in_whole_steps,
    reckoned,
)
from ins_eval.alignment.kalman.tilting import Tilting, likeliest_tilting
from ins_eval.alignment.result import Alignment, AlignmentError, Biases, History
from ins_eval.common.increments import Increments
from ins_eval.common.sensor_errors import SensorErrors

Array = NDArray[np.float64]

SETTLED = 1e-4
"""Correction of the start attitude below which the linear model holds, rad."""
MOST_PASSES = 6
MOST_APART = 3.0
"""Attitudes with and without a steady tilt, in sigma of the difference."""
NO_ODDS = 1e-6
"""Of a variance: less than this is rounding."""
SWAY_BOUNDS = (1e-6, 100.0)
"""Between which the vehicle's displacement is looked for, m."""
TOLERANCE = 0.05
"""Of its logarithm."""


@dataclass(frozen=True)
class Filtered:
    """state: (m, 30); covariance: (m, 30, 30); innovation: (m, 2), whitened;
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
    steady: bool = True,
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
        steady: whether the vehicle's tilt stays where it is, as far as the record shows it;
            otherwise any motion of it is as good as any other.

    Raises:
        AlignmentError: too short a record, or one whose attitude does not settle.
    """
    run, result, sway = settled(record, position, errors, coarse, sway)
    if steady:
        result = steadied(run, errors, sway, result)
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


def steadied(run: Reckoning, errors: SensorErrors, sway: float, free: Filtered) -> Filtered:
    """With the knowledge that the vehicle's tilt stays where it is, as far as the gyros show it.

    A tilt that creeps at a steady rate looks like another rate of Earth. It parts the attitude from
    that of the accelerometers, which don't mind: where the two differ by more than chance, the
    steady one is dropped. Their difference has the difference of their variances (Hausman 1978).
    """
    steady = filtered(run, errors, sway, likeliest_tilting(run.turned, run.step, errors))
    attitude = standing.ATTITUDE
    difference = steady.state[-1, attitude] - free.state[-1, attitude]
    before, after = (np.diag(r.covariance[-1])[attitude] for r in (free, steady))
    variance = np.maximum(before - after, NO_ODDS * before)
    return steady if np.all(difference**2 < MOST_APART**2 * variance) else free


def filtered(
    run: Reckoning, errors: SensorErrors, sway: float, tilting: Tilting | None = None
) -> Filtered:
    """The Kalman filter over a run; without `tilting`, rotation tells nothing."""
    size = aligning_model.STATES
    walk, white = (tilting.walk, tilting.white) if tilting else (0.0, 0.0)
    turned = np.eye(2) if tilting else np.empty((0, 2))
    h = np.zeros((2 + len(turned), size))
    h[:2, standing.DISPLACEMENT] = np.eye(2)
    h[2:, aligning_model.TURNED] = turned
    kalman = KalmanFilter(dim_x=size, dim_z=len(h))
    kalman.P = aligning_model.prior(errors)
    kalman.P[aligning_model.TURNED, aligning_model.TURNED] += white**2 * np.eye(2)
    kalman.Q = run.noise(errors)
    kalman.Q[aligning_model.TURNED, aligning_model.TURNED] += walk**2 * run.step * np.eye(2)
    kalman.H = h
    kalman.R = np.diag([sway**2, sway**2, white**2, white**2][: len(h)])
    measured = np.hstack([run.displacement, run.turned])[:, : len(h)]
    state, covariance, innovation, spread = [], [], [], []
    for z, transition in zip(measured, run.transition, strict=True):
        kalman.predict(F=transition)
        kalman.update(z[:, None])
        state.append(kalman.x[:, 0])
        covariance.append(kalman.P)
        innovation.append(kalman.y[:, 0])
        spread.append(kalman.S)
    root = np.linalg.cholesky(np.array(spread))
    white_noise = np.linalg.solve(root, np.array(innovation)[..., None])[..., 0]
    diagonal = np.diagonal(root, axis1=1, axis2=2)
    each = -np.sum(0.5 * white_noise**2 + np.log(diagonal), axis=1)
    likelihood = float(each[FEWEST_STEPS // 2 :].sum())
    return Filtered(np.array(state), np.array(covariance), white_noise[:, :2], likelihood)


def likeliest_sway(run: Reckoning, errors: SensorErrors) -> float:
    """Standard deviation of the vehicle's displacement that makes the innovations likeliest, m."""
    found = minimize_scalar(
        lambda x: -filtered(run, errors, float(np.exp(x))).log_likelihood,
        bounds=np.log(SWAY_BOUNDS),
        method="bounded",
        options={"xatol": TOLERANCE},
    )
    return float(np.exp(found.x))
