"""Noise and responses of the angle compared: each planted one gets its own name."""

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC, DEG_PER_H, DEG_PER_SQRT_H, HOUR
from pyhrg.device.device import Device
from pyhrg.gap.effects.catalogue import EFFECTS, NOISES, Effect, NoiseEffect
from pyhrg.gap.effects.coordinates import compute_coordinates
from pyhrg.gap.effects.jump import Jump
from pyhrg.gap.effects.linear_test import LinearTest
from pyhrg.gap.evidence.evidence import Fit
from pyhrg.gap.evidence.hypothesis import rank_under_noise
from pyhrg.gap.evidence.noise.noise_hypothesis import AddedNoise, NoiseHypothesis
from pyhrg.gap.evidence.posterior import Posterior, average_posteriors, compare_noises
from pyhrg.gap.evidence.search import Ranking
from pyhrg.gap.replay.observations import CHANNELS, observe_test
from pyhrg.gap.whitening.channel_noise import build_angle_noise
from pyhrg.gap.whitening.whitening import CorrelatedNoise, NoiseModel, draw_noise
from pyhrg.records.campaign import Test
from tests.pyhrg.gap.made_up import flat_derivatives
from tests.pyhrg.records.made_up import made_up_log

BELIEVED = Device(angle_random_walk=3e-4 * DEG_PER_SQRT_H, angle_white_noise=0.036 * ARCSEC)
SILENT = EFFECTS["g_sensitive_gain"]
"""An effect that these tests can't see; it stands for the catalogue."""
ROWS = 3000
TIME = np.arange(ROWS) * 1.0
NOTHING = np.zeros(ROWS)
WALKING = replace(build_angle_noise(BELIEVED), rate_random_walk=0.03 * DEG_PER_H / HOUR**0.5)
NO_FIT = Fit((), 0.0, 0.0, (), ())
SEED = 1
WHITE = 1e-6
"""Noise of the other channels."""


def part_of(angle: Array, seed: int) -> LinearTest:
    test = observe_test(Test(f"test-{seed}", "static", "fit", made_up_log(ROWS)), BELIEVED)
    generator = np.random.default_rng(seed)
    residual = {name: generator.normal(0, WHITE, ROWS) for name in CHANNELS}
    sensitivities: dict[Effect, dict[str, Array]] = {
        SILENT: {n: np.zeros((ROWS, 1)) for n in CHANNELS}
    }
    where = compute_coordinates(test, vars(test.log), BELIEVED)
    left = {**residual, "gyro_angle": angle}
    simulated = {name: getattr(test.log, name) - left[name] for name in CHANNELS}
    return LinearTest(test, BELIEVED, simulated, left, sensitivities, where, flat_derivatives(ROWS))


def parts_of(noise: NoiseModel, seed: int, added: Array) -> list[LinearTest]:
    """Posterior of two power-ons with this noise; one has something added to its angle."""
    generator = np.random.default_rng(seed)
    angles = [draw_noise(noise, ROWS, 1.0, generator) for _ in range(2)]
    angles[1] = angles[1] + added
    return [part_of(angle, 10 * seed + i) for i, angle in enumerate(angles)]


def found(
    noise: NoiseModel, added: Array = NOTHING, noises: Sequence[NoiseEffect] = NOISES
) -> Posterior:
    parts = parts_of(noise, SEED, added)
    first = rank_under_noise(NoiseHypothesis(build_angle_noise(BELIEVED), ()), parts)
    return compare_noises(first, parts, noises)


def test_a_walking_rate_is_noise() -> None:
    posterior = found(WALKING)
    assert [added.effect.name for added in posterior.best.noise.added] == ["rate_random_walk"]
    assert posterior.best.ranking.best.groups == ()
    kinds = [one.noise.kind for one in posterior.hypotheses]
    assert len(set(kinds)) == len(kinds)
    assert sum(posterior.probabilities) == pytest.approx(1.0)


def test_a_bias_is_no_noise() -> None:
    hypothesis = found(build_angle_noise(BELIEVED), 0.02 * DEG_PER_H * TIME).best
    assert hypothesis.noise.added == ()
    assert hypothesis.noise.unnamed is None
    assert len(hypothesis.ranking.best.groups) == 1


def test_a_jump_of_the_bias_is_no_walk() -> None:
    jump = 0.02 * DEG_PER_H * np.maximum(TIME - 1234.0, 0.0)
    posterior = found(build_angle_noise(BELIEVED), jump)
    assert posterior.best.noise.added == ()
    (group,) = posterior.best.ranking.best.groups
    assert isinstance(group, Jump)
    ((test, time),) = group.times
    assert test == f"test-{10 * SEED + 1}"
    assert time == pytest.approx(1234.0, abs=60.0)
    assert posterior.unknown_probability > 0.99


def test_a_step_of_the_angle_is_no_walk() -> None:
    posterior = found(build_angle_noise(BELIEVED), 5 * ARCSEC * (TIME > 1234.0))
    assert posterior.best.noise.added == ()
    (group,) = posterior.best.ranking.best.groups
    assert isinstance(group, Jump)
    assert group.kind in ("pattern", "output")
    assert group.times == ((f"test-{10 * SEED + 1}", 1236.0),)
    assert posterior.unknown_probability > 0.99


def test_the_stated_noise_is_enough() -> None:
    posterior = found(build_angle_noise(BELIEVED))
    assert posterior.best.noise.added == ()
    assert posterior.best.ranking.best.groups == ()
    assert posterior.unknown_probability < 0.1


def test_a_walk_that_the_catalogue_lacks_is_unnamed() -> None:
    others = [noise for noise in NOISES if noise.name != "rate_random_walk"]
    posterior = found(WALKING, noises=others)
    assert posterior.unknown_probability > 0.99


def test_probabilities_are_those_of_all_hypotheses() -> None:
    plain = rank_under_noise(
        NoiseHypothesis(build_angle_noise(BELIEVED), ()), parts_of(WALKING, 1, NOTHING)
    )
    walk = AddedNoise(NOISES[1], 1.0, (0.5, 2.0), math.log(9.0), 0.0)
    named = Ranking((Fit((SILENT,), 0.0, 0.0, (np.ones(1),), (np.eye(1),)),), (1.0,), 0.0)
    walks = replace(
        plain, noise=NoiseHypothesis(WALKING, (walk,)), ranking=Ranking((NO_FIT,), (1.0,), 0.0)
    )
    silent = replace(plain, ranking=named)
    posterior = Posterior((walks, silent), (0.6, 0.4))
    assert posterior.probability("rate_random_walk") == pytest.approx(0.6)
    assert posterior.probability(SILENT.name) == pytest.approx(0.4)
    assert posterior.probability("rate_random_walk", SILENT.name) == pytest.approx(1.0)
    assert posterior.list_equivalents("rate_random_walk") == (SILENT.name,)
    last = Posterior((silent,), (1.0,))
    average = average_posteriors([posterior, last])
    assert average.best is silent
    assert average.probability("rate_random_walk") == pytest.approx(0.3)
    assert average.probability(SILENT.name) == pytest.approx(0.7)
    assert sum(average.probabilities) == pytest.approx(1.0)
    assert Posterior((walks, silent), (0.96, 0.04)).list_equivalents("rate_random_walk") == ()
    assert Posterior((silent, walks), (0.6, 0.4)).list_equivalents(SILENT.name) == (
        "rate_random_walk",
    )


@pytest.mark.parametrize("correlated", [CorrelatedNoise(0.1 * ARCSEC, 30.0, of_rate=False)])
def test_an_unnamed_noise_stays_a_noise(correlated: CorrelatedNoise) -> None:
    posterior = found(replace(build_angle_noise(BELIEVED), correlated=(correlated,)))
    assert posterior.best.noise.unnamed is not None
    assert posterior.best.ranking.best.groups == ()
    assert posterior.unknown_probability > 0.9


def test_noise_beside_a_large_bias_is_noise() -> None:
    """The model error of a large response does not depend on the noise hypothesis."""
    noise = replace(build_angle_noise(BELIEVED), angle_random_walk=2 * BELIEVED.angle_random_walk)
    posterior = found(noise, 1.0 * DEG_PER_H * (TIME + 1.0))
    assert [added.effect.name for added in posterior.best.noise.added] == ["angle_random_walk"]
    assert len(posterior.best.ranking.best.groups) == 1
