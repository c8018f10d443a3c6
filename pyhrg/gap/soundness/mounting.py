"""Signs of a campaign's mounting: a table encoder, or an input axis, that counts the other way.

The slope of the gyro's angle over the table's gives the encoder's sign, and that of the gyro's rate
at rest over Earth's rate the sign of the axis. A sign is turned in all tests of a campaign.
"""

from collections.abc import Collection, Sequence

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG
from pyhrg.device.device import Device
from pyhrg.gap.soundness.exclusion import find_runs, replace_columns
from pyhrg.gap.soundness.fault import AXIS_SIGN, TABLE_SIGN, Fault
from pyhrg.records import Log
from pyhrg.records.columns import BY_FIELD

FIELDS = {TABLE_SIGN.parameter: "table_angle", AXIS_SIGN.parameter: "axis_up"}
"""Field of a log that each sign belongs to."""
MIN_TABLE_TURN = 10 * DEG
"""Path of the table over which a test tells the encoder's sign, rad. Chosen."""
TABLE_SLOPE_TOLERANCE = 0.05
"""Departure of a slope over the table from -1 up to which the encoder's sign explains it. Chosen:
that of a gyro's scale factor."""
AXIS_SLOPE_TOLERANCE = 0.2
"""Departure of a slope over Earth's rate from -1 up to which the axis' sign explains it. Chosen:
a bias of 2 deg/h at middle latitudes."""
SIGNIFICANCE_SIGMA = 5.0
"""A slope over Earth's rate counts from this many standard deviations on. Chosen."""
MIN_REST = 30.0
"""Shortest rest over which a rate is taken, s. Chosen."""
REST_TURN = 1e-5
"""Turn of the table in a row that counts as rest, rad. Chosen: 2 arcsec, above an encoder's
noise."""


def find_mounting_faults(logs: Sequence[Log], nominal: Device) -> list[Fault]:
    """Signs that are reversed in most of these logs."""
    faults = _check_table_sign(logs)
    turned = [mend_mounting(log, {fault.kind.parameter for fault in faults})[0] for log in logs]
    return [*faults, *_check_axis_sign(turned, nominal)]


def mend_mounting(log: Log, parameters: Collection[str]) -> tuple[Log, list[str]]:
    """A log with the fields of reversed signs turned, and a sentence on each; other parameters have
    no field of a log."""
    fields = [field for parameter, field in FIELDS.items() if parameter in parameters]
    notes = [
        f"{log.source}: column {BY_FIELD[f].name}: its sign is reversed: turned" for f in fields
    ]
    return replace_columns(log, {field: -getattr(log, field) for field in fields}), notes


def _check_table_sign(logs: Sequence[Log]) -> list[Fault]:
    """A fault if the encoder counts against the gyro in most tests that turn the table."""
    slopes = [slope for slope in map(_fit_table_slope, logs) if np.isfinite(slope)]
    negative = [slope for slope in slopes if abs(slope + 1) < TABLE_SLOPE_TOLERANCE]
    if 2 * len(negative) <= len(slopes):
        return []
    sigma = float(np.std(negative)) / np.sqrt(len(negative))
    return [Fault(TABLE_SIGN, float(np.mean(negative)), float(sigma))]


def _fit_table_slope(log: Log) -> float:
    """Slope of the gyro's steps from row to row over the table's, with the drive on; NaN where the
    table does not turn."""
    table, gyro = np.diff(log.table_angle), np.diff(log.gyro_angle)
    known = np.isfinite(table) & np.isfinite(gyro) & ~log.is_free[1:]
    table, gyro = table[known], gyro[known]
    if np.sum(np.abs(table)) < MIN_TABLE_TURN:
        return np.nan
    return float(table @ gyro / (table @ table))


def _check_axis_sign(logs: Sequence[Log], nominal: Device) -> list[Fault]:
    """A fault if the gyro's rate at rest is Earth's with the other sign.

    The rate is fitted by a slope and, where the attitude varies, a bias. A gyro's bias is far below
    Earth's rate, and does not follow the attitude.
    """
    rests = [rest for log in logs for rest in _list_rests(log)]
    if not rests:
        return []
    up, rate, duration = np.array(rests).T
    earth = nominal.site.compute_earth_rate(up)
    columns = [earth, np.ones(len(earth))] if np.ptp(up) else [earth]
    weight = np.sqrt(duration)
    design = weight[:, None] * np.column_stack(columns)
    if len(design) <= len(columns) or not earth.any():
        return []
    solution, *_ = np.linalg.lstsq(design, weight * rate)
    residual = weight * rate - design @ solution
    variance = float(residual @ residual) / (len(design) - len(columns))
    sigma = float(np.sqrt(variance * np.linalg.inv(design.T @ design)[0, 0]))
    slope = float(solution[0])
    is_reversed = abs(slope + 1) < AXIS_SLOPE_TOLERANCE and -slope > SIGNIFICANCE_SIGMA * sigma
    return [Fault(AXIS_SIGN, slope, sigma)] if is_reversed else []


def _list_rests(log: Log) -> list[tuple[float, float, float]]:
    """Projection of the axis, mean rate against the table, rad/s, and duration, s, of each rest of
    table and commands with the drive on."""
    if not log.has_values("axis_up", "gyro_angle"):
        return []
    table = log.table_angle if log.has_values("table_angle") else np.zeros(len(log.time))
    angle = log.gyro_angle - table
    still = np.isfinite(np.diff(angle)) & (np.diff(log.axis_up) == 0)
    still &= np.abs(np.diff(table)) < REST_TURN
    still &= ~log.is_free[1:] & (np.nan_to_num(log.virtual_rotation[1:]) == 0)
    return [
        (float(log.axis_up[first]), *_measure_rate(log.time, angle, first, end))
        for first, end in find_runs(still)
        if log.time[end] - log.time[first] >= MIN_REST
    ]


def _measure_rate(time: Array, angle: Array, first: int, last: int) -> tuple[float, float]:
    duration = float(time[last] - time[first])
    return float(angle[last] - angle[first]) / duration, duration
