"""Replays with `HRG`, whose loops run at 1 kHz."""

from collections.abc import Sequence

from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.fmu import CONTROL_PERIOD, GyroFmu
from pyhrg.gap.replay.inputs.inputs import ReplayInputs
from pyhrg.gap.replay.observations import FINE_ROW
from pyhrg.gap.replay.recorder import scale_channels
from pyhrg.gap.replay.replay import replay_together

STEPS_PER_ROW = 100
"""Communication steps of the sampled gyro in a row, where the row has so many control periods.
Chosen."""
SHORT_TEST = 60.0
"""Longest test with rows shorter than `FINE_ROW`, s, that always runs with sampled loops.
Chosen."""


def replay_sampled(fmu: GyroFmu, device: Device, inputs: ReplayInputs) -> dict[str, Array]:
    """A replay with sampled loops."""
    return replay_sampled_together(fmu, [device], inputs)[0]


def replay_sampled_together(
    fmu: GyroFmu, devices: Sequence[Device], inputs: ReplayInputs
) -> list[dict[str, Array]]:
    """`replay_sampled` of several devices."""
    step = choose_sampled_step(inputs.log.interval)
    answers = replay_together(fmu, [(device, inputs) for device in devices], step)
    return [scale_channels(*pair) for pair in zip(answers, devices, strict=True)]


def choose_sampled_step(interval: float, steps: int = STEPS_PER_ROW) -> float:
    """Communication step of about so many in a row, a whole number of control periods, s."""
    periods = round(interval / CONTROL_PERIOD)
    each = next(n for n in range(max(periods // steps, 1), 0, -1) if periods % n == 0)
    return each * CONTROL_PERIOD


def is_short(rows: int, interval: float) -> bool:
    """Whether a test of so many rows, of an interval in s, always runs with sampled loops."""
    return interval < FINE_ROW and rows * interval <= SHORT_TEST
