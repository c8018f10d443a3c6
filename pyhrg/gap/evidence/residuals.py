"""What is left of the records when effects and elements of stated sizes are taken out."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from pyhrg.device.device import Device
from pyhrg.gap.effects import candidate_terms as unknown
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.design import Group, LinearTest
from pyhrg.gap.effects.jump import Jump
from pyhrg.gap.replay.observations import CHANNELS, Mask
from pyhrg.gap.whitening.channel_noise import ChannelNoise
from pyhrg.gap.whitening.whitening import SlowNoise, whitened
from pyhrg.records import Log

Array = NDArray[np.float64]
Taken = Mapping[Group, Array]
"""Sizes of what is taken out of a record, by group."""

NOMINAL = 0.05
"""Share by which an amplitude may be off and still be the nominal one."""


@dataclass(frozen=True)
class Remainder:
    """What is left of one channel in one test.

    values: (n,) SI.
    steps: (n,) time from the reading before, s.
    interval: length of a row, s.
    noise: that it should be.
    left_out: (n,) by the simulation, as `whitened` has it.
    """

    test: str
    channel: str
    values: Array
    steps: Array
    interval: float
    noise: SlowNoise
    left_out: Array | None = None

    @cached_property
    def white(self) -> Array:
        """(n,) in deviations of the noise."""
        return whitened(self.values[:, None], self.steps, self.noise, self.left_out).series[:, 0]

    @property
    def times(self) -> Array:
        """(n,) s."""
        return np.cumsum(self.steps)


def remainders(
    parts: Sequence[LinearTest],
    taken: Taken,
    noise: ChannelNoise,
    believed: Device,
    channels: Sequence[str] = CHANNELS,
) -> list[Remainder]:
    """Of channels, all tests of each; of the output angle while the amplitude is nominal: at a
    smaller one all its noise is larger."""
    shared: Taken = {g: v for g, v in taken.items() if isinstance(g, Effect) or _is_output(g)}
    found = []
    for index, part in enumerate(parts):
        turned = _left(part, shared, "gyro_angle", index)[:, None]
        for channel in channels:
            left = _left(part, taken, channel, index)[:, None]
            values = part.at_measured_angle(left, turned, channel)[:, 0]
            rows = part.test.rows[channel]
            if channel == "gyro_angle":
                rows = rows & is_nominal(part.test.log, believed)
            steps = np.diff(part.test.log.time[rows], prepend=0.0)
            own = noise.of(channel, part.test)
            name, interval = part.test.test.id, part.test.log.interval
            out = part.left_out(channel)[rows]
            found.append(Remainder(name, channel, values[rows], steps, interval, own, out))
    return found


def _is_output(group: Group) -> bool:
    """Whether it moves the output alone, and not the pattern that other channels see."""
    return isinstance(group, Jump) and group.kind == "output"


def unlike(*taken: Taken | Mapping[Effect, Array]) -> list[Taken]:
    """Those that differ in their groups."""
    found: dict[tuple[Group, ...], Taken] = {}
    for one in taken:
        found[tuple(one)] = dict[Group, Array](one.items())
    return list(found.values())


def _left(part: LinearTest, taken: Taken, channel: str, index: int) -> Array:
    """(n,) of a channel's residual.

    Args:
        part: of one test.
        taken: out of it.
        channel: a field of a log.
        index: of the test.
    """
    left = part.residual[channel].copy()
    elements = {
        g: v for g, v in taken.items() if not isinstance(g, Effect) and g.channel == channel
    }
    columns = dict(unknown.columns(part.where, channel)) if elements else {}
    columns |= {g: g.columns(part.where) for g in elements if isinstance(g, Jump)}
    for group, value in taken.items():
        if isinstance(group, Effect):
            left -= part.secants[group][channel] @ value
        elif group in elements:
            left -= columns[group] @ (value[[index]] if group.is_of_each_power_on else value)
    return left


def is_nominal(log: Log, believed: Device) -> Mask:
    """(n,) rows in which the drive holds the nominal amplitude."""
    near = np.abs(log.amplitude_setpoint - believed.amplitude) < NOMINAL * believed.amplitude
    return np.asarray(near & (log.drive_on > 0))
