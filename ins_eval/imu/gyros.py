"""The inertial measurement unit: three gyros as FMUs along the body axes, three accelerometers."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval.increments import Increments
from pyhrg.bench.bench import Bench
from pyhrg.bench.bias import full_circumference
from pyhrg.fmu import GyroFmu
from pyhrg.parameters import Device
from pyhrg.units import MICRO_G

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Accelerometers:
    """A triad of accelerometers.

    bias: standard deviation of each one's constant error, m/s^2;
    noise: velocity random walk, m/s/sqrt(s).
    """

    bias: float
    noise: float

    def measure(self, truth: Increments, generator: np.random.Generator) -> Array:
        """Velocity increments (n, 3), m/s, with a bias and noise drawn anew."""
        bias = generator.normal(0.0, self.bias, size=3)
        noise = generator.normal(0.0, self.noise, size=truth.velocity.shape)
        return truth.velocity + bias * truth.interval + noise * np.sqrt(truth.interval)


TYPICAL_ACCELEROMETERS = Accelerometers(bias=5 * MICRO_G, noise=5 * MICRO_G)
"""Good enough that a gyro bias of 0.001 deg/h can still be seen in the position error."""


def measured_rotation(
    fmu: GyroFmu, device: Device, rotation: Array, interval: float, generator: np.random.Generator
) -> Array:
    """Rotation increments of one gyro, its mean bias calibrated.

    The maker's calibration is a bench run of its own, power-on apart: eight positions of the
    circumference, 100 s each; the mean of the fitted map.

    Args:
        fmu: the gyro's model.
        device: its parameters.
        rotation: (n,) true rotation about the input axis in each interval, rad.
        interval: s.
        generator: of power-on angles and noise seeds.

    Returns:
        (n,) rad.
    """
    bench = Bench(fmu, device, seed=int(generator.integers(2**63)))
    power_ons = full_circumference.power_ons(bench, full_circumference.SHORTEST, 1, segments=1)
    calibration = bench.campaign([bench.log(power_on) for power_on in power_ons])
    mean_bias = full_circumference.mean_bias(calibration)
    with bench.power_on("flight") as gyro:
        angles = gyro.drive(rotation / interval, interval)
    return np.diff(angles, prepend=0.0) - mean_bias * interval


def measure(
    fmu: GyroFmu,
    devices: Sequence[Device],
    accelerometers: Accelerometers,
    truth: Increments,
    generator: np.random.Generator,
) -> Increments:
    """What a triad of gyros and accelerometers makes of the true motion."""
    rotation = np.stack(
        [
            measured_rotation(fmu, device, truth.rotation[:, axis], truth.interval, generator)
            for axis, device in enumerate(devices)
        ],
        axis=-1,
    )
    velocity = accelerometers.measure(truth, generator)
    return Increments(truth.interval, rotation, velocity, truth.start)
