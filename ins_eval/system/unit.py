"""One IMU of those that a specification describes, as the parameters of its parts' FMUs."""

from dataclasses import dataclass

import numpy as np

from ins_eval.imu.gyros import FLIGHT, FmuGyros, calibrate_mean_bias, case_axes
from ins_eval.imu.imu import Imu
from ins_eval.imu.mounting import Mounting
from ins_eval.imu.sensor_error_model import OFF_DIAGONAL, SensorErrorModel
from ins_eval.system.player.variables import name_case_axis
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError

Values = dict[str, float]
"""Values of an FMU's parameters by name, SI."""


@dataclass(frozen=True)
class Unit:
    """One IMU, drawn at random: that of `Imu.measure` for the same seed.

    Attributes:
        gyros: parameters of the three gyros.
        calibrated_bias: (3,) that the navigator subtracts, rad/s.
        accelerometers: parameters of the accelerometers.
    """

    gyros: tuple[Values, Values, Values]
    mounting: Mounting
    calibrated_bias: Array
    accelerometers: Values

    @property
    def case_axes(self) -> Values:
        """Parameters of the trajectory's FMU: axes of the three cases."""
        return {
            name_case_axis(gyro, axis, body): float(value)
            for gyro, input_axis in enumerate(self.mounting.axes)
            for (axis, body), value in np.ndenumerate(case_axes(input_axis))
        }

    @property
    def navigator(self) -> Values:
        """Parameters of the navigator: what it knows of the gyros."""
        shares = np.linalg.inv(self.mounting.assumed)
        names = ("forwardShares", "rightShares", "downShares")
        return {
            **_name_elements("gyroBias", self.calibrated_bias),
            **{
                k: v
                for n, row in zip(names, shares, strict=True)
                for k, v in _name_elements(n, row).items()
            },
        }


def draw_unit(imu: Imu, count: int, seed: int | np.random.SeedSequence) -> Unit:
    """Draw the unit that `Imu.measure` draws for this count and seed. Only the noise of its
    accelerometers is another one.

    Raises:
        HrgError: gyros without an FMU, or an error of the accelerometers that their FMU has not.
    """
    if not isinstance(imu.gyros, FmuGyros):
        raise HrgError(
            f"{imu.name}: its gyros are stated by their errors; expected gyros of a device, "
            "such as those of typical-hrg"
        )
    _check_accelerometers(imu)
    generator = np.random.default_rng(seed)
    mounting, aside = imu.draw_mounting(seed)
    benches = imu.gyros.draw(generator)
    gyros = []
    for bench in benches:
        parameters, gyro_seed, angle = bench.draw_power_on(FLIGHT)
        gyros.append({**parameters, "startAngle": angle, "seed": gyro_seed})
    bias = [calibrate_mean_bias(each) if imu.gyros.calibrated else 0.0 for each in benches]
    accelerometers = _draw_accelerometers(imu.accelerometers, count, generator)
    accelerometers |= {"samplePeriod": imu.interval, "seed": int(aside.integers(2**31))}
    first, second, third = gyros
    return Unit((first, second, third), mounting, np.array(bias), accelerometers)


def _check_accelerometers(imu: Imu) -> None:
    for name in ("bias_instability", "quantization_step"):
        if getattr(imu.accelerometers, name):
            raise HrgError(
                f"{imu.name}: accelerometers: {name.replace('_', ' ')} found, expected none: the "
                "FMU of the accelerometers has bias, scale factor, misalignment and random walk"
            )


def _draw_accelerometers(
    model: SensorErrorModel, count: int, generator: np.random.Generator
) -> Values:
    bias, _, sensitivity = model.draw((count, 3), generator)
    return {
        **_name_elements("bias", bias),
        **_name_elements("scaleFactor", np.diag(sensitivity) - 1.0),
        **_name_elements("misalignment", sensitivity[OFF_DIAGONAL]),
        "randomWalk": model.random_walk,
    }


def _name_elements(name: str, values: Array) -> Values:
    return {f"{name}[{i}]": float(value) for i, value in enumerate(values, 1)}
