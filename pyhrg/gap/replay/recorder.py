"""What another recorder makes of the same outputs: it reads late, counts from another frequency, or
has wrong scales (docs/methods/replay.md, "Rows that are compared")."""

from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from typing import Any

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.records import Log

ANGLES = ("gyro_angle", "wave_angle")
"""Fields of a log that are read at the end of a row."""
SCALES = {
    "amplitude": "amplitude_scale",
    "amplitude_force": "amplitude_force_scale",
    "quadrature_force": "quadrature_force_scale",
}
"""Field of a device that states the relative error of a recorded channel."""
CLOCK_FIELDS = ("clock_latency", "clock_rate")
"""Fields of a device that state by how much later angles are read."""


def list_read_out_fields(log: Log) -> tuple[str, ...]:
    """Fields of a device that change what a recorder reads of this test, and not what the gyro
    does. A pattern that is turned by command starts elsewhere if its angle was read later."""
    clock = () if log.virtual_rotation.any() else CLOCK_FIELDS
    return ("frequency_error", "amplitude_latency", *SCALES.values(), *clock)


def read_change(rows: Mapping[str, Array], old: Device, new: Device, log: Log) -> dict[str, Array]:
    """(n,) by field of a log: what another recorder makes of the same outputs. It reads angles
    or the amplitude later, and counts the frequency from another one."""
    late = new.clock_latency - old.clock_latency + (new.clock_rate - old.clock_rate) * log.time
    change = {name: np.zeros(len(log.time)) for name in rows}
    for name in ANGLES if late.any() else ():
        change[name] = late * np.gradient(rows[name], log.interval)
    later = new.amplitude_latency - old.amplitude_latency
    if later:  # the slope before the reading, as the drive may go off at the row's end
        change["amplitude"] = later * np.diff(rows["amplitude"], prepend=rows["amplitude"][0])
        change["amplitude"] /= log.interval
    detuned = (rows["frequency_offset"] - old.frequency_error) / (
        old.frequency_error + new.frequency
    )
    change["frequency_offset"] += (new.frequency_error - old.frequency_error) * (1 + detuned)
    return change


def scale_channels(values: Mapping[str, Array], device: Device) -> dict[str, Array]:
    """Values by channel as a device's recorder reads them, whose channels have wrong scales."""
    scales = {name: 1 + getattr(device, field) for name, field in SCALES.items()}
    return {name: own * scales.get(name, 1.0) for name, own in values.items()}


def list_scale_steps(old: Device, new: Device) -> dict[str, float]:
    """Change of each channel's scale from one device to another, without those that are the
    same."""
    steps = {name: getattr(new, own) - getattr(old, own) for name, own in SCALES.items()}
    return {name: step for name, step in steps.items() if step}


@lru_cache(maxsize=16)
def take_out_scales(device: Device) -> Device:
    """The device with exact scales of its channels; the same object for equal devices."""
    exact: dict[str, Any] = dict.fromkeys(SCALES.values(), 0.0)
    return replace(device, **exact)
