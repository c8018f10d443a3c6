"""Errors of an IMU's gyros by the causes that their device files state.

`HRGSlow` replays the flight's motion with the gyros as they are, and once more without each error,
with the same random numbers. The difference of the two records is the signal of that error.
"""

import math
from dataclasses import dataclass, replace

import numpy as np

from fmu_build.bundle import build_fmu
from ins_eval.error_model.decomposition import sum_over_steps
from ins_eval.imu.gyros import FmuGyros
from ins_eval.imu.imu import Imu
from ins_eval.imu.mounting import Mounting
from pyhrg.common.arrays import Array
from pyhrg.device.causes import list_causes
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.records.imu.log import Increments

LONGEST_PERIOD = 0.5
"""Longest sample period of `HRGSlow`, s. Chosen: that of the linear model's steps. Against 0.05 s
the budget of `typical-hrg` changes by 1 m of 3218 in an hour of weaving, by 0.01 m of 2389 in the
car."""
MISALIGNMENT = "gyro misalignment (error_sigma_arcsec)"
HELD_FORCES = "forces held for a control period (control_period_s)"
"""Name of what a gyro without any stated error has."""
OWN_FMU = "own FMU (--fmu)"
"""Name of what gyros of a user's FMU have beyond those of `HRGSlow` with the same parameters."""
TOGETHER = "together"
"""Name of what the errors make together, beyond the sum of each."""
ROUNDING = 1e-9
"""Largest increment that is rounding, over the largest error."""


def replay_causes(
    imu: Imu, gyros: FmuGyros, truth: Increments, seed: int, start: float, step: float
) -> dict[str, Increments]:
    """Errors (measured less true) of the gyros without noise, by cause; their sum is that of all.

    gyros: those of the IMU; truth: from power-on, at the IMU's interval; seed: of the unit
    (`Imu.measure`); start, step: of the linear model, whose steps are whole sample periods, s.
    """
    mounting, _ = imu.draw_mounting(seed)
    coarse = _coarsen(truth, start, step)
    replay = _Replay(GyroFmu(build_fmu("HRGSlow")), coarse, mounting, seed)
    whole = replay.measure_error(gyros)
    parts, ideal = {}, gyros
    for cause in list_causes(gyros.stated_devices):
        parts[str(cause)] = whole - replay.measure_error(gyros.change(cause.remove))
        ideal = ideal.change(cause.remove)
    parts[HELD_FORCES] = replay.measure_error(ideal)
    beyond = whole - sum(parts.values())
    if np.max(np.abs(beyond)) > ROUNDING * np.max(np.abs(whole)):
        parts[TOGETHER] = beyond
    if gyros.fmu is not None:
        parts[OWN_FMU] = _measure_own_error(gyros, truth, coarse, mounting, seed) - whole
    signals = {name: mounting.decode(part) for name, part in parts.items()}
    if imu.mounting_deviation:
        turned = mounting.decode(mounting.project(coarse.rotation))
        signals[MISALIGNMENT] = turned - coarse.rotation
    return {
        name: Increments(coarse.interval, rotation, np.zeros_like(rotation), coarse.start)
        for name, rotation in signals.items()
    }


def _measure_own_error(
    gyros: FmuGyros, truth: Increments, coarse: Increments, mounting: Mounting, seed: int
) -> Array:
    """(n, 3) as `_Replay.measure_error`, of the gyros' own FMU; coarse: steps of the result."""
    quiet = gyros.change(lambda device: replace(device.without_noise(), quantization_step=0.0))
    error = _measure_error(quiet, truth, mounting, seed)
    fine = Increments(truth.interval, error, np.zeros_like(error), truth.start)
    return sum_over_steps(fine, coarse.start, coarse.interval, len(coarse)).rotation


def _measure_error(
    gyros: FmuGyros, truth: Increments, mounting: Mounting, seed: int, step: float = 0.0
) -> Array:
    """(n, 3) increments about the input axes less the true ones, rad, of gyros of a seed that
    vibrate at full amplitude from the beginning; step: of their FMU, s, 0 for the usual one."""
    drawn = replace(gyros, start_up=False).draw(np.random.default_rng(seed))
    benches = [replace(bench, step=step or bench.step) for bench in drawn]
    return gyros.record(benches, truth, mounting).rotation - mounting.project(truth.rotation)


@dataclass(frozen=True)
class _Replay:
    """The gyros of one seed on a motion; fmu: `HRGSlow`; truth: over its sample periods."""

    fmu: GyroFmu
    truth: Increments
    mounting: Mounting
    seed: int

    def measure_error(self, gyros: FmuGyros) -> Array:
        """(n, 3) increments about the input axes less the true ones, rad."""
        slow = replace(gyros.change(self._slow_down), fmu=self.fmu)
        return _measure_error(slow, self.truth, self.mounting, self.seed, self.truth.interval)

    def _slow_down(self, device: Device) -> Device:
        """The device without noise, and without parameters that `HRGSlow` doesn't have."""
        known = self.fmu.references.keys()
        quiet = device.without_noise()
        model = {name: value for name, value in quiet.model.items() if name in known}
        scatter = {name: size for name, size in device.turn_on_scatter.items() if name in known}
        return replace(
            quiet,
            quantization_step=0.0,
            turn_on_scatter=scatter,
            model={**model, "samplePeriod": self.truth.interval},
        )


def _coarsen(truth: Increments, start: float, step: float) -> Increments:
    """Increments over sample periods that fill a second and the linear model's steps."""
    second = round(1 / truth.interval)
    both = math.gcd(second, round(step / truth.interval))
    longest = LONGEST_PERIOD / truth.interval
    each = max(n for n in range(1, both + 1) if both % n == 0 and n <= max(longest, 1))
    skipped = round((start - truth.start) / truth.interval) % each
    first = truth.start + skipped * truth.interval
    return sum_over_steps(truth, first, each * truth.interval, (len(truth) - skipped) // each)
