"""How large a gap is: excess of the whitened residual over its noise, by time scale."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.linear_test import LinearTest, whiten_rows
from pyhrg.gap.replay.observations import CHANNELS
from pyhrg.gap.whitening.campaign_noise import CampaignNoise

TIME_SCALES = (1.0, 10.0, 100.0, 1000.0)
"""Times over which residuals are averaged, s."""
MIN_MEANS = 4
"""Means that a test must have at a time scale. Chosen."""


@dataclass(frozen=True)
class Size:
    """Size of the gap in one channel of one test at one time scale.

    scale_s: time over which the whitened residual is averaged.
    before, after: root of the averages' power beyond that of noise, in sigma; 0 where there is no
        excess (docs/methods/verdict.md, Eq. (8)).
    """

    test: str
    channel: str
    scale_s: float
    before: float
    after: float


def measure_sizes(
    parts: Sequence[LinearTest],
    before: Sequence[Mapping[str, Array]],
    after: Sequence[Mapping[str, Array]],
    noise: CampaignNoise,
) -> tuple[Size, ...]:
    """Sizes of the gap in all channels of all tests, before and after closing, beside the noise
    that the nominal gyro states. Residuals are (n,) by channel for each test, SI, where the pattern
    is as measured; NaN where record and simulation are not compared."""
    sizes = []
    for part, first, last in zip(parts, before, after, strict=True):
        for channel in CHANNELS:
            ends = [
                list(_measure_excesses(part, channel, r[channel], noise)) for r in (first, last)
            ]
            for (scale, old), (_, new) in zip(*ends, strict=True):
                sizes.append(Size(part.test.test.id, channel, scale, old, new))
    return tuple(sizes)


def _measure_excesses(
    part: LinearTest, channel: str, residual: Array, noise: CampaignNoise
) -> Iterator[tuple[float, float]]:
    """Each time scale, s, with the root of the excess power at it."""
    white = whiten_rows(part, channel, residual[:, None], noise).series[:, 0]
    for scale in TIME_SCALES:
        m = round(scale / part.test.log.interval)
        n = len(white) // m if m else 0
        if n >= MIN_MEANS:
            means = white[: n * m].reshape(n, m).sum(axis=1) / np.sqrt(m)
            yield scale, float(np.sqrt(max(float(means @ means) - n, 0.0)))
