"""The alignment filter's states: those of `standing`, and what wanders during the record.

Rotation since the record's start as computed (2), about north and east, rad; bias instability of
gyros (9), rad/s, and level accelerometers (6), m/s^2, about and along north, east, down: like
processes of like sensors look the same in any axes.
"""

import numpy as np
from numpy.typing import NDArray

from ins_eval.alignment.bias_instability import PROCESSES, correlation_times, process_variance
from ins_eval.alignment.kalman import standing
from ins_eval.common.sensor_errors import SensorErrors

Array = NDArray[np.float64]

CORE = slice(0, standing.STATES)
TURNED = slice(CORE.stop, CORE.stop + 2)
GYRO_WANDER = slice(TURNED.stop, TURNED.stop + 3 * PROCESSES)
ACCELEROMETER_WANDER = slice(GYRO_WANDER.stop, GYRO_WANDER.stop + 2 * PROCESSES)
STATES = ACCELEROMETER_WANDER.stop
LEVEL = [0, 1]
"""Attitude about north and east."""


def dynamics(latitude: float, height: float, duration: float) -> Array:
    """(30, 30) time derivative of the states by the states; biases about and along north, east,
    down."""
    f = np.zeros((STATES, STATES))
    f[CORE, CORE] = standing.dynamics(latitude, height)
    f[standing.ATTITUDE, GYRO_WANDER] = np.tile(np.eye(3), PROCESSES)
    f[TURNED] = f[LEVEL]
    f[standing.VELOCITY, ACCELEROMETER_WANDER] = np.tile(np.eye(2), PROCESSES)
    return f - np.diag(_decay(duration))


def noise(errors: SensorErrors, interval: float, gravity: float, duration: float) -> Array:
    """(30, 22) root of the densities that drive the states; the vehicle's motion is not in it."""
    core = standing.noise(errors, interval, gravity)
    wander = np.sqrt(2 * _decay(duration) * _wander_variance(errors))[TURNED.stop :]
    g = np.zeros((STATES, core.shape[1] + len(wander)))
    g[CORE, : core.shape[1]] = core
    g[TURNED] = g[LEVEL]
    g[TURNED.stop :, core.shape[1] :] = np.diag(wander)
    return g


def prior(errors: SensorErrors) -> Array:
    """(30, 30) covariance before any measurement; nothing has turned yet."""
    covariance = np.diag(_wander_variance(errors))
    covariance[CORE, CORE] = standing.prior(errors)
    return covariance


def _decay(duration: float) -> Array:
    """(30,) inverse correlation times of what wanders, 1/s; 0 elsewhere."""
    times = np.full(STATES, np.inf)
    times[GYRO_WANDER] = np.repeat(correlation_times(duration), 3)
    times[ACCELEROMETER_WANDER] = np.repeat(correlation_times(duration), 2)
    return 1 / times


def _wander_variance(errors: SensorErrors) -> Array:
    """(30,)."""
    variance = np.zeros(STATES)
    variance[GYRO_WANDER] = process_variance(errors.gyro_bias_instability)
    variance[ACCELEROMETER_WANDER] = process_variance(errors.accelerometer_bias_instability)
    return variance
