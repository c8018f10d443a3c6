"""What of a campaign's logs is compared with the simulation: channels, and rows at rest."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.device.device import Device
from pyhrg.gap.replay.encoder import encoder_noise
from pyhrg.gap.replay.replay import HELD, Replayable, replayable
from pyhrg.records import Log
from pyhrg.records.campaign import Test

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

CHANNELS = (
    "gyro_angle",
    "amplitude",
    "amplitude_force",
    "quadrature_force",
    "frequency_offset",
)
"""Fields of a log that are compared. The wave angle says nothing that the output doesn't."""
FORCES = ("amplitude_force", "quadrature_force")
"""Zero while the drive is off."""
STEPS = ("drive_on", "virtual_rotation", "amplitude_setpoint", "phase_offset")
"""Commands whose change moves the loops, and by them the pattern."""
COMMANDS = ("axis_up", *(name for name in HELD if not name.startswith("acceleration")))
LEAST = 4.0
"""Time in which any change has settled at the earliest, s."""
CONSTANTS = 24
"""Time constants of the slowest loop after which a change is settled."""
STEADY = 1e-3
"""Change of the table's rate from row to row below which loops follow, rad/s^2."""
TURNED_OVER = 1.0
"""Change of specific force from row to row after which loops settle anew, m/s^2: they do where it
moves a gain."""
SLOW = 0.02
"""Rate of the table below which forces of loops at rest show how they follow, rad/s."""
STILL = 1e-3
"""Rate of the table below which nothing of the angle is lost by loops that lag, rad/s."""
OFFSET = 0.01
"""Of the phase, up to which loops at rest show what it does, rad."""
COARSE_STEP = 1.0
"""Longest step by which a small difference between two gyros with loops at rest is taken, s."""
COARSE_STEPS = 20
"""Steps in which quadrature has come to rest in such a gyro, but for 0.2 %."""
FINE = 0.2
"""Rows shorter than this show how loops follow, s; a gyro with sampled loops is replayed."""


@dataclass(frozen=True)
class Observed:
    """A test, its inputs, and which rows of each channel are compared.

    rows: (n,) by channel, where the angle is there too: it tells where the pattern was.
    moving: (n,) rows in which loops are not at rest: their replay needs loops that run.
    encoder: white noise of the table's angle, rad.
    """

    test: Test
    inputs: Replayable
    rows: Mapping[str, Mask]
    moving: Mask
    encoder: float

    @property
    def log(self) -> Log:
        """Its log."""
        return self.inputs.log


def settling(device: Device) -> float:
    """Time that loops take to settle after a command or a change of the table's rate, s."""
    slowest = min(device.amplitude_loop, device.quadrature_loop, device.phase_loop)
    return max(LEAST, CONSTANTS / slowest)


def observed(test: Test, believed: Device) -> Observed:
    """What a test has to compare.

    Args:
        test: with a log of complete inputs.
        believed: for the start angle, and the time that its loops take to settle.
    """
    log = test.log
    inputs = replayable(log, believed)
    moving = _moving(log, inputs, settling(believed))
    coarse = COARSE_STEPS * min(COARSE_STEP, log.interval)
    settled = _settled(log, inputs, max(settling(believed), coarse))
    rows = {}
    for name in CHANNELS:
        there = np.isfinite(getattr(log, name)) & np.isfinite(log.gyro_angle)
        if name != "gyro_angle":
            there &= settled
        if name in FORCES:
            there &= log.drive_on > 0
        rows[name] = there
    rows["temperature"] = np.isfinite(log.temperature)
    encoder = encoder_noise(log.table_angle, log.gyro_angle)
    return Observed(test, inputs, rows, moving, encoder)


def _moving(log: Log, inputs: Replayable, time: float) -> Mask:
    """(n,) rows; all of them where loops at rest don't show what the gyro does between changes."""
    away = (log.virtual_rotation != 0) | (log.drive_on <= 0) | (np.abs(log.phase_offset) > OFFSET)
    if log.interval < FINE or away.any():
        return np.ones(len(log.time), dtype=bool)
    moved = jolts(inputs) | _turns(inputs, STILL) | _begins(log, STEPS)
    return ~later(log, moved, time + log.interval)


def _settled(log: Log, inputs: Replayable, time: float) -> Mask:
    """(n,) rows in which loops at rest show what the gyro does."""
    changed = commanded(log)
    if log.interval >= FINE:
        changed |= jolts(inputs) | _turns(inputs, SLOW)
    return later(log, changed, time)


def _turns(inputs: Replayable, slow: float) -> Mask:
    """(n,) rows in which the table turns faster than this, rad/s."""
    rates = np.abs(inputs.table.rates)
    return np.asarray(np.maximum(rates[1:], rates[:-1]) > slow)


def _begins(log: Log, names: Sequence[str]) -> Mask:
    """(n,) rows in which one of these columns changes, and the first."""
    begins = np.zeros(len(log.time), dtype=bool)
    begins[0] = True
    for name in names:
        begins |= np.diff(getattr(log, name), prepend=getattr(log, name)[0]) != 0
    return begins


def commanded(log: Log) -> Mask:
    """(n,) rows in which a command or the attitude changes, and the first."""
    changed = _begins(log, COMMANDS)
    for axis in "xyz":
        force = getattr(log, f"acceleration_{axis}")
        changed |= np.abs(np.diff(force, prepend=force[0])) > TURNED_OVER
    return changed


def jolts(inputs: Replayable) -> Mask:
    """(n,) rows in which the table's rate changes."""
    changes = np.maximum(np.abs(np.diff(inputs.table.rates)), np.abs(inputs.table.swells))
    return np.asarray(changes / inputs.log.interval > STEADY)


def later(log: Log, changed: Mask, time: float) -> Mask:
    """(n,) rows that no change precedes by less than a time, s."""
    last = np.maximum.accumulate(np.where(changed, log.time, -np.inf))
    return np.asarray(log.time - last >= time)
