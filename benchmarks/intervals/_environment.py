"""What the environment's coverage cases share: intervals by name, noise of a data point."""

from collections.abc import Mapping

import numpy as np

from pyhrg.bench.outcome import Outcome
from pyhrg.device import Device

Intervals = dict[str, tuple[float, float, float]]
FAST = {"samplePeriod": 1.0}
"""Parameters of HRGSlow for communication steps of a second."""


def against(outcome: Outcome, truths: Mapping[str, float]) -> Intervals:
    """(truth, low, high) by finding."""
    found = {name: outcome.finding(name) for name in truths}
    return {name: (truth, found[name].low, found[name].high) for name, truth in truths.items()}


def rate_noise(device: Device, seconds: float) -> float:
    """Standard deviation of a rate mean, rad/s: random walk, and white noise of both its angles."""
    walk = device.angle_random_walk**2 / seconds
    return float(np.sqrt(walk + 2 * (device.pickoff_noise / seconds) ** 2))
