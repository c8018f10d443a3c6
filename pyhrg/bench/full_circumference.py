"""The paper's bias test (section 4.1): 8N positions of the pattern, moved by the table.

The paper spaces its 8 positions over 360 deg of pattern: 45 deg, half a period of the second pair
of harmonics, where the fourth harmonic aliases into its own mean. Here they lie 22.5 deg of
pattern apart (81.23 deg of table), a quarter of the fourth harmonic's period: its standard
deviation over the positions does not depend on where they begin.
"""

import math

import numpy as np

from pyhrg.bench.bias_test import (
    WARM_UP,
    BiasRun,
    power_on,
    segment_means,
)
from pyhrg.fmu import GyroFmu
from pyhrg.parameters import Device
from pyhrg.site import EARTH_RATE
from pyhrg.units import DEG

POSITIONS = 8
PATTERN_STEP = 22.5 * DEG
TABLE_RATE = 10 * DEG
SETTLE = 20.0
"""Time at rest before a position's first data point, s."""
LATITUDE = 39.9 * DEG
"""Of the paper's laboratory; the input axis points up."""


def run(
    fmu: GyroFmu,
    device: Device,
    generator: np.random.Generator,
    positions: int = POSITIONS,
    segments: int = 3,
) -> BiasRun:
    """One power-on of the test.

    Args:
        fmu: the gyro's model.
        device: its parameters.
        generator: of noise seed and power-on angle.
        positions: 8N.
        segments: 100 s means at each position.

    Returns:
        The run's positions * segments data points, in order.
    """
    earth = EARTH_RATE * math.sin(LATITUDE)
    move = PATTERN_STEP / device.bryan_factor / TABLE_RATE
    points = []
    with power_on(fmu, device, generator) as gyro:
        gyro.advance(earth, WARM_UP)
        for position in range(positions):
            if position:
                gyro.advance(earth + TABLE_RATE, move)
            gyro.advance(earth, SETTLE)
            points.append(segment_means(gyro, earth, segments))
    return BiasRun(np.concatenate(points))
