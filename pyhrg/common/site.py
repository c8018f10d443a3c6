"""The site where a gyro is tested, and Earth's rate there."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pyhrg.common.units import DEG

EARTH_RATE = 7.292115e-5
"""Earth's rotation rate, rad/s (WGS-84)."""


@dataclass(frozen=True)
class Site:
    """A laboratory; by default at 39.9 deg north, as in docs/paper.md."""

    latitude: float = 39.9 * DEG
    """Geodetic latitude, rad."""
    gravity: float = 9.8015
    """Local gravity, m/s2."""

    @property
    def latitude_deg(self) -> float:
        """Geodetic latitude, deg."""
        return self.latitude / DEG

    @property
    def vertical_rate(self) -> float:
        """Component of Earth's rate on local up, rad/s."""
        return EARTH_RATE * math.sin(self.latitude)

    @property
    def horizontal_rate(self) -> float:
        """Component of Earth's rate on local north, rad/s."""
        return EARTH_RATE * math.cos(self.latitude)

    def compute_earth_rate(
        self, axis_up: ArrayLike, misalignment: float = 0.0, azimuth: ArrayLike = 0.0
    ) -> NDArray[np.float64]:
        """Component of Earth's rate on the input axis of a gyro on a turntable, rad/s.

        `axis_up` is the projection of the table's axis on local up. The input axis leans from that
        axis by `misalignment`, rad, to the side at `azimuth` from north about it, rad, of a shape
        that broadcasts with `axis_up`.
        """
        up = np.asarray(axis_up) * np.cos(misalignment)
        lean = np.sin(misalignment) * np.cos(azimuth)
        return np.asarray(self.vertical_rate * up + self.horizontal_rate * lean)
