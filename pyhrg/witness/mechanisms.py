"""Mechanisms that make the bias map and may have changed since the calibration.

Each is one number that is added to a device. An anisotropy has two: a cosine and a sine. A quantity
that a bench knows well is a number of its own. So the damping anisotropy's change per kelvin is
one, and not the share of an anisotropy that the bench confounds with the drives.
"""

import cmath
import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Literal, get_args

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.device.device import Device

Signal = Literal["one", "temperature rate", "force across", "force along"]
"""Signal that a mechanism acts in proportion to: constant; rate of the case's temperature, K/s;
specific force along the x electrodes or along the input axis, m/s^2."""
SIGNALS: tuple[Signal, ...] = get_args(Signal)


@dataclass(frozen=True)
class Mechanism:
    """A number of a device that may have changed.

    Attributes:
        name: name in reports.
        step: size of the change by which sensitivities are taken, SI: far above the rounding of the
            simulation, and so small that the response is linear to 1e-3.
        read: function that reads the mechanism's value from a device.
        add: function that gives the device with a change of the mechanism.
        signal: signal that the mechanism acts in proportion to.
    """

    name: str
    step: float
    read: Callable[[Device], float]
    add: Callable[[Device, float], Device]
    signal: Signal = "one"


def _name_field(name: str, step: float, field: str, signal: Signal = "one") -> Mechanism:
    def add(device: Device, change: float) -> Device:
        return replace(device, **{field: getattr(device, field) + change})

    return Mechanism(name, step, lambda device: getattr(device, field), add, signal)


def _read_damping(device: Device) -> complex:
    return cmath.rect(device.damping_anisotropy, 4 * device.damping_axis)


def _add_damping(direction: complex) -> Callable[[Device, float], Device]:
    """A change of the damping anisotropy along the cosine (1) or the sine (i) of four angles; its
    change per kelvin keeps its size."""

    def add(device: Device, change: float) -> Device:
        whole = _read_damping(device) + change * direction
        changed = replace(
            device, damping_anisotropy=abs(whole), damping_axis=cmath.phase(whole) / 4
        )
        return _set_warm_damping(changed, _read_warm_damping(device))

    return add


def _read_warm_damping(device: Device) -> float:
    return device.damping_anisotropy * device.damping_anisotropy_per_kelvin


def _set_warm_damping(device: Device, per_kelvin: float) -> Device:
    """The device whose damping anisotropy changes by so much per kelvin, 1/(s K), if it has one."""
    size = device.damping_anisotropy
    return replace(device, damping_anisotropy_per_kelvin=per_kelvin / size) if size else device


def _add_warm_damping(device: Device, change: float) -> Device:
    return _set_warm_damping(device, _read_warm_damping(device) + change)


def _stretch_decay_time(device: Device, change: float) -> Device:
    return replace(device, decay_time=device.decay_time * math.exp(change))


MECHANISMS = (
    Mechanism("damping anisotropy, cosine", 1e-6, lambda d: _read_damping(d).real, _add_damping(1)),
    Mechanism("damping anisotropy, sine", 1e-6, lambda d: _read_damping(d).imag, _add_damping(1j)),
    _name_field("pick-off gain mismatch", 1e-4, "pickoff_gain_mismatch"),
    _name_field("pick-off non-orthogonality", 1e-4, "pickoff_nonorthogonality"),
    _name_field("drive gain mismatch", 1e-4, "drive_gain_mismatch"),
    _name_field("drive non-orthogonality", 1e-4, "drive_nonorthogonality"),
    Mechanism("decay time, relative", 1e-3, lambda d: math.log(d.decay_time), _stretch_decay_time),
    _name_field("drive frame rotation", 1e-4, "drive_frame_rotation"),
    _name_field("phase error", 1e-4, "phase_error"),
    _name_field("residual quadrature", 1e-4, "residual_quadrature"),
    _name_field("decay time per kelvin", 1e-4, "decay_time_per_kelvin"),
    Mechanism("damping anisotropy per kelvin", 1e-9, _read_warm_damping, _add_warm_damping),
    _name_field("pick-off gain per kelvin", 1e-6, "pickoff_gain_per_kelvin"),
    _name_field("phase error per kelvin", 1e-5, "phase_per_kelvin"),
    _name_field("pick-off cubic", 1e-4, "pickoff_cubic"),
    _name_field(
        "bias per rate of temperature", 1e-6, "bias_per_temperature_rate", "temperature rate"
    ),
    _name_field(
        "pick-off gain per specific force", 1e-5, "pickoff_gain_per_acceleration", "force across"
    ),
    _name_field("bias per specific force", 1e-8, "bias_per_acceleration", "force along"),
)
"""The states of the estimate, in this order."""
NAMES = tuple(each.name for each in MECHANISMS)
COUNT = len(MECHANISMS)
FOLLOWED = np.array([SIGNALS.index(each.signal) for each in MECHANISMS])
"""Place among `SIGNALS` of what each mechanism acts in proportion to."""
STEADY = SIGNALS.index("one") == FOLLOWED
"""Which mechanisms act always."""
TEMPERATURE_RATE = SIGNALS.index("temperature rate") == FOLLOWED
"""Which mechanisms act by the rate of the case's temperature."""
ALONG = SIGNALS.index("force along") == FOLLOWED
"""Which mechanisms act by the specific force along the input axis."""
CHANGING = SIGNALS.index("force across") == FOLLOWED
"""Which mechanisms act on pick-offs as a signal changes."""
THERMAL = np.array(["per kelvin" in name for name in NAMES])
"""Which mechanisms act by the temperature of the resonator above the reference."""


def find(name: str) -> int:
    """Place of a mechanism among the states."""
    return NAMES.index(name)


def read_values(device: Device) -> Array:
    """(COUNT,) values of a device's mechanisms, SI."""
    return np.array([each.read(device) for each in MECHANISMS])


def change_device(device: Device, changes: Array) -> Device:
    """The device with changes (COUNT,) of its mechanisms, SI."""
    for mechanism, change in zip(MECHANISMS, changes.tolist(), strict=True):
        device = mechanism.add(device, change)
    return device
