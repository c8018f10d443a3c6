"""The origin of each log's output angle, taken out of what is compared with the noise floor."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from pyhrg.gap.closing.closing import Closing, Residuals
from pyhrg.gap.effects.linear_test import shape_origin
from pyhrg.gap.replay.observations import ObservedTest
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.gap.whitening.campaign_noise import CampaignNoise, whiten_finite

SIGNIFICANT_SIGMA = 5.0
"""Origin, in its standard deviation, from which it counts as wrong. Chosen."""


def take_out_origins(
    simulation: Simulation, closing: Closing, tests: Sequence[ObservedTest], noise: CampaignNoise
) -> Closing:
    """The residuals of the output angle without the origins that are wrong, each by generalised
    least squares of its own log after closing (docs/methods/whitening.md, Eq. 19). No diagnosis can
    know that of a held-out log."""
    pairs = zip(closing.before, closing.after, tests, strict=True)
    moved = [_move(simulation, closing, *pair, noise) for pair in pairs]
    return replace(closing, before=tuple(b for b, _ in moved), after=tuple(a for _, a in moved))


def _move(
    simulation: Simulation,
    closing: Closing,
    before: Residuals,
    after: Residuals,
    test: ObservedTest,
    noise: CampaignNoise,
) -> tuple[Residuals, Residuals]:
    if not np.isfinite(after["gyro_angle"]).any():
        return before, after
    slopes = simulation.differentiate_by_angle(closing.device, test).slopes["gyro_angle"]
    shape = shape_origin(closing.device.bryan_factor, slopes)
    series = np.column_stack([after["gyro_angle"], shape])
    white = whiten_finite(noise.angle, "gyro_angle", test, series)
    information = float(white[:, 1] @ white[:, 1])
    origin = float(white[:, 1] @ white[:, 0]) / information
    if abs(origin) * np.sqrt(information) < SIGNIFICANT_SIGMA:
        return before, after
    first, last = ({**r, "gyro_angle": r["gyro_angle"] - origin * shape} for r in (before, after))
    return first, last
