"""Noise-free answers of a device to observed tests, by the two fidelities that a replay needs."""

import math
from collections import OrderedDict
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from pyhrg.device.device import Device
from pyhrg.fmu import CONTROL_PERIOD, GyroFmu
from pyhrg.gap.replay.loop_response import followed, let_go
from pyhrg.gap.replay.observations import (
    CHANNELS,
    COARSE_STEP,
    FINE,
    FORCES,
    Mask,
    Observed,
    settling,
)
from pyhrg.gap.replay.replay import Replayable, replayed

Array = NDArray[np.float64]
Answers = Mapping[str, Array]

ANGLES = ("gyro_angle", "wave_angle")
FAST_STEPS = 100
"""Steps that a row is made of where it is long enough."""
SLOW_STEP = 0.1
"""Step of the gyro with quasi-steady loops, s."""
SHIFT = 1e-3
"""Of the pattern, rad, to either side, by which slopes and curvatures are taken."""
FINE_STEPS = 5
"""In a row that is shorter than `FINE`: a gyro with loops at rest lags by three of them."""
SHORT = 60.0
"""Tests of such rows that are no longer, s, show how loops follow: they always run in these."""
LEAST_SHIFT = 0.5
"""Of a shift of the start angle that must be left for a slope to be told by it."""
SMALL_LAG = 1e-9
"""Of the phase, that is none, rad."""
MOSTLY = 0.5
"""Share of rows in which loops move beyond which they run in all."""
KEPT = 1_000_000
"""Rows of simulations that may be asked for again."""


@dataclass(frozen=True)
class OverAngle:
    """How answers change with the pattern's present angle, (n,) by channel; that of the output
    angle with the start angle: what a bias that depends on the angle makes of a shift, over the
    Bryan factor.

    slopes: per rad.
    curvatures: per rad^2.
    """

    slopes: Mapping[str, Array]
    curvatures: Mapping[str, Array]

    def bent(self, channel: str, angle: Array) -> Array:
        """(n,) change of a channel when the pattern turns by angles, rad, beyond the linear one."""
        return np.asarray(self.curvatures[channel] * angle**2 / 2)


@dataclass(frozen=True)
class Simulation:
    """Both fidelities of the gyro.

    sampled: `HRG`.
    quasi_steady: `HRGSlow`.
    """

    sampled: GyroFmu
    quasi_steady: GyroFmu
    _kept: OrderedDict[tuple[int, int, float], tuple[Device, Replayable, Answers]] = field(
        default_factory=OrderedDict, init=False, repr=False, compare=False
    )

    def model(self, rows: int, interval: float) -> GyroFmu:
        """The plainest model that shows all that a test of so many rows, of an interval in s, can
        show of a small difference."""
        return self.sampled if is_short(rows, interval) else self.quasi_steady

    def answers(self, device: Device, test: Observed) -> dict[str, Array]:
        """(n,) by field: with running loops where they move through most of a test; else with
        loops that follow once they are at rest, and with what running ones make of the angles
        where they move.

        Raises:
            GyroError: parameters or inputs that the FMU refuses.
        """
        if np.mean(test.moving) > MOSTLY:
            return self._running(device, test.inputs)
        at_rest = self._lagging(device, test.inputs)
        moved = self._moved(at_rest, device, test)
        turned = moved["wave_angle"] - at_rest["wave_angle"]
        slopes = self.over_angle(device, test).slopes
        shifted = {name: slopes[name] * turned for name in CHANNELS if name not in ANGLES}
        return added(_led(moved, device, test), shifted)

    def _running(
        self, device: Device, inputs: Replayable, steps: int = FAST_STEPS
    ) -> dict[str, Array]:
        """With loops that run; what a row holds is held in steps of whole control periods."""
        periods = round(inputs.log.interval / CONTROL_PERIOD)
        each = next(n for n in range(max(periods // steps, 1), 0, -1) if periods % n == 0)
        return replayed(self.sampled, device, inputs, each * CONTROL_PERIOD)

    def _at_rest(self, device: Device, inputs: Replayable) -> dict[str, Array]:
        """With loops that follow."""
        return replayed(self.quasi_steady, device, inputs, SLOW_STEP)

    def _lagging(self, device: Device, inputs: Replayable) -> dict[str, Array]:
        """With loops that follow, that of the phase behind a frequency that drifts."""
        found = self._at_rest(device, inputs)
        drift = np.gradient(found["frequency_offset"], inputs.log.interval)
        lag = drift / device.phase_loop**2
        if np.abs(lag).max() < SMALL_LAG:
            return found
        log = replace(inputs.log, phase_offset=inputs.log.phase_offset - lag)
        return self._at_rest(device, replace(inputs, log=log))

    def _moved(self, at_rest: dict[str, Array], device: Device, test: Observed) -> dict[str, Array]:
        """Angles with what loops that run make of them beyond loops at rest, where they move."""
        left = {name: np.zeros(len(test.log.time)) for name in ANGLES}
        lead = math.ceil(settling(device) / test.log.interval)
        for rows in _stretches(test.moving, lead):
            begin = max(rows.start - lead, 0)
            angle = test.inputs.start_angle
            if begin:
                turned = at_rest["wave_angle"][begin - 1] + left["wave_angle"][begin - 1]
                angle = math.remainder(turned, math.pi)
            inputs = test.inputs.section(slice(begin, rows.stop), angle)
            running, resting = self._running(device, inputs), self._lagging(device, inputs)
            for name in ANGLES:
                apart = running[name] - resting[name]
                if rows.start:
                    apart -= apart[rows.start - begin - 1]
                left[name][rows] += apart[rows.start - begin :]
                left[name][rows.stop :] += apart[-1]
        return added(at_rest, left)

    def difference(self, low: Device, high: Device, test: Observed) -> dict[str, Array]:
        """(n,) by channel: answer of `high` less that of `low`, for devices that differ little.

        Raises:
            GyroError: as `answers`.
        """
        first, last = (self._coarse(device, test.inputs) for device in (low, high))
        return _apart(first, last, high, test)

    def changes(self, device: Device, test: Observed) -> Callable[[Device], dict[str, Array]]:
        """What gyros that differ little from a device, which is simulated once, answer beyond it.

        Raises:
            GyroError: as `answers`, here and when it is called.
        """
        first = self._coarse(device, test.inputs)
        return lambda other: _apart(first, self._simulated(other, test.inputs), other, test)

    def over_angle(self, device: Device, test: Observed) -> OverAngle:
        """How the answers change with the pattern's angle.

        Raises:
            GyroError: as `answers`.
        """
        low, middle, high = (self._coarse(device, test.inputs, s) for s in (-SHIFT, 0.0, SHIFT))
        below, above = (_apart(*ends, device, test) for ends in ((low, middle), (middle, high)))
        slopes = {name: (below[name] + above[name]) / (2 * SHIFT) for name in CHANNELS}
        grown = 1 - device.bryan_factor * slopes["gyro_angle"]
        is_told = grown > LEAST_SHIFT
        shift = np.where(is_told, grown, 1.0)
        now = {n: s if n == "gyro_angle" else s / shift for n, s in slopes.items()}
        bends = {name: (above[name] - below[name]) / SHIFT**2 for name in CHANNELS}
        turned = device.bryan_factor * np.where(is_told, bends["gyro_angle"], 0.0)
        return OverAngle(now, {n: (b + now[n] * turned) / shift**2 for n, b in bends.items()})

    def _coarse(self, device: Device, inputs: Replayable, shift: float = 0.0) -> Answers:
        """As `_simulated`, for a shift of the start angle, rad; the last ones are kept."""
        key = id(device), id(inputs), shift
        if key in self._kept:
            return self._kept[key][-1]
        shifted = replace(inputs, start_angle=inputs.start_angle + shift)
        found = self._simulated(device, shifted)
        self._kept[key] = device, inputs, found
        while sum(len(inputs.log.time) for _, inputs, _ in self._kept.values()) > KEPT:
            self._kept.popitem(last=False)
        return found

    def _simulated(self, device: Device, inputs: Replayable) -> dict[str, Array]:
        """With loops at rest unless all is over soon, in steps that do for small differences."""
        if is_short(len(inputs.log.time), inputs.log.interval):
            return self._running(device, inputs, FINE_STEPS)
        interval = inputs.log.interval
        step = interval / FINE_STEPS if interval < FINE else COARSE_STEP
        return replayed(self.quasi_steady, device, inputs, step)


def is_short(rows: int, interval: float) -> bool:
    """Whether loops run in all simulations of a test of so many rows, of an interval in s."""
    return interval < FINE and rows * interval <= SHORT


def _stretches(moving: Mask, apart: int) -> list[slice]:
    """Rows in which loops move, together where fewer than so many lie between."""
    where = np.flatnonzero(moving)
    parts = np.split(where, np.flatnonzero(np.diff(where) > apart) + 1)
    return [slice(int(part[0]), int(part[-1]) + 1) for part in parts]


def _apart(first: Answers, last: Answers, device: Device, test: Observed) -> dict[str, Array]:
    change = {name: last[name] - first[name] for name in CHANNELS}
    is_raw = is_short(len(test.log.time), test.log.interval)
    return change if is_raw else _led(change, device, test)


def added(answers: Answers, difference: Answers) -> dict[str, Array]:
    """Answers of a gyro that differs little from another."""
    return {name: values + difference.get(name, 0.0) for name, values in answers.items()}


def _led(answers: dict[str, Array], device: Device, test: Observed) -> dict[str, Array]:
    """Forces of loops at rest led through the loops' own response, and how far they let the
    amplitude go."""
    let = let_go(answers["amplitude_force"], device.amplitude_loop, test.log.interval)
    answers["amplitude"] = answers["amplitude"] - device.amplitude * let
    loops = (device.amplitude_loop, device.quadrature_loop)
    for name, frequency in zip(FORCES, loops, strict=True):
        answers[name] = followed(answers[name], frequency, test.log.interval)
    return answers
