"""Changes of a gyro from calibration to flight: age, another power-on, warming after it."""

import math
from dataclasses import dataclass, replace

import numpy as np

from ins_eval.mission_model.signals import compute_case_warmth
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.common.units import YEAR
from pyhrg.device.device import Device

AGEING_SHARE = 0.02
"""Standard deviation of each mechanism's change in a year, as a share of its size; it grows with
the root of time. Chosen."""
LARGEST_LEAKAGE = 0.05
"""Largest share of the decay time that is lost in a year. Chosen."""


@dataclass(frozen=True)
class Drift:
    """Distribution of what happens between calibration and flight.

    Attributes:
        age: time from calibration to flight, s.
        coolest, warmest: bounds of the final rise of the case's temperature above that of the
            calibration, K; uniform between them (`warming`).
    """

    age: float = YEAR / 2
    coolest: float = 2.0
    warmest: float = 15.0

    def __post_init__(self) -> None:
        if not (0 <= self.age < math.inf and 0 <= self.coolest <= self.warmest < math.inf):
            raise HrgError(
                f"found {self.age:g} s of age and {self.coolest:g} to {self.warmest:g} K of "
                "warming, expected 0 or more, the smaller first"
            )


@dataclass(frozen=True)
class Flight:
    """One gyro in one flight.

    Attributes:
        device: the gyro in this power-on, at the calibration's temperature.
        rise: final rise of the gyro's temperature above the calibration's, K.
        power_on_angle: pattern angle at power-on, rad.
    """

    device: Device
    rise: float
    power_on_angle: float

    def case_temperature(self, time: Array) -> Array:
        """Temperature of the case, K, at times since alignment, s."""
        return self.device.reference_temperature + self.rise * compute_case_warmth(time)


def draw_flight(device: Device, drift: Drift, generator: np.random.Generator) -> Flight:
    """A calibrated gyro in a flight: aged, powered on once more. Its pattern starts
    normally distributed about `power_on_angle`, as on the bench."""
    old = age_gyro(device, drift.age, generator)
    rise = generator.uniform(drift.coolest, drift.warmest)
    angle = old.power_on_angle + generator.normal(0.0, old.power_on_scatter)
    parameters = old.draw_turn_on(generator)
    drawn = {name: parameters[name] for name in old.turn_on_scatter}
    return Flight(
        device=replace(old, model={**old.model, **drawn}, turn_on_scatter={}),
        rise=rise,
        power_on_angle=angle,
    )


def age_gyro(device: Device, age: float, generator: np.random.Generator) -> Device:
    """A gyro after some time, s: damping and electrode errors change as vectors, and leaking gas
    shortens the decay time."""
    share = AGEING_SHARE * np.sqrt(age / YEAR)

    def wandered(cosine: float, sine: float) -> tuple[float, float]:
        step = generator.normal(0.0, share * np.hypot(cosine, sine), 2)
        return cosine + float(step[0]), sine + float(step[1])

    axis = 4 * device.damping_axis
    d = device.damping_anisotropy
    damping = wandered(d * np.cos(axis), d * np.sin(axis))
    pickoff = wandered(device.pickoff_gain_mismatch, device.pickoff_nonorthogonality)
    drive = wandered(device.drive_gain_mismatch, device.drive_nonorthogonality)
    return replace(
        device,
        decay_time=device.decay_time * (1 - generator.uniform(0.0, LARGEST_LEAKAGE) * age / YEAR),
        damping_anisotropy=float(np.hypot(*damping)),
        damping_axis=float(np.arctan2(damping[1], damping[0])) / 4,
        pickoff_gain_mismatch=pickoff[0],
        pickoff_nonorthogonality=pickoff[1],
        drive_gain_mismatch=drive[0],
        drive_nonorthogonality=drive[1],
    )
