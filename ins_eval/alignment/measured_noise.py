"""Sensor noise found in the record of a standing vehicle, where people's motion hides it.

The Allan deviation of a gyro in a vehicle that people move in is that of the vehicle. What the
gyros and the accelerometers disagree on is theirs alone: the innovations of fine alignment.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

from ins_eval.alignment.inertial.inertial_frame import inertial_frame_fit
from ins_eval.alignment.kalman.dead_reckoning import Reckoning
from ins_eval.alignment.kalman.fine import filtered, settled
from ins_eval.alignment.result import AlignmentError
from ins_eval.common.increments import Increments
from ins_eval.common.sensor_errors import SensorErrors

Array = NDArray[np.float64]

SHORTEST = 1200.0
"""Record whose slow tilt tells the gyros' walk from the accelerometers' noise, s."""
FIRST_GUESS = (1e-7, 1e-4)
"""Angle random walk, rad/sqrt(s), and velocity random walk, m/s/sqrt(s)."""
BOUNDS = ((1e-11, 1e-3), (1e-9, 1e-1), (1e-6, 1e2))
"""Of both, and of the sway, m."""
CURVED = 0.1
"""Change of a logarithm over which the likelihood's curvature is taken."""


@dataclass(frozen=True)
class MeasuredNoise:
    """errors: the stated ones with the likeliest angle and velocity random walk; sway: of the
    vehicle, m; relative_sigma: (3,) of the three, from the likelihood's curvature."""

    errors: SensorErrors
    sway: float
    relative_sigma: Array


def measured_noise(record: Increments, position: Array, errors: SensorErrors) -> MeasuredNoise:
    """Angle and velocity random walk that make a standing vehicle's record likeliest.

    Biases and quanta remain as stated: the record can't show them.

    Args:
        record: of a vehicle that stands, people moving in it, or sways.
        position: (3,) latitude, longitude (rad), height (m).
        errors: of the sensors.

    Raises:
        AlignmentError: a record that can't be aligned on, or is too short.
    """
    if record.duration < SHORTEST:
        raise AlignmentError(
            f"record of {record.duration:g} s: expected at least {SHORTEST:g} s to measure "
            "the gyros' angle random walk on"
        )
    guess = _with_walks(errors, np.log(FIRST_GUESS))
    coarse = inertial_frame_fit(record, position).mat_ib
    run, _, sway = settled(record, position, guess, coarse, None)
    found = minimize(
        lambda x: -_log_likelihood(run, errors, x),
        np.log([*FIRST_GUESS, sway]),
        method="Nelder-Mead",
        bounds=np.log(BOUNDS),
        options={"xatol": 0.03, "fatol": 0.1, "maxfev": 300},
    ).x
    information = -_curvature(lambda x: _log_likelihood(run, errors, x), found)
    sigma = np.sqrt(np.diag(np.linalg.inv(information)))
    return MeasuredNoise(_with_walks(errors, found[:2]), float(np.exp(found[2])), sigma)


def _log_likelihood(run: Reckoning, errors: SensorErrors, logarithms: Array) -> float:
    sway = float(np.exp(logarithms[2]))
    return filtered(run, _with_walks(errors, logarithms[:2]), sway).log_likelihood


def _curvature(function: Callable[[Array], float], at: Array) -> Array:
    """Matrix of second derivatives by central differences."""
    steps = CURVED * np.eye(len(at))
    return np.array(
        [
            [
                sum(a * b * function(at + a * one + b * other) for a in (-1, 1) for b in (-1, 1))
                / (2 * CURVED) ** 2
                for other in steps
            ]
            for one in steps
        ]
    )


def _with_walks(errors: SensorErrors, logarithms: Array) -> SensorErrors:
    walks = np.exp(logarithms)
    return replace(errors, angle_random_walk=float(walks[0]), velocity_random_walk=float(walks[1]))
