"""What the environment's coverage cases share: intervals by name, noise of a data point."""

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy import special

from pyhrg.bench.outcome import Outcome
from pyhrg.bench.readings.turns import Spin, find_spins, pair_spins
from pyhrg.device.device import Device
from pyhrg.records import Log

Intervals = dict[str, tuple[float, float, float]]
FAST = {"samplePeriod": 1.0}
"""Parameters of HRGSlow for communication steps of a second."""


def against(outcome: Outcome, truths: Mapping[str, float]) -> Intervals:
    """(truth, low, high) by finding."""
    found = {name: outcome.finding(name) for name in truths}
    return {
        name: (truth, found[name].si_low, found[name].si_high) for name, truth in truths.items()
    }


def quiet(device: Device) -> Device:
    """The same gyro without noise: its test is what the noisy one's would be on the average."""
    return replace(device, angle_random_walk=0.0, angle_white_noise=0.0)


def rate_noise(device: Device, seconds: float) -> float:
    """Standard deviation of a rate mean, rad/s: random walk, and white noise of both its angles."""
    walk = device.angle_random_walk**2 / seconds
    return float(np.sqrt(walk + 2 * (device.angle_white_noise / seconds) ** 2))


def mean_deviation(noise: float, spread: float, freedom: int) -> float:
    """Mean of the standard deviation (n - 1) of values with noise whose means differ by `spread`:
    of a noncentral chi distribution."""
    half, beyond = freedom / 2, freedom * (spread / noise) ** 2
    if beyond > 1e4 * freedom:
        return float(np.sqrt(spread**2 + noise**2 * (1 - 1 / freedom)))
    ratio = np.exp(special.gammaln(half + 0.5) - special.gammaln(half))
    laguerre = special.hyp1f1(-0.5, half, -beyond / 2)
    return float(noise * np.sqrt(2 / freedom) * ratio * laguerre)


def pair_noise(device: Device, log: Log) -> float:
    """Standard deviation of the scale factor of a log's first pair of spins."""
    both = pair_spins(find_spins(log, device.site.vertical_rate), log.source)[0]
    return float(np.sqrt(sum(_slope_variance(device, log, spin) for spin in both)) / 2)


def _slope_variance(device: Device, log: Log, spin: Spin) -> float:
    """Of the fit by table angle and fourth harmonic: of angle random walk and of white noise."""
    rows = slice(spin.first, spin.last + 1)
    table, pattern = log.table_angle[rows], log.wave_angle[rows]
    columns = [np.ones_like(table), table - table[0], np.cos(4 * pattern), np.sin(4 * pattern)]
    weights: NDArray[np.float64] = np.linalg.pinv(np.column_stack(columns))[1]
    later = np.cumsum(weights[::-1])[::-1]
    walk = device.angle_random_walk**2 * log.interval * float(later @ later)
    return walk + device.angle_white_noise**2 * float(weights @ weights)
