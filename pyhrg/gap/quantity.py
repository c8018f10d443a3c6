"""How large a gap is, in deviations of the noise: by test, channel and time scale."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.gap.channel_noise import ChannelNoise
from pyhrg.gap.observations import CHANNELS, Observed
from pyhrg.gap.whitening import SlowNoise, whitened

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
    tests: Sequence[Observed],
    before: Sequence[Mapping[str, Array]],
    after: Sequence[Mapping[str, Array]],
    noise: ChannelNoise,
) -> tuple[Size, ...]:
    """Of all channels of tests, in their order.

    Args:
        tests: whose residuals these are.
        before, after: (n,) residual by channel for each test, SI, where the pattern is as measured;
            NaN where not compared.
        noise: that is believed.
    """
    found = []
    for test, first, last in zip(tests, before, after, strict=True):
        for channel in CHANNELS:
            of = noise.of(channel, test)
            ends = [list(_powers(test, r[channel], of)) for r in (first, last)]
            for (scale, low), (_, high) in zip(*ends, strict=True):
                found.append(Size(test.test.id, channel, scale, low, high))
    return tuple(found)


def _powers(test: Observed, residual: Array, noise: SlowNoise) -> Iterator[tuple[float, float]]:
    rows = np.isfinite(residual)
    steps = np.diff(test.log.time[rows], prepend=0.0)
    white = whitened(residual[rows][:, None], steps, noise).series[:, 0]
    for scale in SCALES:
        m = round(scale / test.log.interval)
        n = len(white) // m if m else 0
        if n >= LEAST:
            means = white[: n * m].reshape(n, m).sum(axis=1) / np.sqrt(m)
            yield scale, float(np.sqrt(max(float(means @ means) - n, 0.0)))
