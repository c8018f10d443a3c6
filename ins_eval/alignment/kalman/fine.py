"""Fine alignment: a Kalman filter on the displacement of a navigator whose vehicle stands.

The measurement is that the navigated displacement is 0 but for the vehicle's sway. The displacement
of a standing vehicle is bounded, so that its samples are nearly white. Its velocity is the
derivative, which is coloured; taken as white noise, it would get too little weight.
docs/methods/alignment.md, Eqs. 5 to 7.

The vehicle's tilting is estimated from its gyros' record: rotation about level axes in excess of
the gyros' own noise. Its model is white noise from step to step plus a random walk. A steady rate
is left out: it contains the heading (Eq. 7).
"""

from dataclasses import dataclass

import numpy as np
from filterpy.kalman import KalmanFilter
from scipy.optimize import minimize, minimize_scalar

from ins_eval.alignment.kalman import aligning_model, standing
from ins_eval.alignment.kalman.dead_reckoning import (
    MIN_STEPS,
    Reckoning,
    correct_attitude,
    reckon,
    split_into_steps,
)
from ins_eval.alignment.result import Alignment, History
from ins_eval.common.sensor_errors import SensorErrors
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.records.imu.log import Increments

BOUNDS = ((1e-7, 1.0), (1e-10, 1.0))
"""Search ranges of `Tilting`. Chosen: below the lower ends the heading does not change."""


@dataclass(frozen=True)
class Tilting:
    """Tilting about each level axis.

    Attributes:
        angle_white_noise: standard deviation, rad, including quantization.
        angle_random_walk: coefficient, rad/sqrt(s).
    """

    angle_white_noise: float
    angle_random_walk: float


def estimate_tilting(turned: Array, step: float, errors: SensorErrors) -> Tilting:
    """Estimate the tilting from the rotation `turned` (m, 2) about north and east since the start,
    rad, at the end of each step, s.

    It maximizes Whittle's likelihood of the periodogram of the mean rates, without frequency 0
    (Whittle 1953).
    """
    rate = np.diff(turned, axis=0, prepend=0.0) / step
    frequency = np.fft.rfftfreq(len(rate), step)[1:]
    periodogram = np.mean(np.abs(np.fft.rfft(rate, axis=0)[1:]) ** 2, axis=1) * step / len(rate)
    own = errors.angle_random_walk**2 + errors.gyro_bias_instability**2 / (2 * np.pi * frequency)
    differenced = 4 * np.sin(np.pi * frequency * step) ** 2 / step

    def cost(logarithms: Array) -> float:
        white, walk = np.exp(2 * logarithms)
        density = own + white * differenced + walk
        return float(np.sum(np.log(density) + periodogram / density))

    spread = float(np.sqrt(np.mean(periodogram)))
    start = np.clip(np.log([spread * np.sqrt(step) + 1e-30, spread + 1e-30]), *np.log(BOUNDS).T)
    estimate = minimize(cost, start, method="Nelder-Mead", bounds=np.log(BOUNDS))
    return Tilting(*map(float, np.exp(estimate.x)))


MAX_LINEAR_ERROR = 1e-4
"""Correction of the start attitude below which the linear model is valid, rad. Chosen."""
MAX_PASSES = 6
"""Largest number of passes through the record. Chosen."""
MAX_DIFFERENCE_SIGMA = 3.0
"""Largest difference of the attitudes with and without steady tilt, in its sigma. Chosen."""
MIN_VARIANCE_RATIO = 1e-6
"""Smallest ratio of the difference's variance to the variance itself; less is rounding. Chosen."""
SWAY_BOUNDS = (1e-6, 100.0)
"""Search range of the vehicle's sway, m. Chosen."""
SWAY_TOLERANCE = 0.05
"""Tolerance of the logarithm of the sway. Chosen."""


@dataclass(frozen=True)
class FilterResult:
    """Estimates of the filter.

    Attributes:
        state: (m, 30) estimated states of `aligning_model`.
        covariance: (m, 30, 30) covariance of the states.
        innovation: (m, 2) whitened innovations of the displacement.
        log_likelihood: log-likelihood of the innovations after the filter has settled.
    """

    state: Array
    covariance: Array
    innovation: Array
    log_likelihood: float


def align_by_kalman_filter(
    record: Increments,
    position: Array,
    errors: SensorErrors,
    coarse: Array,
    sway: float | None = None,
    steady: bool = True,
) -> Alignment:
    """Find the attitude at the end of a record of a vehicle that stands or sways.

    The prior of the attitude is so wide that the coarse attitude (3, 3) at the start, within some
    degrees, is not used as information. A sway of None, m, is estimated by maximum likelihood;
    `steady` uses that the tilt stays constant, as far as the record shows it.
    """
    run, result, sway = reckon_until_linear(record, position, errors, coarse, sway)
    if steady:
        result = apply_steady_tilt(run, errors, sway, result)
    attitude = standing.ATTITUDE
    mat_nb = correct_attitude(run.track.mat_nb, result.state[:, attitude])
    covariance = result.covariance[:, attitude, attitude]
    return Alignment(
        time=float(run.track.time[-1]),
        mat_nb=mat_nb[-1],
        covariance=covariance[-1],
        history=History(run.track.time, mat_nb, covariance, result.innovation),
        sway=sway,
    )


def reckon_until_linear(
    record: Increments, position: Array, errors: SensorErrors, coarse: Array, sway: float | None
) -> tuple[Reckoning, FilterResult, float]:
    """Reckon and filter until the start attitude is accurate enough for the linear model; return
    both results and the sway, m."""
    record, each = split_into_steps(record)
    mat_nb = coarse
    for _ in range(MAX_PASSES):
        run = reckon(record, position, mat_nb, each)
        if sway is None:
            sway = estimate_sway(run, errors)
        result = run_filter(run, errors, sway)
        first = run.first_error(result.state[-1])[standing.ATTITUDE]
        if np.linalg.norm(first) < MAX_LINEAR_ERROR:
            return run, result, sway
        mat_nb = correct_attitude(mat_nb, first)
    raise HrgError(
        f"attitude still off by {np.rad2deg(np.linalg.norm(first)):.2g} deg "
        f"after {MAX_PASSES} passes: the vehicle moved, the coarse attitude is far off, or the "
        "gyros' biases are too large to find north by"
    )


def apply_steady_tilt(
    run: Reckoning, errors: SensorErrors, sway: float, free: FilterResult
) -> FilterResult:
    """Filter with the rotation since the start as a measurement, unless it contradicts `free`.

    A tilt that creeps at a steady rate looks like a change of Earth's rate, and shifts the attitude
    from that of the filter without the assumption. If they differ significantly, `free` is
    returned. The variance of the difference is the difference of the variances (Hausman 1978).
    """
    steady = run_filter(run, errors, sway, estimate_tilting(run.turned, run.step, errors))
    attitude = standing.ATTITUDE
    difference = steady.state[-1, attitude] - free.state[-1, attitude]
    before, after = (np.diag(r.covariance[-1])[attitude] for r in (free, steady))
    variance = np.maximum(before - after, MIN_VARIANCE_RATIO * before)
    return steady if np.all(difference**2 < MAX_DIFFERENCE_SIGMA**2 * variance) else free


def run_filter(
    run: Reckoning, errors: SensorErrors, sway: float, tilting: Tilting | None = None
) -> FilterResult:
    """Run the Kalman filter; `tilting` adds the rotation since the start as a measurement."""
    size, turned = aligning_model.STATES, aligning_model.TURNED
    kalman = KalmanFilter(dim_x=size, dim_z=4 if tilting else 2)
    kalman.P = aligning_model.prior(errors)
    kalman.Q = run.noise(errors)
    kalman.H = np.zeros((kalman.dim_z, size))
    kalman.H[:2, standing.DISPLACEMENT] = np.eye(2)
    measured, variances = run.displacement, [sway**2, sway**2]
    if tilting:
        white, walk = tilting.angle_white_noise, tilting.angle_random_walk
        # White tilt is in every reading (R) and also at the start, to which readings refer (P).
        variances += [white**2, white**2]
        kalman.P[turned, turned] += white**2 * np.eye(2)
        kalman.Q[turned, turned] += walk**2 * run.step * np.eye(2)
        kalman.H[2:, turned] = np.eye(2)
        measured = np.hstack([measured, run.turned])
    kalman.R = np.diag(variances)
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
    likelihood = float(each[MIN_STEPS // 2 :].sum())
    return FilterResult(np.array(state), np.array(covariance), white_noise[:, :2], likelihood)


def estimate_sway(run: Reckoning, errors: SensorErrors) -> float:
    """Estimate the standard deviation of the vehicle's displacement, m, by maximum likelihood."""
    estimate = minimize_scalar(
        lambda x: -run_filter(run, errors, float(np.exp(x))).log_likelihood,
        bounds=np.log(SWAY_BOUNDS),
        method="bounded",
        options={"xatol": SWAY_TOLERANCE},
    )
    return float(np.exp(estimate.x))
