"""Input columns that a log lacks, as they are on a gyro at rest."""

from dataclasses import replace
from typing import Any

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.site import EARTH_RATE
from pyhrg.device.device import Device
from pyhrg.records.columns import BY_FIELD, LogError
from pyhrg.records.log import Log
from pyhrg.records.table import ABSENT_COLUMN

TURNING_RATE = 10 * EARTH_RATE
"""Mean rate of the output over `TURNING_TIME` above which the gyro turned, rad/s. Chosen: Earth's
rate with a bias of 130 deg/h is still rest."""
TURNING_TIME = 10.0
"""Time over which the rate is taken, s. Chosen: noise of the angle is then far below the rate."""


def find_turning_times(log: Log) -> Array:
    """Times, s, at which the gyro's output turned faster than that of any gyro at rest."""
    rows = round(np.ceil(TURNING_TIME / log.interval))
    turned = np.abs(log.gyro_angle[rows:] - log.gyro_angle[:-rows])
    passed = log.time[rows:] - log.time[:-rows]
    return log.time[rows:][turned > TURNING_RATE * passed]


def turns(log: Log) -> bool:
    """Whether the table turned: the gyro's output does so with the drive on. With the drive off the
    pattern turns by itself."""
    driven = np.where(log.is_free, np.nan, log.gyro_angle)
    return len(find_turning_times(replace(log, gyro_angle=driven))) > 0


def note_missing_inputs(*fields: str) -> str:
    """The sentence on input columns that a log lacks."""
    names = ", ".join(BY_FIELD[field].name for field in fields)
    return f"{names}: missing, taken as on a gyro at rest"


def add_missing_inputs(
    log: Log, nominal: Device, without: tuple[str, ...] = ()
) -> tuple[Log, list[str]]:
    """The log with the input columns that it lacks as on the nominal device at rest, and sentences
    that name them in place of the log's own notes; `axis_up` is taken from the specific force along
    z.

    Fields in `without` stay as they are.

    Raises:
        LogError: neither `axis_up` nor the specific force along z has a value.
    """
    notes = []
    gravity = nominal.site.gravity
    if not log.has_values("axis_up"):
        if not log.has_values("acceleration_z"):
            raise LogError(f"{log.source}: columns axis_up and accel_z_m_s2 missing; expected one")
        log = replace(log, axis_up=np.clip(np.round(log.acceleration_z / gravity, 2), -1, 1))
        notes.append("axis_up: missing, taken from accel_z_m_s2")
    ones = np.ones(len(log.time))
    defaults = {
        "table_angle": 0 * ones,
        "virtual_rotation": 0 * ones,
        "amplitude_setpoint": nominal.amplitude * ones,
        "phase_offset": 0 * ones,
        "drive_on": ones,
        "temperature": nominal.reference_temperature * ones,
        "acceleration_x": gravity * np.sqrt(np.clip(1 - log.axis_up**2, 0, None)),
        "acceleration_y": 0 * ones,
        "acceleration_z": gravity * log.axis_up,
    }
    missing = [f for f in defaults if f not in without and not log.has_values(f)]
    added: dict[str, Any] = {field: defaults[field] for field in missing}
    if added:
        notes.append(note_missing_inputs(*added))
    absent = {ABSENT_COLUMN + BY_FIELD[field].name for field in (*added, "axis_up")}
    kept = tuple(note for note in log.exclusions if note not in absent)
    return replace(log, **added, exclusions=kept), notes
