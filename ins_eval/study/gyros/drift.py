"""From calibration to flight: age, another power-on, and warming up after it."""

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ins_eval.mission_model.warming import case_warmth
from pyhrg.common.units import YEAR
from pyhrg.device.device import Device

Array = NDArray[np.float64]

AGEING = 0.02
"""Of each mechanism's own size in a year, 1 sigma; grows with the root of time."""
LEAKAGE = 0.05
"""Of the decay time that is lost in a year at most."""


@dataclass(frozen=True)
class Drift:
    """age: time from calibration to flight, s; coolest, warmest: rise of the case after
    power-on above the calibration's temperature, K, uniform between them (`warming`)."""

    age: float = YEAR / 2
    coolest: float = 2.0
    warmest: float = 15.0

    def __post_init__(self) -> None:
        if not (0 <= self.age < math.inf and 0 <= self.coolest <= self.warmest < math.inf):
            raise ValueError(
                f"found {self.age:g} s of age and {self.coolest:g} to {self.warmest:g} K of "
                "warming, expected 0 or more, the least first"
            )


@dataclass(frozen=True)
class Flight:
    """One gyro in one flight.

    device: as it is in this power-on, at the calibration's temperature;
    rise: of its temperature in the end, K; power_on_angle: of its pattern, rad.
    """

    device: Device
    rise: float
    power_on_angle: float

    def case_temperature(self, time: Array) -> Array:
        """K; time: s since alignment."""
        return self.device.reference_temperature + self.rise * case_warmth(time)


def flight(device: Device, drift: Drift, generator: np.random.Generator) -> Flight:
    """What a calibrated gyro is in a flight: aged, turned on once more, from any angle."""
    old = aged(device, drift.age, generator)
    rise = generator.uniform(drift.coolest, drift.warmest)
    angle = generator.uniform(0.0, np.pi)
    parameters = old.turned_on(generator)
    drawn = {name: parameters[name] for name in old.turn_on_scatter}
    return Flight(
        device=replace(old, model={**old.model, **drawn}, turn_on_scatter={}),
        rise=rise,
        power_on_angle=angle,
    )


def aged(device: Device, age: float, generator: np.random.Generator) -> Device:
    """A gyro after some time, s: damping and electrodes wander as vectors, gas leaks in."""
    share = AGEING * np.sqrt(age / YEAR)

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
        decay_time=device.decay_time * (1 - generator.uniform(0.0, LEAKAGE) * age / YEAR),
        damping_anisotropy=float(np.hypot(*damping)),
        damping_axis=float(np.arctan2(damping[1], damping[0])) / 4,
        pickoff_gain_mismatch=pickoff[0],
        pickoff_nonorthogonality=pickoff[1],
        drive_gain_mismatch=drive[0],
        drive_nonorthogonality=drive[1],
    )
