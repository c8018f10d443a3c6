"""The drive lost for seconds while the log has it on: the amplitude decays as it rings down."""

import numpy as np

from pyhrg.common.arrays import Mask
from pyhrg.common.robust import estimate_robust_deviation
from pyhrg.device.device import Device
from pyhrg.gap.replay.observations import (
    ANGLE_RATE_LIMIT,
    compute_settling_time,
    find_command_changes,
    find_undisturbed_rows,
)
from pyhrg.gap.soundness.exclusion import find_runs, replace_columns
from pyhrg.records import Log

MIN_DIP_SIGMA = 20.0
"""Smallest dip of the amplitude, in standard deviations of its noise. Chosen."""
MIN_DIP = 1e-4
"""Smallest dip, in set points: that of a drive lost for a ten-thousandth of the decay time.
Chosen."""
DECAY_TOLERANCE = 1.3
"""Factor, either way, within which a dip is as deep as a ring-down over its rows. Chosen."""


def mend_drive(log: Log, nominal: Device) -> tuple[Log, list[str]]:
    """A log of complete inputs with the drive off in the rows in which it was lost, and a sentence
    on each interruption. Rows after it are compared again once the loops have settled."""
    lost = find_interruptions(log, nominal)
    notes = [
        f"{log.source}: the drive was lost at time_s {log.time[first] - log.interval:g} for about "
        f"{(end - first) * log.interval:g} s, though drive_on is 1: simulated so"
        for first, end in find_runs(lost)
    ]
    return replace_columns(log, {"drive_on": np.where(lost, 0.0, log.drive_on)}), notes


def find_interruptions(log: Log, nominal: Device) -> Mask:
    """(n,) rows in which the amplitude falls below a constant set point as in a ring-down, in two
    rows in succession at least. Only rows with a pattern at rest are searched: errors of the
    pick-offs make the amplitude of a turning pattern ripple."""
    lost = np.zeros(len(log.time), dtype=bool)
    with np.errstate(divide="ignore", invalid="ignore"):
        dip = 1 - log.amplitude / log.amplitude_setpoint
    settled = find_undisturbed_rows(log, find_command_changes(log), compute_settling_time(nominal))
    pattern_rate = np.abs(np.gradient(log.wave_angle, log.interval))
    settled &= np.isfinite(dip) & log.is_driven & (pattern_rate < ANGLE_RATE_LIMIT)
    if not settled.any():
        return lost
    dip = dip - np.median(dip[settled])
    least = max(MIN_DIP, MIN_DIP_SIGMA * estimate_robust_deviation(dip[settled]))
    for first, end in find_runs(settled & (dip > least)):
        lowest = first + int(np.argmax(dip[first:end]))
        rows = lowest - first
        least_rows, most_rows = rows / DECAY_TOLERANCE, (rows + 2) * DECAY_TOLERANCE
        decays = dip[lowest] * nominal.decay_time / log.interval
        if rows and least_rows < decays < most_rows:
            lost[first : lowest + 1] = True
    return lost
