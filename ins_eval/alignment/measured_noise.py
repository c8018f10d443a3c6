"""Sensor noise found in the record of a standing vehicle, where people's motion hides it.

The Allan deviation of a gyro in a vehicle that people move in is that of the vehicle. What the
gyros and the accelerometers disagree on is theirs alone: the innovations of fine alignment.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

from ins_eval.alignment.dead_reckoning import Reckoning
from ins_eval.alignment.fine import filtered, settled
from ins_eval.alignment.inertial_frame import inertial_frame_fit
from ins_eval.increments import Increments
from ins_eval.sensor_errors import SensorErrors

Array = NDArray[np.float64]

FIRST_GUESS = (1e-7, 1e-4)
"""Angle random walk, rad/sqrt(s), and velocity random walk, m/s/sqrt(s)."""
SMALLEST = (1e-11, 1e-9)
LARGEST = (1e-3, 1e-1)


def measured_noise(record: Increments, position: Array, errors: SensorErrors) -> SensorErrors:
    """The stated errors with the likeliest angle and velocity random walk of the record.

    Half an hour gives the angle random walk to about a sixth; five minutes may give none. Biases
    and quanta remain as stated: the record can't show them.

    Args:
        record: of a vehicle that stands, people moving in it, or sways.
        position: (3,) latitude, longitude (rad), height (m).
        errors: of the sensors.

    Raises:
        AlignmentError: a record that can't be aligned on.
    """
    guess = _with_walks(errors, np.log(FIRST_GUESS))
    coarse = inertial_frame_fit(record, position).mat_ib
    run, sway = settled(record, position, guess, coarse, None)
    found = minimize(
        lambda x: -_log_likelihood(run, errors, x),
        np.log([*FIRST_GUESS, sway]),
        method="Nelder-Mead",
        bounds=np.log([*zip(SMALLEST, LARGEST, strict=True), (1e-6, 100.0)]),
        options={"xatol": 0.03, "fatol": 0.1, "maxfev": 300},
    )
    return _with_walks(errors, found.x[:2])


def _log_likelihood(run: Reckoning, errors: SensorErrors, logarithms: Array) -> float:
    sway = float(np.exp(logarithms[2]))
    return filtered(run, _with_walks(errors, logarithms[:2]), sway).log_likelihood


def _with_walks(errors: SensorErrors, logarithms: Array) -> SensorErrors:
    walks = np.exp(logarithms)
    return replace(errors, angle_random_walk=float(walks[0]), velocity_random_walk=float(walks[1]))
