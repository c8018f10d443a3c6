"""Position error that a bench figure promises, before anything is flown.

A gyro's bias stability is taken as the standard deviation of a bias that is constant over the
mission, the same for all three gyros; the accelerometers' biases likewise. How far each bias
carries the position is found by flying it alone through the navigator, alignment included, so
that the prediction knows the manoeuvre and what alignment hides; it knows nothing of the device.
"""

import numpy as np
from numpy.typing import NDArray

from ins_eval.increments import Increments
from ins_eval.metrics import median_radius
from ins_eval.validation.mission import Mission

Array = NDArray[np.float64]

GYRO_PROBE = 5e-8
"""Bias that is flown to find the sensitivity, rad/s (0.01 deg/h)."""
ACCELEROMETER_PROBE = 1e-4
"""Likewise, m/s^2 (10 micro-g)."""


def bias_sensitivity(mission: Mission) -> tuple[Array, Array]:
    """Position error per bias of each gyro (3, m, 2), m/(rad/s), and accelerometer, m/(m/s^2)."""
    truth = mission.truth
    clean = mission.fly(truth)

    def probe(gyro: Array, force: Array) -> Array:
        biased = Increments(
            truth.interval,
            truth.rotation + gyro * truth.interval,
            truth.velocity + force * truth.interval,
            truth.start,
        )
        return mission.fly(biased) - clean

    axes, none = np.eye(3), np.zeros(3)
    gyros = [probe(GYRO_PROBE * axis, none) / GYRO_PROBE for axis in axes]
    forces = [probe(none, ACCELEROMETER_PROBE * axis) / ACCELEROMETER_PROBE for axis in axes]
    return np.stack(gyros), np.stack(forces)


def predicted_radial_error(
    sensitivity: tuple[Array, Array], bias_stability: float, accelerometer_bias: float
) -> Array:
    """Median radial error (m,), m, over devices whose biases have these standard deviations.

    Args:
        sensitivity: from `bias_sensitivity`.
        bias_stability: of the gyros, rad/s.
        accelerometer_bias: m/s^2.
    """
    gyros, forces = sensitivity
    covariance = bias_stability**2 * np.einsum("kmi,kmj->mij", gyros, gyros)
    covariance += accelerometer_bias**2 * np.einsum("kmi,kmj->mij", forces, forces)
    return np.array([median_radius(c) for c in covariance])
