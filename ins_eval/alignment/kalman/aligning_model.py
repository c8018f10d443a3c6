"""The 30 states of the alignment filter: the 13 of `standing`, and 17 more.

These are the rotation since the record's start (2), about north and east, rad, and the Gauss-Markov
processes of bias instability: of the gyros (9), rad/s, and of the level accelerometers (6), m/s^2,
in navigation axes. Equal processes of equal sensors are the same in any axes.
docs/methods/alignment.md, Eq. 6.
"""

import numpy as np

from ins_eval.alignment.bias_instability import PROCESSES, correlation_times
from ins_eval.alignment.kalman import standing
from ins_eval.common.sensor_errors import SensorErrors
from pyhrg.common.arrays import Array
from pyhrg.noise.coefficients import compute_process_variance

CORE = slice(0, standing.STATES)
TURNED = slice(CORE.stop, CORE.stop + 2)
GYRO_INSTABILITY = slice(TURNED.stop, TURNED.stop + 3 * PROCESSES)
ACCELEROMETER_INSTABILITY = slice(GYRO_INSTABILITY.stop, GYRO_INSTABILITY.stop + 2 * PROCESSES)
STATES = ACCELEROMETER_INSTABILITY.stop
LEVEL = [0, 1]
"""Places of the attitude about north and east."""


def dynamics(latitude: float, height: float, duration: float) -> Array:
    """Return F (30, 30), dx/dt = F x, with biases about and along north, east, down."""
    f = np.zeros((STATES, STATES))
    f[CORE, CORE] = standing.dynamics(latitude, height)
    f[standing.ATTITUDE, GYRO_INSTABILITY] = np.tile(np.eye(3), PROCESSES)
    f[TURNED] = f[LEVEL]
    f[standing.VELOCITY, ACCELEROMETER_INSTABILITY] = np.tile(np.eye(2), PROCESSES)
    return f - np.diag(_decay(duration))


def noise(errors: SensorErrors, interval: float, gravity: float, duration: float) -> Array:
    """Return the root (30, 22) of the densities that drive the states, without the vehicle's
    motion."""
    core = standing.noise(errors, interval, gravity)
    drive = np.sqrt(2 * _decay(duration) * _instability_variance(errors))[TURNED.stop :]
    g = np.zeros((STATES, core.shape[1] + len(drive)))
    g[CORE, : core.shape[1]] = core
    g[TURNED] = g[LEVEL]
    g[TURNED.stop :, core.shape[1] :] = np.diag(drive)
    return g


def prior(errors: SensorErrors) -> Array:
    """Return the covariance (30, 30) before any measurement; the rotation is 0."""
    covariance = np.diag(_instability_variance(errors))
    covariance[CORE, CORE] = standing.prior(errors)
    return covariance


def _decay(duration: float) -> Array:
    """Return the inverse correlation times (30,), 1/s, of the Gauss-Markov states; 0 elsewhere."""
    times = np.full(STATES, np.inf)
    times[GYRO_INSTABILITY] = np.repeat(correlation_times(duration), 3)
    times[ACCELEROMETER_INSTABILITY] = np.repeat(correlation_times(duration), 2)
    return 1 / times


def _instability_variance(errors: SensorErrors) -> Array:
    """Return the stationary variances (30,) of the Gauss-Markov states; 0 elsewhere."""
    variance = np.zeros(STATES)
    variance[GYRO_INSTABILITY] = compute_process_variance(errors.gyro_bias_instability)
    variance[ACCELEROMETER_INSTABILITY] = compute_process_variance(
        errors.accelerometer_bias_instability
    )
    return variance
