"""Noise coefficients of records that show each of them clearly; the noise is NumPy's.

A noise that is nowhere the largest, or that only a few slow frequencies show, is held less often
where a noise of a neighbouring slope is not there: `identify` knows that strengths are not
negative, so that the neighbour takes some of it half of the time.
"""

import numpy as np

from pyhrg.fmu import GyroFmu
from pyhrg.noise.fitting import estimate_noise
from pyhrg.noise.ramp import estimate_rate_ramp
from tests.pyhrg.noises import Mixture, noisy_angle

MODEL = "HRGSlow"
SAMPLES = 2000
LETTERS = {
    "angle_white_noise": "Q",
    "angle_random_walk": "N",
    "bias_instability": "B",
    "rate_random_walk": "K",
}
MIXTURES: dict[str, Mixture] = {
    "Q and N": (1, 1, 0, 0, 0),
    "Q, N and B": (1, 1, 0.3, 0, 0),
    "Q, N and K": (1, 0.3, 0, 0.02, 0),
    "Q, N, K and ramp": (1, 0.3, 0, 0.02, 1e-2),
}
"""Q, N, B, K and rate ramp in units of rad and s."""


def repeat(fmu: GyroFmu, seed: int) -> dict[str, tuple[float, float, float]]:
    """One record of each mixture; the gyro is not used."""
    found = {}
    for number, (title, mixture) in enumerate(MIXTURES.items()):
        angle = noisy_angle(SAMPLES, mixture, np.random.default_rng([number, seed]))
        noises = estimate_noise(angle, 1.0)
        for (name, letter), truth in zip(LETTERS.items(), mixture, strict=False):
            if truth:
                coefficient = getattr(noises, name)
                found[f"{letter} of {title}"] = (truth, coefficient.low, coefficient.high)
        ramp = estimate_rate_ramp(angle, 1.0, noises)
        found[f"rate ramp of {title}"] = (mixture[4], ramp.low, ramp.high)
    return found
