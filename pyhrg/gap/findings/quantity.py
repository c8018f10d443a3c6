"""How large a gap is, in deviations of the noise: by test, channel and time scale."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.gap.effects.design import LinearTest, white_rows
from pyhrg.gap.replay.observations import CHANNELS
from pyhrg.gap.whitening.channel_noise import ChannelNoise

Array = NDArray[np.float64]

SCALES = (1.0, 10.0, 100.0, 1000.0)
"""Time scales, s."""
LEAST = 4
"""Means from which a scale is told."""


@dataclass(frozen=True)
class Size:
    """Of one channel of one test, at one time scale.

    before, after: root of the power that whitened residuals, averaged over the scale, have beyond
        their noise; 0 where they have none.
    """

    test: str
    channel: str
    scale_s: float
    before: float
    after: float


def sizes(
    parts: Sequence[LinearTest],
    before: Sequence[Mapping[str, Array]],
    after: Sequence[Mapping[str, Array]],
    noise: ChannelNoise,
) -> tuple[Size, ...]:
    """Of all channels of tests, in their order.

    Args:
        parts: of the tests whose residuals these are.
        before, after: (n,) residual by channel for each test, SI, where the pattern is as measured;
            NaN where not compared.
        noise: that is believed.
    """
    found = []
    for part, first, last in zip(parts, before, after, strict=True):
        for channel in CHANNELS:
            ends = [list(_powers(part, channel, r[channel], noise)) for r in (first, last)]
            for (scale, low), (_, high) in zip(*ends, strict=True):
                found.append(Size(part.test.test.id, channel, scale, low, high))
    return tuple(found)


def _powers(
    part: LinearTest, channel: str, residual: Array, noise: ChannelNoise
) -> Iterator[tuple[float, float]]:
    white = white_rows(part, channel, residual[:, None], noise).series[:, 0]
    for scale in SCALES:
        m = round(scale / part.test.log.interval)
        n = len(white) // m if m else 0
        if n >= LEAST:
            means = white[: n * m].reshape(n, m).sum(axis=1) / np.sqrt(m)
            yield scale, float(np.sqrt(max(float(means @ means) - n, 0.0)))
