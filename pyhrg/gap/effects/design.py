"""Residuals and what might explain them, whitened and summed up: all that evidence needs."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from pyhrg.device.device import Device
from pyhrg.gap.effects import candidate_terms as unknown
from pyhrg.gap.effects.candidate_terms import Coordinates, Element
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.jump import Jump
from pyhrg.gap.replay.carrier_terms import left_out
from pyhrg.gap.replay.observations import CHANNELS, Observed
from pyhrg.gap.whitening.channel_noise import ChannelNoise
from pyhrg.gap.whitening.whitening import Whitened, whitened

Array = NDArray[np.float64]
Group = Effect | Element
Where = tuple[str, str]
"""Test and channel."""


@dataclass(frozen=True)
class Block:
    """One channel of one test.

    columns: (q - 1,) the design's columns that take part.
    gram: (q, q) products of these, whitened, and of the residual.
    rows: that were compared.
    log_determinant: of the noise's covariance.
    wrong: power that simulation and linear equations may get wrong, in deviations of the noise
        squared: it counts as noise.
    """

    test: str
    channel: str
    columns: NDArray[np.int64]
    gram: Array
    rows: int
    log_determinant: float
    wrong: float = 0.0


@dataclass(frozen=True)
class Design:
    """A campaign's normal equations, of unit columns.

    gram: (p, p) of effects' and elements' columns.
    pull: (p,) products with the residual.
    power: of the whitened residual.
    places: columns of each group.
    lengths: (p,) norms of the columns before, in deviations of the noise per unit of the column.
    blocks: what each channel of each test adds.
    """

    gram: Array
    pull: Array
    power: float
    places: Mapping[Group, NDArray[np.int64]]
    lengths: Array
    blocks: tuple[Block, ...]

    @property
    def log_likelihood(self) -> float:
        """Of the residual if nothing explained it, but for a constant."""
        log_determinant = sum(b.log_determinant / (1 + b.wrong) for b in self.blocks)
        return -(self.power + log_determinant) / 2

    @property
    def groups(self) -> list[Group]:
        """Those that the tests can see at all."""
        return [g for g, where in self.places.items() if (self.lengths[where] > 0).all()]


@dataclass(frozen=True)
class LinearTest:
    """One test around a simulated gyro, in which effects are linear.

    device: that is simulated.
    answers: (n,) by field of a log, of the device.
    residual: (n,) by channel, record less simulation.
    secants: (n, d) by channel, for each effect: change of the answer per unit of its vector.
    where: coordinates.
    slopes: (n,) by channel: change of the answer with the pattern's angle, per rad.
    bryan_factor: as believed.
    """

    test: Observed
    device: Device
    answers: Mapping[str, Array]
    residual: Mapping[str, Array]
    secants: Mapping[Effect, Mapping[str, Array]]
    where: Coordinates
    slopes: Mapping[str, Array]
    bryan_factor: float

    def responses(self, channel: str, outputs: Sequence[Jump] = ()) -> Array:
        """(n, p + 1) secants of all effects, jumps of the output alone, and the residual."""
        secants = [s[channel] for s in self.secants.values()]
        jumped = [(channel == "gyro_angle") * jump.columns(self.where) for jump in outputs]
        return np.column_stack([*secants, *jumped, self.residual[channel]])

    def left_out(self, channel: str) -> Array:
        """(n,) what the next order of the average over a carrier period, which the simulated gyro
        has not, does to a channel."""
        return self._left_out[channel]

    @cached_property
    def _left_out(self) -> Mapping[str, Array]:
        return left_out(self.device, self.test, self.where.pattern_angle)

    def at_measured_angle(self, series: Array, angles: Array, channel: str) -> Array:
        """Series of a channel where the pattern is as measured, not as simulated: noise that turns
        the pattern is then seen in the angle alone.

        Args:
            series: (n, p) of the channel.
            angles: (n, p) the same of the output angle, rad.
            channel: a field of a log.
        """
        if channel == "gyro_angle":
            return series
        return series + self.bryan_factor * self.slopes[channel][:, None] * angles


def design(parts: Sequence[LinearTest], noise: ChannelNoise, jumps: Sequence[Jump] = ()) -> Design:
    """Whiten and sum up.

    Args:
        parts: of each test.
        noise: of all channels.
        jumps: that are weighed beside all else.
    """
    effects = list(parts[0].secants)
    places: dict[Group, NDArray[np.int64]] = {}
    outputs = [j for j in jumps if j.kind == "output"]
    sizes = [*(e.size for e in effects), *(len(j.times) for j in outputs)]
    count = _placed(places, [*effects, *outputs], sizes, 0)
    blocks = []
    shared = np.arange(count)
    for channel in CHANNELS:
        for index, part in enumerate(parts):
            found = unknown.columns(part.where, channel)
            if channel == "gyro_angle":
                found += [(j, j.columns(part.where)) for j in jumps if j not in outputs]
            elements, values = zip(*found, strict=True)
            if index == 0:
                sizes = [
                    len(parts) if e.is_of_each_power_on else v.shape[1]
                    for e, v in zip(elements, values, strict=True)
                ]
                count = _placed(places, elements, sizes, count)
            own = [places[e][[index]] if e.is_of_each_power_on else places[e] for e in elements]
            columns = np.concatenate([shared, *own])
            blocks.append(_block(part, channel, columns, outputs, values, noise))
    return _assembled(places, blocks)


def _placed(
    places: dict[Group, NDArray[np.int64]],
    groups: Sequence[Group],
    sizes: Sequence[int],
    count: int,
) -> int:
    for group, size in zip(groups, sizes, strict=True):
        places[group] = np.arange(count, count + size)
        count += size
    return count


def _block(
    part: LinearTest,
    channel: str,
    columns: NDArray[np.int64],
    outputs: Sequence[Jump],
    found: Sequence[Array],
    noise: ChannelNoise,
) -> Block:
    rows = part.test.rows[channel]
    responses = part.at_measured_angle(
        part.responses(channel, outputs), part.responses("gyro_angle", outputs), channel
    )
    series = np.column_stack([responses[:, :-1], *found, responses[:, -1]])
    white = white_rows(part, channel, series, noise)
    gram = white.series.T @ white.series
    name = part.test.test.id
    return Block(name, channel, columns, gram, int(rows.sum()), white.log_determinant)


def white_rows(part: LinearTest, channel: str, series: Array, noise: ChannelNoise) -> Whitened:
    """Of (n, p) series of a channel, the rows that are compared, whitened."""
    rows = part.test.rows[channel]
    steps = np.diff(part.test.log.time[rows], prepend=0.0)
    out = part.left_out(channel)[rows]
    return whitened(series[rows], steps, noise.of(channel, part.test), out)


def _assembled(places: Mapping[Group, NDArray[np.int64]], blocks: Sequence[Block]) -> Design:
    count = sum(map(len, places.values()))
    total, pull, power = np.zeros((count, count)), np.zeros(count), 0.0
    for block in blocks:
        gram = block.gram / (1 + block.wrong)
        total[np.ix_(block.columns, block.columns)] += gram[:-1, :-1]
        pull[block.columns] += gram[:-1, -1]
        power += float(gram[-1, -1])
    lengths = np.sqrt(np.diag(total))
    lengths[lengths < VISIBLE] = 0.0
    unit = np.divide(1.0, lengths, out=np.zeros(count), where=lengths > 0)
    gram = total * np.outer(unit, unit)
    return Design(gram, pull * unit, power, places, lengths, tuple(blocks))


def tempered(whole: Design, wrong: Mapping[Where, float]) -> Design:
    """The same equations where this power, in deviations of the noise squared, counts as noise:
    what simulation and linear equations leave of a large response."""
    blocks = [replace(b, wrong=wrong.get((b.test, b.channel), 0.0)) for b in whole.blocks]
    return _assembled(whole.places, blocks)


def response_power(parts: Sequence[LinearTest], noise: ChannelNoise) -> dict[Where, float]:
    """What the residual has beyond its rows, in deviations of the noise squared.

    Args:
        parts: of each test.
        noise: of all channels.
    """
    beyond = {}
    for channel in CHANNELS:
        for part in parts:
            own, angle = (part.residual[name][:, None] for name in (channel, "gyro_angle"))
            left = part.at_measured_angle(own, angle, channel)
            white = white_rows(part, channel, left, noise).series
            beyond[part.test.test.id, channel] = max(float((white**2).sum()) - len(white), 0.0)
    return beyond


VISIBLE = 1e-9
"""A column shorter than this is none."""
