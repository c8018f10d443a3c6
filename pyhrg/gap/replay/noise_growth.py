"""How noise grows as the amplitude falls: a force, or a reading of the displacement, turns a small
vibration further (docs/methods/whitening.md, Eqs. 17 to 17b)."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.gap.replay.observations import ObservedTest
from pyhrg.gap.replay.reading_noise import MIN_DIFFERENCES, is_inlier
from pyhrg.records import Log

CHANNELS_PER_AMPLITUDE = ("gyro_angle", "amplitude_force", "frequency_offset")
"""Channels that are a force or a displacement over the amplitude."""
MIN_LEVEL = 1e-3
"""Smallest amplitude over the nominal one of which noise is computed. Chosen."""
MIN_RANGE = 0.1
"""Range of a test's amplitude, over the nominal one, that shows whether noise grows. Chosen."""
SHARES = np.linspace(0.0, 1.0, 21)
"""Shares of the variance that are tried."""


def add_noise_growth(tests: Sequence[ObservedTest], nominal: Device) -> tuple[ObservedTest, ...]:
    """The tests with the growth of their noise. Its share is estimated from those to be fitted."""
    levels = [find_level(test.log, nominal) for test in tests]
    fitted = [p for p in zip(tests, levels, strict=True) if not p[0].test.is_holdout]
    shares = {name: estimate_growing_share(name, fitted) for name in CHANNELS_PER_AMPLITUDE}
    return tuple(
        replace(test, noise_growth=_compute_growth(test.log, level, shares))
        for test, level in zip(tests, levels, strict=True)
    )


def find_level(log: Log, nominal: Device) -> Array:
    """(n,) amplitude over the nominal one: the set point, and the measured one while the drive is
    off; interpolated where it is missing, the set point where it is missing throughout."""
    amplitude = np.where(log.is_driven, log.amplitude_setpoint, log.amplitude)
    known = np.isfinite(amplitude)
    if known.any():
        amplitude = np.interp(log.time, log.time[known], amplitude[known])
    else:
        amplitude = log.amplitude_setpoint
    return np.fmax(amplitude / nominal.amplitude, MIN_LEVEL)


def estimate_growing_share(name: str, tests: Sequence[tuple[ObservedTest, Array]]) -> float:
    """Most likely share of a channel's variance at nominal amplitude that is inversely proportional
    to the amplitude's square (Eq. 17b), from third differences of tests with their levels. A slow
    signal contributes almost nothing to these."""
    squares, levels = [], []
    for test, level in tests:
        rows = test.rows[name]
        four = rows[3:] & rows[2:-1] & rows[1:-2] & rows[:-3]
        if not four.any() or np.ptp(level[rows]) < MIN_RANGE:
            continue
        differences = np.diff(getattr(test.log, name), 3)[four]
        weighted = differences * level[1:-2][four]
        kept = is_inlier(weighted)
        squares.append(differences[kept] ** 2)
        levels.append(level[1:-2][four][kept])
    if sum(map(len, squares)) < MIN_DIFFERENCES:
        return 0.0

    def misfit(share: float) -> float:
        total = 0.0
        for own, level in zip(squares, levels, strict=True):
            variance = 1 - share + share / level**2
            total += len(own) * np.log(np.mean(own / variance)) + np.log(variance).sum()
        return float(total)

    return float(min(SHARES, key=misfit))


def _compute_growth(log: Log, level: Array, shares: Mapping[str, float]) -> dict[str, Array]:
    """(n,) by channel: standard deviation of noise over that at nominal amplitude. Of the free
    amplitude, 1 where it walks: once the drive is off."""
    growth = {
        name: np.sqrt(1 - share + share / level**2) for name, share in shares.items() if share
    }
    if log.is_free.any():
        growth["amplitude"] = np.maximum.accumulate(log.is_free) * 1.0
    return growth
