"""Bias over the circumference in one short power-on: mean, second and fourth harmonic.

Eight positions lie 22.5 deg of pattern angle apart. Their mean holds none of the harmonics 2 to 14
of even order, wherever the pattern starts, so that power-ons can be compared.
"""

from dataclasses import dataclass

import numpy as np

from pyhrg.bench.bias.thermal_programme import SETTLE
from pyhrg.bench.estimation.harmonics import Fit, compute_inflations, fit, make_columns
from pyhrg.bench.outcome import BenchError
from pyhrg.bench.readings.segments import WARM_UP, Points, read_points
from pyhrg.common.site import Site
from pyhrg.records.campaign import Test

HARMONICS = (2, 4)
LARGEST_INFLATION = 3.0
"""Largest variance inflation factor (chosen) of the harmonics; evenly spaced positions have 1."""


@dataclass(frozen=True)
class Circumference:
    """One power-on over the circumference.

    Attributes:
        fitted: fit of mean and harmonics, rad/s.
    """

    points: Points
    fitted: Fit


def fit_circumference(test: Test, site: Site) -> Circumference:
    data = read_points(test.log, site, SETTLE, WARM_UP, held=())
    columns = make_columns(data.pattern_angle, data.pattern_angle, HARMONICS, tilt=False)
    worst = max(compute_inflations(columns).values())
    if worst > LARGEST_INFLATION or len(data) < len(columns) + 2:
        degrees = ", ".join(f"{a:.0f}" for a in np.degrees(np.unique(data.pattern_angle))[:12])
        raise BenchError(
            f"{test.log.source}: {len(data)} data points at pattern angles {degrees} deg don't "
            "spread over the circumference; 8 positions, 22.5 deg apart, with 100 s each are needed"
        )
    return Circumference(data, fit(columns, data.rate))
