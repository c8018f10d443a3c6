"""What may be known of the gyros of many triads before they fly, gyro by gyro along body axes."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class NoiseLevels:
    """Coefficients of IEEE Std 952, annex C, (r, 3) each, SI."""

    angle_random_walk: Array
    bias_instability: Array
    rate_random_walk: Array


@dataclass(frozen=True)
class BenchKnowledge:
    """What a bench tells of r triads.

    fixed_stability, circumference_stability: (r, 3) rad/s;
    maps: (r, 2 TERMS, 3) fitted coefficients of `GyroMap`, calibration taken out;
    covariance: (r, 2 TERMS, 2 TERMS, 3) of them;
    noise: levels that the bench found.
    """

    fixed_stability: Array
    circumference_stability: Array
    maps: Array
    covariance: Array
    noise: NoiseLevels
