"""Bias over the circumference in a short run: mean, second and fourth harmonic of one power-on.

Eight positions, 22.5 deg of pattern apart: the mean of a position each is free of every harmonic up
to the eighth, wherever the pattern begins, so that power-ons can be compared.
"""

from dataclasses import dataclass

import numpy as np

from pyhrg.bench.bias.thermal_programme import SETTLE
from pyhrg.bench.estimation.harmonics import MEAN, Fit, design, fit, inflation
from pyhrg.bench.outcome import BenchError
from pyhrg.bench.readings.dwells import Points, points
from pyhrg.bench.readings.segments import SEGMENT, WARM_UP
from pyhrg.common.site import Site
from pyhrg.records.campaign import Test

HARMONICS = (2, 4)
LARGEST_INFLATION = 3.0
"""Evenly spread positions have 1."""


@dataclass(frozen=True)
class Circumference:
    """One power-on over the circumference.

    fitted: mean and harmonics, rad/s.
    """

    points: Points
    fitted: Fit

    def value(self, term: str = MEAN) -> float:
        """Of a term, rad/s."""
        return self.fitted.value(term)

    @property
    def noise(self) -> float:
        """Sum of squares of what the fit leaves, (rad/s)^2."""
        return float(self.fitted.residual @ self.fitted.residual)


def circumference(test: Test, site: Site) -> Circumference:
    """Fit one power-on.

    Raises:
        BenchError: positions that don't spread over the circumference.
    """
    found = points(test.log, site.latitude, SETTLE, SEGMENT, WARM_UP, held=())
    columns = design(found.pattern_angle, found.pattern_angle, HARMONICS, tilt=False)
    worst = max(inflation(columns).values())
    if worst > LARGEST_INFLATION or len(found) < len(columns) + 2:
        degrees = ", ".join(f"{a:.0f}" for a in np.degrees(np.unique(found.pattern_angle))[:12])
        raise BenchError(
            f"{test.log.source}: {len(found)} data points at pattern angles {degrees} deg don't "
            "spread over the circumference; 8 positions, 22.5 deg apart, with 100 s each are needed"
        )
    return Circumference(found, fit(columns, found.rate))
