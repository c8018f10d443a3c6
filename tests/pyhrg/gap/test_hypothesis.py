"""What wanders is noise where noise explains it; a bias of the angle is none."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from pyhrg.campaign import Test
from pyhrg.device import Device
from pyhrg.gap.catalogue import EFFECTS, Effect
from pyhrg.gap.channel_noise import angle_noise
from pyhrg.gap.design import Evidence
from pyhrg.gap.hypothesis import Hypothesis, ranked_under, weighed
from pyhrg.gap.noise_draws import drawn
from pyhrg.gap.noise_search import NoiseFound
from pyhrg.gap.observations import CHANNELS, observed
from pyhrg.gap.unknown import coordinates
from pyhrg.gap.whitening import SlowNoise
from pyhrg.units import ARCSEC, DEG_PER_H, DEG_PER_SQRT_H, HOUR
from tests.pyhrg.records.made_up import made_up_log

Array = NDArray[np.float64]
BELIEVED = Device(angle_random_walk=3e-4 * DEG_PER_SQRT_H, pickoff_noise=0.036 * ARCSEC)
SILENT = EFFECTS["g_sensitive_gain"]
"""Stands for the catalogue; these tests don't show it."""
ROWS = 3000
WHITE = 1e-6
"""Noise of the other channels."""


def part_of(angle: Array, seed: int) -> Evidence:
    test = observed(Test(f"test-{seed}", "static", "fit", made_up_log(ROWS)), BELIEVED)
    generator = np.random.default_rng(seed)
    residual = {name: generator.normal(0, WHITE, ROWS) for name in CHANNELS}
    nothing = {name: np.zeros(ROWS) for name in CHANNELS}
    secants: dict[Effect, dict[str, Array]] = {SILENT: {n: np.zeros((ROWS, 1)) for n in CHANNELS}}
    where = coordinates(test, np.zeros(ROWS), BELIEVED)
    left = {**residual, "gyro_angle": angle}
    return Evidence(test, BELIEVED, nothing, left, secants, where, nothing, 0.277)


def found(noise: SlowNoise, rate: float, seed: int) -> Hypothesis:
    """Two power-ons of a gyro with this noise and a bias, rad/s, in one of them."""
    generator = np.random.default_rng(seed)
    angles = [drawn(noise, ROWS, 1.0, generator) for _ in range(2)]
    angles[1] = angles[1] + rate * np.arange(ROWS)
    parts = [part_of(angle, 10 * seed + i) for i, angle in enumerate(angles)]
    first = ranked_under(NoiseFound(angle_noise(BELIEVED), ()), BELIEVED, parts)
    return weighed(first, BELIEVED, parts)


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_walking_rate_is_noise(seed: int) -> None:
    walking = replace(angle_noise(BELIEVED), rate_walk=0.03 * DEG_PER_H / HOUR**0.5)
    hypothesis = found(walking, 0.0, seed)
    assert [added.effect.name for added in hypothesis.noise.added] == ["rate_random_walk"]
    assert hypothesis.ranked.best.groups == ()


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_bias_is_no_noise(seed: int) -> None:
    hypothesis = found(angle_noise(BELIEVED), 0.02 * DEG_PER_H, seed)
    assert hypothesis.noise.added == ()
    assert len(hypothesis.ranked.best.groups) == 1


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_believed_noise_is_enough(seed: int) -> None:
    hypothesis = found(angle_noise(BELIEVED), 0.0, seed)
    assert hypothesis.noise.added == ()
    assert hypothesis.ranked.best.groups == ()
