"""Gyros that feel specific force, and the closed forms of their bias."""

from dataclasses import replace

import numpy as np

from benchmarks.intervals._environment import FAST
from pyhrg.common.units import DEG_PER_H, STANDARD_GRAVITY
from pyhrg.device.device import Device
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.theory import closed_forms as theory


def feeling(generator: np.random.Generator, gain: float, square: float) -> Device:
    """Random sensitivities: of the force frame, of the gains (s2/m) and their squares (s4/m2)."""
    unit = 0.005 * DEG_PER_H / STANDARD_GRAVITY
    device = TYPICAL.another(generator)
    turn = 2 * device.bryan_factor * device.decay_time
    bias, gains = unit * generator.standard_normal(3), gain * generator.standard_normal(3)
    squares = square * generator.standard_normal(3)
    model = {f"drive.rotationPerAcceleration[{i + 1}]": -turn * bias[i] for i in range(2)}
    model |= FAST
    model |= {f"pickOff.gainPerAcceleration[{i + 1}]": gains[i] for i in (1, 2)}
    model |= {f"pickOff.gainPerAccelerationSquared[{i + 1}]": squares[i] for i in range(3)}
    return replace(
        device,
        bias_per_acceleration=bias[2],
        pickoff_gain_per_acceleration=gains[0],
        model=model,
    )


def linear(device: Device) -> dict[str, float]:
    """Coefficients of specific force: of the mean over the circumference, and of sin 4th."""
    turn = 2 * device.bryan_factor * device.decay_time
    rotation = [device.model[f"drive.rotationPerAcceleration[{i + 1}]"] for i in range(2)]
    gains = [
        device.pickoff_gain_per_acceleration,
        *(device.model[f"pickOff.gainPerAcceleration[{i + 1}]"] for i in (1, 2)),
    ]
    means = dict(
        zip("xyz", [-e / turn for e in rotation] + [device.bias_per_acceleration], strict=True)
    )
    return {
        "bias": theory.mean_bias(device),
        **{f"g bias {axis}": value for axis, value in means.items()},
        **{f"g bias {a} sin4": g / (2 * turn) for a, g in zip("xyz", gains, strict=True)},
    }


def squares(device: Device) -> list[float]:
    """Coefficients of sin 4th by the square of specific force along x, y, z."""
    turn = 2 * device.bryan_factor * device.decay_time
    name = "pickOff.gainPerAccelerationSquared"
    return [device.model[f"{name}[{i + 1}]"] / (2 * turn) for i in range(3)]
