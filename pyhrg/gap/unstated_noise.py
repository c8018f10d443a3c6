"""Noise of the output angle where none is stated: that of the gyro's own records at rest."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import groupby

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

from pyhrg.campaign import INDEX, CampaignError
from pyhrg.device import Device
from pyhrg.gap.channel_noise import LEAST_ANGLE
from pyhrg.gap.noise_levels import AngleRecord, log_likelihood
from pyhrg.gap.observations import SLOW, Observed
from pyhrg.gap.simulation import Simulation
from pyhrg.gap.whitening import SlowNoise
from pyhrg.units import ARCSEC, DEG_PER_SQRT_H

Array = NDArray[np.float64]

FEW = 60
"""Rows at rest below which they tell nothing."""
TREND = 2
"""Degree of the drift that is taken out of a stretch: what a gap leaves of it."""
LONG_AGO = 1e6
"""Before a stretch, s: where the angle stood at its beginning is not known."""
NOTE = (
    "nominal: states no noise of the output angle: {:.3g} arcsec of white noise and "
    "{:.3g} deg/sqrt(h) of angle random walk are taken from the records at rest"
)

NO_NOISE = (
    f"{INDEX}: nominal: states no noise of the output angle, and no log shows it in {FEW} rows at "
    "rest; expected angle_random_walk_deg_sqrt_h or angle_white_noise_arcsec, or a test at rest"
)


def with_noise(
    simulation: Simulation, believed: Device, tests: Sequence[Observed]
) -> tuple[Device, tuple[str, ...]]:
    """A gyro with the angle's noise, and a sentence where it had to be taken from records.

    White noise and angle random walk are the likeliest in the stretches at rest, the simulation and
    a drift taken out of each; of tests that are nothing but rest, if there are any.

    Args:
        simulation: both fidelities.
        believed: as it is stated.
        tests: of the gyro.

    Raises:
        CampaignError: nothing is stated, and nothing rests.
        GyroError: a gyro that the FMU refuses.
    """
    stated = (
        believed.pickoff_noise,
        believed.angle_random_walk,
        believed.rate_random_walk,
        believed.bias_instability,
        believed.angle_quantum,
    )
    if any(stated):
        return believed, ()
    static = [test for test in tests if test.test.kind == "static"]
    left = [
        (test, test.log.gyro_angle - simulation.answers(believed, test)["gyro_angle"])
        for test in static or tests
    ]
    records = [record for test, angle in left for record in _at_rest(test, angle)]
    if not records:
        raise CampaignError(NO_NOISE)
    white, walk = _likeliest(records)
    note = NOTE.format(white / ARCSEC, walk / DEG_PER_SQRT_H)
    return replace(believed, pickoff_noise=white, angle_random_walk=walk), (note,)


def _at_rest(test: Observed, left: Array) -> Iterator[AngleRecord]:
    """What is left of the angle, (n,) rad, where loops and table are at rest."""
    log, rates = test.log, np.abs(test.inputs.rates)
    quiet = test.rows["frequency_offset"] & (np.maximum(rates[1:], rates[:-1]) < SLOW)
    quiet &= log.drive_on > 0
    for is_quiet, group in groupby(range(len(quiet)), key=lambda i: bool(quiet[i])):
        rows = list(group)
        if is_quiet and len(rows) >= FEW:
            time, angle = log.time[rows], left[rows]
            drift = np.polynomial.Polynomial.fit(time, angle, TREND)
            steps = np.diff(time, prepend=time[0] - LONG_AGO)
            yield AngleRecord(angle - drift(time), steps)


def _likeliest(records: Sequence[AngleRecord]) -> tuple[float, float]:
    """White noise, rad, and angle random walk, rad/sqrt(s)."""
    typical = float(np.median([np.std(np.diff(record.angle)) for record in records]))
    step = float(np.median(np.concatenate([record.steps for record in records])))
    scale = max(typical, LEAST_ANGLE)

    def misfit(logarithms: tuple[float, float]) -> float:
        white, walk = (scale * math.exp(x) for x in logarithms)
        return -log_likelihood(records, SlowNoise(white, walk / math.sqrt(step)))

    found = minimize(misfit, (-1.0, -1.0), method="Nelder-Mead", bounds=[(-7.0, 3.0)] * 2)
    white, walk = (scale * math.exp(x) for x in found.x)
    return white, walk / math.sqrt(step)
