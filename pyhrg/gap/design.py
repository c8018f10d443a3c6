"""Residuals and what might explain them, whitened and summed up: all that evidence needs."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pyhrg.device import Device
from pyhrg.gap import unknown
from pyhrg.gap.catalogue import Effect
from pyhrg.gap.channel_noise import ChannelNoise
from pyhrg.gap.jump import Jump
from pyhrg.gap.observations import CHANNELS, Observed
from pyhrg.gap.unknown import Coordinates, Element
from pyhrg.gap.whitening import Whitened, whitened

Array = NDArray[np.float64]
Group = Effect | Element


@dataclass(frozen=True)
class Block:
    """One channel of one test.

    gram: (q, q) products of whitened columns: effects, elements of the channel, residual.
    rows: that were compared.
    log_determinant: of the noise's covariance.
    """

    test: str
    channel: str
    gram: Array
    rows: int
    log_determinant: float


@dataclass(frozen=True)
class Design:
    """A campaign's normal equations, of unit columns.

    gram: (p, p) of effects' and elements' columns.
    pull: (p,) products with the residual.
    power: of the whitened residual.
    places: columns of each group.
    lengths: (p,) norms of the columns before, in deviations of the noise per unit of the column.
    blocks: what each channel of each test adds.
    wrong: power that simulation and linear equations may get wrong, in deviations of the noise
        squared.
    """

    gram: Array
    pull: Array
    power: float
    places: Mapping[Group, NDArray[np.int64]]
    lengths: Array
    blocks: tuple[Block, ...]
    wrong: float = 0.0

    @property
    def log_likelihood(self) -> float:
        """Of the residual if nothing explained it, but for a constant."""
        log_determinant = sum(block.log_determinant for block in self.blocks)
        return -(self.power + log_determinant / (1 + self.wrong)) / 2

    @property
    def groups(self) -> list[Group]:
        """Those that the tests can see at all."""
        return [g for g, where in self.places.items() if (self.lengths[where] > 0).all()]


@dataclass(frozen=True)
class Evidence:
    """What is put together for one test.

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

    def responses(self, channel: str) -> Array:
        """(n, p + 1) secants of all effects, and the residual."""
        secants = [s[channel] for s in self.secants.values()]
        return np.column_stack([*secants, self.residual[channel]])

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


def design(parts: Sequence[Evidence], noise: ChannelNoise, jumps: Sequence[Jump] = ()) -> Design:
    """Whiten and sum up.

    Args:
        parts: of each test.
        noise: of all channels.
        jumps: that are weighed beside all else.
    """
    effects = list(parts[0].secants)
    places: dict[Group, NDArray[np.int64]] = {}
    count = _placed(places, effects, [e.size for e in effects], 0)
    own: dict[str, NDArray[np.int64]] = {}
    blocks = []
    grams: list[tuple[NDArray[np.int64], Array]] = []
    shared = np.arange(count)
    for channel in CHANNELS:
        for index, part in enumerate(parts):
            found = unknown.columns(part.where, channel, len(parts), index)
            found += [(j, j.columns(part.where)) for j in jumps if j.channel == channel]
            if channel not in own:
                begin = count
                count = _placed(
                    places, [e for e, _ in found], [b.shape[1] for _, b in found], count
                )
                own[channel] = np.arange(begin, count)
            block = _block(part, channel, [b for _, b in found], noise)
            blocks.append(block)
            grams.append((np.concatenate([shared, own[channel]]), block.gram))
    return _assembled(grams, count, places, tuple(blocks))


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


def _block(part: Evidence, channel: str, found: Sequence[Array], noise: ChannelNoise) -> Block:
    rows = part.test.rows[channel]
    responses = part.at_measured_angle(
        part.responses(channel), part.responses("gyro_angle"), channel
    )
    series = np.column_stack([responses[:, :-1], *found, responses[:, -1]])
    white = _white(part, channel, series, noise)
    gram = white.series.T @ white.series
    return Block(part.test.test.id, channel, gram, int(rows.sum()), white.log_determinant)


def _white(part: Evidence, channel: str, series: Array, noise: ChannelNoise) -> Whitened:
    """Of (n, p) series of a channel, the rows that are compared."""
    rows = part.test.rows[channel]
    steps = np.diff(part.test.log.time[rows], prepend=0.0)
    return whitened(series[rows], steps, noise.of(channel, part.test))


def _assembled(
    grams: Sequence[tuple[NDArray[np.int64], Array]],
    count: int,
    places: Mapping[Group, NDArray[np.int64]],
    blocks: tuple[Block, ...],
) -> Design:
    total, pull, power = np.zeros((count, count)), np.zeros(count), 0.0
    for where, gram in grams:
        total[np.ix_(where, where)] += gram[:-1, :-1]
        pull[where] += gram[:-1, -1]
        power += float(gram[-1, -1])
    lengths = np.sqrt(np.diag(total))
    lengths[lengths < VISIBLE] = 0.0
    unit = np.divide(1.0, lengths, out=np.zeros(count), where=lengths > 0)
    return Design(total * np.outer(unit, unit), pull * unit, power, places, lengths, blocks)


def tempered(whole: Design, wrong: float) -> Design:
    """The same equations where this power, in deviations of the noise squared, counts as noise:
    what simulation and linear equations leave of a large response."""
    root = float(np.sqrt(1 + wrong))
    return replace(
        whole,
        pull=whole.pull / root,
        power=whole.power / root**2,
        lengths=whole.lengths / root,
        wrong=wrong,
    )


def response_power(parts: Sequence[Evidence], noise: ChannelNoise) -> float:
    """What the residual has beyond its rows, in deviations of the noise squared.

    Args:
        parts: of each test.
        noise: of all channels.
    """
    beyond = 0.0
    for channel in CHANNELS:
        for part in parts:
            own, angle = (part.residual[name][:, None] for name in (channel, "gyro_angle"))
            left = part.at_measured_angle(own, angle, channel)
            white = _white(part, channel, left, noise).series
            beyond += float((white**2).sum()) - len(white)
    return max(beyond, 0.0)


VISIBLE = 1e-9
"""A column shorter than this is none."""
