"""Planted noises are found with their levels; stated noise is not found again."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from pyhrg.common.units import ARCSEC, DEG_PER_H, DEG_PER_SQRT_H, HOUR
from pyhrg.gap.effects.catalogue import NOISES, NoiseEffect
from pyhrg.gap.evidence.noise.noise_hypothesis import NoiseHypothesis
from pyhrg.gap.evidence.noise.noise_levels import are_equal
from pyhrg.gap.evidence.noise.noise_search import find_noise_equivalents, fit_rival_noises
from pyhrg.gap.evidence.residuals import Residual
from pyhrg.gap.whitening.whitening import CorrelatedNoise, NoiseModel, draw_noise

BELIEVED = NoiseModel(0.036 * ARCSEC, angle_random_walk=3e-4 * DEG_PER_SQRT_H)
ROWS = (3000, 2000)


def records(noise: NoiseModel, seed: int) -> list[Residual]:
    generator = np.random.default_rng(seed)
    return [
        Residual("", "gyro_angle", draw_noise(noise, n, 1.0, generator), np.ones(n), 1.0, noise)
        for n in ROWS
    ]


def fit_noise(
    residuals: Sequence[Residual], noises: Sequence[NoiseEffect] = NOISES
) -> NoiseHypothesis:
    """The most probable noise beyond the believed one."""
    return fit_rival_noises(residuals, BELIEVED, noises)[0]


PLANTED = [
    ("angle_random_walk", 6e-4 * DEG_PER_SQRT_H),
    ("rate_random_walk", 0.03 * DEG_PER_H / HOUR**0.5),
    ("bias_instability", 1e-2 * DEG_PER_H),
    ("angle_white_noise", 0.08 * ARCSEC),
]


@pytest.mark.parametrize("seed", [1, 2])
@pytest.mark.parametrize(("name", "level"), PLANTED)
def test_a_noise_is_found_alone(name: str, level: float, seed: int) -> None:
    """Its level lies within twice the 95 % interval, so that all 8 cases hold."""
    given = records(BELIEVED.at(name, level), seed)
    (added,) = find_noise_equivalents(fit_noise(given), given, BELIEVED).added
    assert added.effect.name == name
    assert added.equivalents == ()
    half = np.log(added.interval[1] / added.interval[0]) / 2
    assert abs(np.log(added.total / level)) < 2 * half


@pytest.mark.parametrize("seed", range(4))
def test_the_stated_noise_is_enough(seed: int) -> None:
    found = fit_noise(records(BELIEVED, seed))
    assert found.added == ()
    assert found.unnamed is None
    assert are_equal(found.noise, BELIEVED) or found.noise.angle_random_walk == pytest.approx(
        BELIEVED.angle_random_walk, rel=0.1
    )


@pytest.mark.parametrize("seed", [1, 2])
def test_weak_noises_that_these_records_cannot_separate_are_a_class(seed: int) -> None:
    weak = replace(BELIEVED, rate_random_walk=0.002 * DEG_PER_H / HOUR**0.5)
    given = records(weak, seed)
    (added,) = find_noise_equivalents(fit_noise(given), given, BELIEVED).added
    assert {added.effect.name, *added.equivalents} == {"rate_random_walk", "bias_instability"}


def test_equivalents_are_compared_on_the_same_records() -> None:
    """Equivalents do not depend on the log odds with which a noise was first found."""
    given = records(replace(BELIEVED, bias_instability=1e-2 * DEG_PER_H), 1)
    found = fit_noise(given)
    low = replace(found, added=(replace(found.added[0], log_odds=1.0),))
    assert find_noise_equivalents(low, given, BELIEVED).added[0].equivalents == ()


LASTING = [
    CorrelatedNoise(0.05 * DEG_PER_H, 100.0, True),
    CorrelatedNoise(0.1 * ARCSEC, 30.0, False),
]


@pytest.mark.parametrize("seed", [1, 2])
@pytest.mark.parametrize("correlated", LASTING)
def test_a_noise_that_the_catalogue_lacks_is_unnamed(
    correlated: CorrelatedNoise, seed: int
) -> None:
    found = fit_noise(records(replace(BELIEVED, correlated=(correlated,)), seed))
    assert found.added == ()
    assert found.unnamed is not None
    assert found.unnamed.correlated.of_rate == correlated.of_rate
    assert found.unnamed.correlated.lag == pytest.approx(correlated.lag, rel=3)


@pytest.mark.parametrize("seed", [1, 2])
@pytest.mark.parametrize(("name", "level"), PLANTED)
def test_a_noise_that_is_left_out_is_unnamed(name: str, level: float, seed: int) -> None:
    others = [effect for effect in NOISES if effect.name != name]
    found = fit_noise(records(BELIEVED.at(name, level), seed), others)
    assert found.unnamed is not None
