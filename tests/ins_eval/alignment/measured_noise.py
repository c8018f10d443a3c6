"""Sensor noise measured in a standing vehicle, although people move in it.

The Allan deviation of a gyro there is that of the vehicle's motion. The innovations of the fine
alignment are differences of gyros and accelerometers, which only their own noise causes.
docs/methods/alignment.md, Eq. 10.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from scipy.optimize import minimize

from ins_eval.alignment.inertial_frame import fit_inertial_frame
from ins_eval.alignment.kalman.dead_reckoning import Reckoning
from ins_eval.alignment.kalman.fine import reckon_until_linear, run_filter
from ins_eval.alignment.result import AlignmentError
from ins_eval.common.arrays import Array
from ins_eval.common.sensor_errors import SensorErrors
from pyhrg.records.imu.increments import Increments

MIN_DURATION = 1200.0
"""Shortest record, s, that separates the gyros' random walk from the accelerometers' noise.
Chosen."""
FIRST_GUESS = (1e-7, 1e-4)
"""Start of the search: angle random walk, rad/sqrt(s), and velocity random walk, m/s/sqrt(s).
Chosen."""
BOUNDS = ((1e-11, 1e-3), (1e-9, 1e-1), (1e-6, 1e2))
"""Search ranges of both and of the sway, m. Chosen."""
CURVATURE_STEP = 0.1
"""Change of a parameter's logarithm over which the curvature of the likelihood is taken. Chosen."""


@dataclass(frozen=True)
class MeasuredNoise:
    """Noise estimated by maximum likelihood.

    errors: the stated ones with the estimated angle and velocity random walk; sway: estimated sway
    of the vehicle, m; relative_sigma: (3,) relative one-sigma of the three estimates, from the
    curvature of the likelihood.
    """

    errors: SensorErrors
    sway: float
    relative_sigma: Array


def measure_noise(record: Increments, position: Array, errors: SensorErrors) -> MeasuredNoise:
    """Estimate angle and velocity random walk from a standing vehicle's record.

    Biases and quantization steps remain as stated: the record does not determine them.

    Args:
        record: of a vehicle that stands, people moving in it, or sways.
        position: (3,) latitude, longitude, rad, and height, m.
        errors: stated sensor errors.

    Raises:
        AlignmentError: a record that can't be aligned on, or is too short.
    """
    if record.duration < MIN_DURATION:
        raise AlignmentError(
            f"record of {record.duration:g} s: expected at least {MIN_DURATION:g} s to measure "
            "the gyros' angle random walk on"
        )
    guess = _with_walks(errors, np.log(FIRST_GUESS))
    coarse = fit_inertial_frame(record, position).mat_ib
    run, _, sway = reckon_until_linear(record, position, guess, coarse, None)
    estimate = minimize(
        lambda x: -_log_likelihood(run, errors, x),
        np.log([*FIRST_GUESS, sway]),
        method="Nelder-Mead",
        bounds=np.log(BOUNDS),
        options={"xatol": 0.03, "fatol": 0.1, "maxfev": 300},
    ).x
    information = -_curvature(lambda x: _log_likelihood(run, errors, x), estimate)
    sigma = np.sqrt(np.diag(np.linalg.inv(information)))
    return MeasuredNoise(_with_walks(errors, estimate[:2]), float(np.exp(estimate[2])), sigma)


def _log_likelihood(run: Reckoning, errors: SensorErrors, logarithms: Array) -> float:
    sway = float(np.exp(logarithms[2]))
    return run_filter(run, _with_walks(errors, logarithms[:2]), sway).log_likelihood


def _curvature(function: Callable[[Array], float], at: Array) -> Array:
    """Return the matrix of second derivatives, by central differences."""
    steps = CURVATURE_STEP * np.eye(len(at))
    return np.array(
        [
            [
                sum(a * b * function(at + a * first + b * second) for a in (-1, 1) for b in (-1, 1))
                / (2 * CURVATURE_STEP) ** 2
                for second in steps
            ]
            for first in steps
        ]
    )


def _with_walks(errors: SensorErrors, logarithms: Array) -> SensorErrors:
    walks = np.exp(logarithms)
    return replace(errors, angle_random_walk=float(walks[0]), velocity_random_walk=float(walks[1]))
