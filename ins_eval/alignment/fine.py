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
from scipy.spatial.transform import Rotation

from ins_eval import earth
from ins_eval.alignment import standing
from ins_eval.alignment.result import Alignment, AlignmentError, Biases, History
from ins_eval.increments import Increments
from ins_eval.navigation.height import Clamped
from ins_eval.navigation.strapdown import navigate
from ins_eval.sensor_errors import SensorErrors
from ins_eval.state import State, Track, position_error

Array = NDArray[np.float64]

STEP = 1.0
"""Time between measurements, s."""
MOST_STEPS = 300
"""More than so many measurements are not taken: the steps lengthen."""
FEWEST_STEPS = 15
SETTLED = 1e-4
"""Correction of the attitude after which the model counts as linear, rad."""
MOST_PASSES = 6
SWAY_BOUNDS = (1e-6, 100.0)
"""Between which the vehicle's displacement is looked for, m."""


@dataclass(frozen=True)
class Pass:
    """A navigator from one start attitude, and its error's steps.

    displacement: (m, 2) computed, north, east, m; transition: (m, 13, 13); noise: (13, 13), of
    each step.
    """

    track: Track
    displacement: Array
    transition: Array
    noise: Array


@dataclass(frozen=True)
class Filtered:
    """state: (m, 13); covariance: (m, 13, 13); log_likelihood: of the innovations once the filter
    has settled; innovation: (m, 2), each divided by its sigma."""

    state: Array
    covariance: Array
    log_likelihood: float
    innovation: Array


def fine_alignment(
    record: Increments,
    position: Array,
    errors: SensorErrors,
    coarse: Array,
    sway: float | None = None,
) -> Alignment:
    """Attitude at the end of a record of a vehicle that stands or sways.

    The start attitude is corrected until the errors are small enough for the linear model. The
    prior leaves attitude free, so that nothing is counted twice.

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
    record, each = _whole_steps(record)
    mat_nb = coarse
    for _ in range(MOST_PASSES):
        run = _pass(record, position, errors, mat_nb, each)
        if sway is None:
            sway = likeliest_sway(run, errors)
        result = filtered(run, errors, sway)
        first = _first_error(run, result)
        if np.linalg.norm(first) < SETTLED:
            return _alignment(run, result, sway)
        mat_nb = corrected(mat_nb, first)
    raise AlignmentError(
        f"attitude still off by {np.rad2deg(np.linalg.norm(first)):.2g} deg "
        f"after {MOST_PASSES} passes: the vehicle moved, or the coarse attitude is far off"
    )


def filtered(run: Pass, errors: SensorErrors, sway: float) -> Filtered:
    """The Kalman filter over a pass."""
    kalman = KalmanFilter(dim_x=standing.STATES, dim_z=2)
    kalman.P = standing.prior(errors)
    kalman.H = np.eye(standing.STATES)[standing.DISPLACEMENT]
    kalman.R = sway**2 * np.eye(2)
    state, covariance, innovation, spread = [], [], [], []
    for z, transition in zip(run.displacement, run.transition, strict=True):
        kalman.predict(F=transition, Q=run.noise)
        kalman.update(z[:, None])
        state.append(kalman.x[:, 0])
        covariance.append(kalman.P)
        innovation.append(kalman.y[:, 0])
        spread.append(kalman.S)
    root = np.linalg.cholesky(np.array(spread))
    white = np.linalg.solve(root, np.array(innovation)[..., None])[..., 0]
    likelihood = -0.5 * np.sum(white**2, axis=1) - np.log(root[:, 0, 0] * root[:, 1, 1])
    return Filtered(
        np.array(state), np.array(covariance), float(likelihood[FEWEST_STEPS // 2 :].sum()), white
    )


def likeliest_sway(run: Pass, errors: SensorErrors) -> float:
    """Standard deviation of the vehicle's displacement that makes the innovations likeliest, m."""
    bounds = np.log(SWAY_BOUNDS)
    found = minimize_scalar(
        lambda x: -filtered(run, errors, float(np.exp(x))).log_likelihood,
        bounds=(bounds[0], bounds[1]),
        method="bounded",
        options={"xatol": 0.05},
    )
    return float(np.exp(found.x))


def corrected(mat_nb: Array, attitude: Array) -> Array:
    """Attitudes (..., 3, 3) less their estimated errors (..., 3), rad."""
    return np.asarray(Rotation.from_rotvec(-attitude).as_matrix() @ mat_nb)


def _whole_steps(record: Increments) -> tuple[Increments, int]:
    """The record's end in whole steps, and intervals a step."""
    wanted = max(STEP, record.duration / MOST_STEPS) / record.interval
    each = 2 * max(1, round(wanted / 2))
    count = len(record) // each
    if count < FEWEST_STEPS:
        raise AlignmentError(
            f"{record.duration:g} s of increments every {record.interval:g} s: "
            f"expected at least {FEWEST_STEPS * each * record.interval:g} s"
        )
    return record.between(len(record) - count * each, len(record)), each


def _pass(
    record: Increments, position: Array, errors: SensorErrors, mat_nb: Array, each: int
) -> Pass:
    latitude, longitude, height = map(float, position)
    start = State(latitude, longitude, height, np.zeros(3), mat_nb)
    track = navigate(start, record, Clamped(np.full(len(record) + 1, height)), each)
    begun = np.concatenate([mat_nb[None], track.mat_nb[:-1]])
    transition, noise = standing.discretised(
        standing.dynamics(latitude, height),
        standing.noise(errors, record.interval, float(earth.gravity(latitude, height))),
        each * record.interval,
    )
    return Pass(
        track,
        position_error(track.position, np.asarray(position, dtype=float))[:, :2],
        standing.in_body_axes(transition, 0.5 * (begun + track.mat_nb)),
        noise,
    )


def _first_error(run: Pass, result: Filtered) -> Array:
    """Attitude error (3,) at the start that leads to the last estimate, rad."""
    whole = np.eye(standing.STATES)
    for transition in run.transition:
        whole = transition @ whole
    return np.asarray(np.linalg.solve(whole, result.state[-1])[standing.ATTITUDE])


def _alignment(run: Pass, result: Filtered, sway: float) -> Alignment:
    attitude = standing.ATTITUDE
    both = slice(standing.GYRO.start, standing.ACCELEROMETER.stop)
    mat_nb = corrected(run.track.mat_nb, result.state[:, attitude])
    covariance = result.covariance[:, attitude, attitude]
    return Alignment(
        method="fine",
        time=float(run.track.time[-1]),
        mat_nb=mat_nb[-1],
        covariance=covariance[-1],
        biases=Biases(
            result.state[-1, standing.GYRO],
            result.state[-1, standing.ACCELEROMETER],
            result.covariance[-1, both, both],
        ),
        history=History(run.track.time, mat_nb, covariance, result.innovation),
        sway=sway,
    )
