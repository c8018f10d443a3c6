"""The old bias test: the gyro rests, and the pattern stays where it is.

Procedure of the fibre-optic gyro standards, as the paper's sections 1.2 and 4.1 describe it. The
input axis is level and points east, so that no Earth rate moves the pattern during the hour.
"""

import numpy as np

from pyhrg.bench.bias_test import WARM_UP, BiasRun, power_on, segment_means
from pyhrg.fmu import GyroFmu
from pyhrg.parameters import Device

SEGMENTS = 36
"""Data points of a run: one hour."""


def run(fmu: GyroFmu, device: Device, generator: np.random.Generator) -> BiasRun:
    """One power-on of the test.

    Args:
        fmu: the gyro's model.
        device: its parameters.
        generator: of noise seed and power-on angle.

    Returns:
        The run's data points, in order.
    """
    with power_on(fmu, device, generator) as gyro:
        gyro.advance(0.0, WARM_UP)
        return BiasRun(segment_means(gyro, 0.0, SEGMENTS))
