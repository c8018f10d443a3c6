"""One gyro turned step by step, by FMPy's own calls."""

from collections.abc import Iterable

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.fmu.gyro import Gyro


def advance(gyro: Gyro, rate: float, duration: float) -> float:
    """Turn the case at a constant inertial rate about the input axis, rad/s, for a duration, s, in
    one step; returns the gyro's angle at the end, rad."""
    return float(drive(gyro, [rate], duration)[0])


def drive(gyro: Gyro, rates: Iterable[float], step: float) -> Array:
    """Turn the case at rates (n,), rad/s, that each hold for one step, s; returns the gyro's angle
    at the end of each, rad."""
    angles = []
    for i, rate in enumerate(rates):
        gyro.command("angularRate", float(rate))
        gyro.instance._call(gyro.instance.slave.doStep, gyro.time + i * step, step)
        angles.append(gyro.read("gyroAngle"))
    gyro.time += step * len(angles)
    return np.array(angles)
