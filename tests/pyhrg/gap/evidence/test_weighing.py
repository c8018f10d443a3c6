"""What wanders is noise where noise explains it; a bias of the angle is none."""

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from pyhrg.common.units import ARCSEC, DEG_PER_H, DEG_PER_SQRT_H, HOUR
from pyhrg.device.device import Device
from pyhrg.gap.effects.candidate_terms import coordinates
from pyhrg.gap.effects.catalogue import EFFECTS, NOISES, Effect, NoiseEffect
from pyhrg.gap.effects.design import LinearTest
from pyhrg.gap.effects.jump import Jump
from pyhrg.gap.evidence.evidence import Fit
from pyhrg.gap.evidence.hypothesis import ranked_under
from pyhrg.gap.evidence.noise.noise_search import AddedNoise, NoiseFound
from pyhrg.gap.evidence.search import Ranked
from pyhrg.gap.evidence.weighing import Weighed, weighed
from pyhrg.gap.replay.observations import CHANNELS, observed
from pyhrg.gap.whitening.channel_noise import angle_noise
from pyhrg.gap.whitening.noise_draws import drawn
from pyhrg.gap.whitening.whitening import Correlated, SlowNoise
from pyhrg.records.campaign import Test
from tests.pyhrg.records.made_up import made_up_log

Array = NDArray[np.float64]
BELIEVED = Device(angle_random_walk=3e-4 * DEG_PER_SQRT_H, pickoff_noise=0.036 * ARCSEC)
SILENT = EFFECTS["g_sensitive_gain"]
"""Stands for the catalogue; these tests don't show it."""
ROWS = 3000
TIME = np.arange(ROWS) * 1.0
NOTHING = np.zeros(ROWS)
WALKING = replace(angle_noise(BELIEVED), rate_walk=0.03 * DEG_PER_H / HOUR**0.5)
NO_FIT = Fit((), 0.0, 0.0, (), np.zeros((0, 0)))
WHITE = 1e-6
"""Noise of the other channels."""


def part_of(angle: Array, seed: int) -> LinearTest:
    test = observed(Test(f"test-{seed}", "static", "fit", made_up_log(ROWS)), BELIEVED)
    generator = np.random.default_rng(seed)
    residual = {name: generator.normal(0, WHITE, ROWS) for name in CHANNELS}
    nothing = {name: np.zeros(ROWS) for name in CHANNELS}
    secants: dict[Effect, dict[str, Array]] = {SILENT: {n: np.zeros((ROWS, 1)) for n in CHANNELS}}
    where = coordinates(test, np.zeros(ROWS), np.ones(ROWS), BELIEVED)
    left = {**residual, "gyro_angle": angle}
    return LinearTest(test, BELIEVED, nothing, left, secants, where, nothing, 0.277)


def parts_of(noise: SlowNoise, seed: int, added: Array) -> list[LinearTest]:
    """Two power-ons of a gyro with this noise; in one of them something is added to the angle."""
    generator = np.random.default_rng(seed)
    angles = [drawn(noise, ROWS, 1.0, generator) for _ in range(2)]
    angles[1] = angles[1] + added
    return [part_of(angle, 10 * seed + i) for i, angle in enumerate(angles)]


def found(
    noise: SlowNoise, seed: int, added: Array = NOTHING, noises: Sequence[NoiseEffect] = NOISES
) -> Weighed:
    parts = parts_of(noise, seed, added)
    first = ranked_under(NoiseFound(angle_noise(BELIEVED), ()), BELIEVED, parts)
    return weighed(first, BELIEVED, parts, noises)


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_walking_rate_is_noise(seed: int) -> None:
    told = found(WALKING, seed)
    assert [added.effect.name for added in told.best.noise.added] == ["rate_random_walk"]
    assert told.best.ranked.best.groups == ()
    kinds = [one.noise.kind for one in told.hypotheses]
    assert len(set(kinds)) == len(kinds)
    assert sum(told.probabilities) == pytest.approx(1.0)


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_bias_is_no_noise(seed: int) -> None:
    hypothesis = found(angle_noise(BELIEVED), seed, 0.02 * DEG_PER_H * TIME).best
    assert hypothesis.noise.added == ()
    assert hypothesis.noise.nameless is None
    assert len(hypothesis.ranked.best.groups) == 1


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_jump_of_the_bias_is_no_walk(seed: int) -> None:
    jump = 0.02 * DEG_PER_H * np.maximum(TIME - 1234.0, 0.0)
    told = found(angle_noise(BELIEVED), seed, jump)
    assert told.best.noise.added == ()
    (group,) = told.best.ranked.best.groups
    assert isinstance(group, Jump)
    ((test, time),) = group.times
    assert test == f"test-{10 * seed + 1}"
    assert time == pytest.approx(1234.0, abs=60.0)
    assert told.unknown_probability > 0.99


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_step_of_the_angle_is_no_walk(seed: int) -> None:
    told = found(angle_noise(BELIEVED), seed, 5 * ARCSEC * (TIME > 1234.0))
    assert told.best.noise.added == ()
    (group,) = told.best.ranked.best.groups
    assert isinstance(group, Jump)
    assert group.kind in ("pattern", "output")
    assert group.times == ((f"test-{10 * seed + 1}", 1236.0),)
    assert told.unknown_probability > 0.99


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_believed_noise_is_enough(seed: int) -> None:
    told = found(angle_noise(BELIEVED), seed)
    assert told.best.noise.added == ()
    assert told.best.ranked.best.groups == ()
    assert told.unknown_probability < 0.1


@pytest.mark.parametrize("seed", [1, 2])
def test_a_walk_that_has_left_the_catalogue_has_no_name(seed: int) -> None:
    others = [noise for noise in NOISES if noise.name != "rate_random_walk"]
    told = found(WALKING, seed, noises=others)
    assert told.unknown_probability > 0.99


def test_probabilities_are_those_of_all_hypotheses() -> None:
    plain = ranked_under(
        NoiseFound(angle_noise(BELIEVED), ()), BELIEVED, parts_of(WALKING, 1, NOTHING)
    )
    walk = AddedNoise(NOISES[1], 1.0, (0.5, 2.0), math.log(9.0), 0.0)
    named = Ranked((Fit((SILENT,), 0.0, 0.0, (np.ones(1),), np.eye(1)),), (1.0,), 0.0)
    walks = replace(
        plain, noise=NoiseFound(WALKING, (walk,)), ranked=Ranked((NO_FIT,), (1.0,), 0.0)
    )
    silent = replace(plain, ranked=named)
    told = Weighed((walks, silent), (0.6, 0.4))
    assert told.probability("rate_random_walk") == pytest.approx(0.6)
    assert told.probability(SILENT.name) == pytest.approx(0.4)
    assert told.probability("rate_random_walk", SILENT.name) == pytest.approx(1.0)
    assert told.stand_ins("rate_random_walk") == (SILENT.name,)
    assert Weighed((walks, silent), (0.96, 0.04)).stand_ins("rate_random_walk") == ()
    assert Weighed((silent, walks), (0.6, 0.4)).stand_ins(SILENT.name) == ("rate_random_walk",)


@pytest.mark.parametrize("seed", [1, 2])
@pytest.mark.parametrize("correlated", [Correlated(0.1 * ARCSEC, 30.0, of_rate=False)])
def test_a_noise_without_a_name_stays_a_noise(correlated: Correlated, seed: int) -> None:
    told = found(replace(angle_noise(BELIEVED), correlated=correlated), seed)
    assert told.best.noise.nameless is not None
    assert told.best.ranked.best.groups == ()
    assert told.unknown_probability > 0.9


@pytest.mark.parametrize("seed", [1, 2])
def test_noise_beside_a_large_bias_is_noise(seed: int) -> None:
    """What a simulation gets wrong of a large response is the same whatever the noise."""
    noise = replace(angle_noise(BELIEVED), walk=2 * BELIEVED.angle_random_walk)
    told = found(noise, seed, 1.0 * DEG_PER_H * (TIME + 1.0))
    assert [added.effect.name for added in told.best.noise.added] == ["angle_random_walk"]
    assert len(told.best.ranked.best.groups) == 1
