"""Table 2: its arithmetic, and what its own figures say of how it was measured. Normalised deg/h.

A pure fourth harmonic of amplitude A is assumed wherever a pattern angle is derived.
"""

import math
from dataclasses import dataclass

import numpy as np
from scipy import constants, stats

from pyhrg.common.arrays import Array
from pyhrg.common.site import Site
from pyhrg.common.units import DEG, DEG_PER_H, DEG_PER_SQRT_H, HOUR, HZ
from tests.agreement.paper.gyros import TAU, K

ROWS = np.array(
    [
        (10.035, 0.00091, 10.051, 0.103),
        (10.051, 0.00089, 10.055, 0.097),
        (10.042, 0.00092, 10.049, 0.098),
        (10.054, 0.00091, 10.052, 0.100),
        (10.047, 0.00087, 10.056, 0.102),
        (10.034, 0.00090, 10.058, 0.102),
        (10.052, 0.00091, 10.051, 0.098),
    ]
)
"""The paper's Table 2: mean and standard deviation by the original method, then by the new one."""
AMPLITUDE = 0.1 * math.sqrt(2)
"""Amplitude of a fourth harmonic whose standard deviation over the circumference is 0.1 deg/h."""
SLOPE = 4 * AMPLITUDE * DEG
"""Largest slope of that harmonic, deg/h per deg of pattern."""


@dataclass(frozen=True)
class Figures:
    """What a bias test of several runs gives, each (n,): the runs' means and their deviations."""

    means: Array
    deviations: Array

    @property
    def stability(self) -> float:
        """Mean of the deviations."""
        return float(np.mean(self.deviations))

    @property
    def repeatability(self) -> float:
        """Standard deviation of the means, n - 1."""
        return float(np.std(self.means, ddof=1))

    @property
    def scatter(self) -> float:
        """Standard deviation of the deviations, n - 1."""
        return float(np.std(self.deviations, ddof=1))


ORIGINAL = Figures(ROWS[:, 0], ROWS[:, 1])
NEW = Figures(ROWS[:, 2], ROWS[:, 3])


def stability_interval(test: Figures) -> tuple[float, float]:
    """Student's 95 % interval of the stability."""
    n = len(test.deviations)
    reach = float(stats.t.ppf(0.975, n - 1)) * test.scatter / math.sqrt(n)
    return test.stability - reach, test.stability + reach


def deviation_interval(deviation: float, n: int) -> tuple[float, float]:
    """Chi-square 95 % interval of a standard deviation from n normal samples."""
    high, low = stats.chi2.ppf([0.025, 0.975], n - 1)
    return deviation * math.sqrt((n - 1) / low), deviation * math.sqrt((n - 1) / high)


def figures() -> dict[str, float]:
    """Arithmetic with intervals, and what follows from it."""
    return {**_arithmetic(), **_means(), **_creep(), **_averages(), **_spacing()}


def _arithmetic() -> dict[str, float]:
    found = {"ratio": NEW.stability / ORIGINAL.stability}
    for name, test in (("original", ORIGINAL), ("new", NEW)):
        n = len(test.means)
        found[f"{name}_mean"] = float(np.mean(test.means))
        found[f"{name}_stability"] = test.stability
        found[f"{name}_repeatability"] = test.repeatability
        found[f"{name}_scatter"] = test.scatter
        intervals = {
            "stability": stability_interval(test),
            "repeatability": deviation_interval(test.repeatability, n),
            "scatter": deviation_interval(test.scatter, n),
        }
        for figure, (low, high) in intervals.items():
            found[f"{name}_{figure}_low"], found[f"{name}_{figure}_high"] = low, high
    return found


def _means() -> dict[str, float]:
    """What a mean of 10.05 can be: Earth's rate on an axis that points up, and a bias."""
    up = Site().vertical_rate / DEG_PER_H
    mean = float(np.mean(NEW.means))
    return {
        "earth_up": up,
        "bias_beyond_earth": mean - up,
        "normalisation": mean / up,
        "stability_before_normalisation": NEW.stability * up / mean,
        "latitude_without_bias_deg": math.degrees(math.asin(mean / 15.0411)),
    }


def _creep() -> dict[str, float]:
    """What the original method's figures allow the pattern to do near its zero crossing."""
    offset = float(np.mean(ORIGINAL.means) - np.mean(NEW.means))
    slope = SLOPE * math.sqrt(1 - (offset / AMPLITUDE) ** 2)
    creep = ORIGINAL.stability * math.sqrt(12) / slope
    rate = K * Site().vertical_rate / DEG * HOUR
    own = math.sqrt(ORIGINAL.repeatability**2 - NEW.repeatability**2)
    angle = own / slope
    hour = np.sin(4 * DEG * (math.degrees(math.asin(offset / AMPLITUDE)) / 4 + _spread(rate)))
    return {
        "amplitude": AMPLITUDE,
        "offset": offset,
        "offset_standard_error": math.hypot(ORIGINAL.repeatability, NEW.repeatability)
        / math.sqrt(len(ROWS)),
        "offset_angle_deg": offset / slope,
        "creep_allowed_deg": creep,
        "creep_allowed_min": creep / rate * 60,
        "creep_of_the_mean_deg_per_h": K * float(np.mean(ORIGINAL.means)),
        "hour_up_deviation": float(np.std(AMPLITUDE * hour)),
        "angle_scatter_deg": angle,
        "angle_scatter_for_an_hour_deg": angle * rate / creep,
    }


def _spread(rate: float) -> Array:
    """Pattern angles of an hour about its middle, deg."""
    return np.asarray((np.arange(36) - 17.5) / 36 * rate)


def _averages() -> dict[str, float]:
    """The original deviations repeat to 1.9 %: how many independent points that takes."""
    relative = ORIGINAL.scatter / ORIGINAL.stability
    most = deviation_interval(relative, len(ORIGINAL.means))[1]

    def points(scatter: float) -> float:
        return 1 + 1 / (2 * scatter**2)

    hour = 1 / math.sqrt(2 * 35)
    chance = stats.chi2.cdf(6 * (relative / hour) ** 2, 6)
    return {
        "original_relative_scatter_percent": 100 * relative,
        "points": points(relative),
        "points_least": points(most),
        "hour_of_100_s_scatter_percent": 100 * hour,
        "chance_of_36_points": float(chance),
        "new_relative_scatter_percent": 100 * NEW.scatter / NEW.stability,
        "random_walk_of_10_s_means": ORIGINAL.stability * math.sqrt(10 / HOUR),
        "thermal_random_walk": _thermal_random_walk() / DEG_PER_SQRT_H,
    }


def _thermal_random_walk() -> float:
    """Thermal random walk, rad/sqrt(s), of a 20 mm resonator: 0.2 g modal mass, 7 kHz, 1 um, 300 K.

    (1/2k) sqrt(k_B T / (E tau)), E = m w^2 a^2 / 2 the energy of the vibration.
    """
    energy = 0.2e-3 * (7000 * HZ * 1e-6) ** 2 / 2
    return math.sqrt(constants.k * 300 / (energy * TAU)) / (2 * K)


def _spacing() -> dict[str, float]:
    """8 positions 45 deg apart that start where the original method stands: what they report."""
    offset = float(np.mean(ORIGINAL.means) - np.mean(NEW.means))
    return {"reported_by_45_deg_from_there": abs(offset) * math.sqrt(8 / 7)}
