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
from ins_eval.common.sensor_errors import SensorErrors
from pyhrg.common.arrays import Array
from pyhrg.records.imu.log import Increments

PRIOR_SIGMA = float(np.log(10))
"""Prior standard deviation of the logarithm of a stated walk: a decade. Chosen."""
UNSTATED = (1e-7, 1e-4)
"""Centre of the prior of a walk that isn't stated: angle random walk, rad/sqrt(s), and velocity
random walk, m/s/sqrt(s). Chosen."""
BOUNDS = ((1e-11, 1e-3), (1e-9, 1e-1), (1e-6, 1e2))
"""Search ranges of both and of the sway, m. Chosen."""
CURVATURE_STEP = 0.1
"""Change of a parameter's logarithm over which the curvature of the likelihood is taken. Chosen."""


@dataclass(frozen=True)
class MeasuredNoise:
    """Noise estimated by maximum a posteriori.

    Attributes:
        errors: stated sensor errors with the estimated angle and velocity random walk.
        sway: estimated sway of the vehicle, m.
        relative_sigma: (3,) relative one-sigma of the three estimates, from the curvature of the
            posterior.
    """

    errors: SensorErrors
    sway: float
    relative_sigma: Array


def measure_noise(record: Increments, position: Array, stated: SensorErrors) -> MeasuredNoise:
    """Estimate angle and velocity random walk from a standing vehicle's record.

    Their prior is log-normal about the stated ones, a decade wide: it decides where the record is
    too short to separate the gyros' walk. Biases and quantization steps remain as stated.

    Args:
        record: of a vehicle that stands, people moving in it, or sways.
        position: (3,) latitude, longitude, rad, and height, m.

    Raises:
        HrgError: a record that can't be aligned on.
    """
    walks = (stated.angle_random_walk, stated.velocity_random_walk)
    prior = np.log([w or unstated for w, unstated in zip(walks, UNSTATED, strict=True)])
    coarse = fit_inertial_frame(record, position).mat_ib
    run, _, sway = reckon_until_linear(record, position, _with_walks(stated, prior), coarse, None)

    def posterior(logarithms: Array) -> float:
        departure = (logarithms[:2] - prior) / PRIOR_SIGMA
        return _log_likelihood(run, stated, logarithms) - 0.5 * float(departure @ departure)

    estimate = minimize(
        lambda x: -posterior(x),
        np.append(prior, np.log(sway)),
        method="Nelder-Mead",
        bounds=np.log(BOUNDS),
        options={"xatol": 0.03, "fatol": 0.1, "maxfev": 300},
    ).x
    variance = np.diag(np.linalg.inv(-_curvature(posterior, estimate)))
    sigma = np.sqrt(np.maximum(variance, 0.0))
    return MeasuredNoise(_with_walks(stated, estimate[:2]), float(np.exp(estimate[2])), sigma)


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
