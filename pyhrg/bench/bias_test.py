"""What bias tests have in common: 100 s means, runs, stability and repeatability."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.fmu import Gyro, GyroFmu
from pyhrg.parameters import Device

SEGMENT = 100.0
"""Averaging time of one data point, s (paper 4.1, item 3)."""
RUNS = 7
"""Power-ons of a test (paper 4.1, item 4)."""
WARM_UP = 30.0
"""Time from power-on to the first data point, s: the loops' transient lasts about one."""


@dataclass(frozen=True)
class BiasRun:
    """One power-on: its 100 s means, rad/s, Earth's rate taken out."""

    points: NDArray[np.float64]

    @property
    def mean(self) -> float:
        """Bias of the run, rad/s (paper 4.1, item 5)."""
        return float(np.mean(self.points))

    @property
    def deviation(self) -> float:
        """Standard deviation of the run's points, rad/s, n - 1 (paper 4.1, item 4)."""
        return float(np.std(self.points, ddof=1))


@dataclass(frozen=True)
class BiasTest:
    """Result of a bias test: runs with the power cycled between them."""

    runs: tuple[BiasRun, ...]

    @property
    def bias(self) -> float:
        """Mean over all runs, rad/s."""
        return float(np.mean([run.mean for run in self.runs]))

    @property
    def stability(self) -> float:
        """Bias stability, rad/s: mean over runs of the runs' standard deviations."""
        return float(np.mean([run.deviation for run in self.runs]))

    @property
    def repeatability(self) -> float:
        """Bias repeatability, rad/s: standard deviation over runs of the runs' means, n - 1."""
        return float(np.std([run.mean for run in self.runs], ddof=1))


def power_on(fmu: GyroFmu, device: Device, generator: np.random.Generator) -> Gyro:
    """Switch a gyro on: new noise, and its power-on angle as well as it repeats."""
    return fmu.power_on(
        device.fmu_parameters(),
        seed=int(generator.integers(2**31)),
        start_angle=generator.normal(device.power_on_angle, device.power_on_scatter),
    )


def segment_means(gyro: Gyro, rate: float, count: int) -> NDArray[np.float64]:
    """Mean output rate of consecutive segments with the table at rest.

    Args:
        gyro: switched on and settled.
        rate: component of Earth's rate on the input axis, rad/s; taken out of the result.
        count: number of segments.

    Returns:
        (count,) rad/s.
    """
    before = gyro.read("gyroAngle")
    angles = gyro.drive(np.full(count, rate), SEGMENT)
    return np.diff(angles, prepend=before) / SEGMENT - rate
