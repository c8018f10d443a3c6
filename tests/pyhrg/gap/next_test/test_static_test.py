"""A static test of the suggested duration separates noises that shorter records don't."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.common.units import ARCSEC, DEG_PER_H, DEG_PER_SQRT_H, HOUR
from pyhrg.gap.effects.catalogue import NOISES
from pyhrg.gap.evidence.noise.noise_hypothesis import NoiseHypothesis
from pyhrg.gap.evidence.noise.noise_search import find_noise_equivalents, fit_rival_noises
from pyhrg.gap.evidence.residuals import Residual
from pyhrg.gap.next_test.candidate_tests import LONG_ROWS
from pyhrg.gap.next_test.static_test import suggest_static_test
from pyhrg.gap.whitening.whitening import NoiseModel, draw_noise

BELIEVED = NoiseModel(0.036 * ARCSEC, 3e-4 * DEG_PER_SQRT_H)
WALKING = replace(BELIEVED, rate_random_walk=0.0008 * DEG_PER_H / HOUR**0.5)
FLICKERING = replace(BELIEVED, bias_instability=0.001 * DEG_PER_H)


def recorded(noise: NoiseModel, hours: float, seed: int) -> Residual:
    n = round(hours * HOUR / LONG_ROWS)
    angle = draw_noise(noise, n, LONG_ROWS, np.random.default_rng(seed))
    return Residual("", "gyro_angle", angle, np.full(n, LONG_ROWS), LONG_ROWS, BELIEVED)


def found(records: list[Residual]) -> NoiseHypothesis:
    return find_noise_equivalents(fit_rival_noises(records, BELIEVED, NOISES)[0], records, BELIEVED)


@pytest.mark.parametrize(
    ("noise", "name"), [(WALKING, "rate_random_walk"), (FLICKERING, "bias_instability")]
)
def test_after_the_suggested_hours_the_noise_is_named_alone(noise: NoiseModel, name: str) -> None:
    """Seeds 0 to 5: confounded in some records of an hour, in none after the suggested test."""
    asked = 0
    for seed in range(6):
        records = [recorded(noise, 1.0, 100 * seed + i) for i in range(4)]
        before = found(records)
        test = suggest_static_test(before, BELIEVED)
        assert (test is not None) == any(added.equivalents for added in before.added)
        if test is not None:
            asked += 1
            assert test.kind == "static"
            after = found([*records, recorded(noise, test.hours, 1000 + seed)])
            assert [added.effect.name for added in after.added] == [name]
            assert after.added[0].equivalents == ()
    assert asked >= 2


def test_without_equivalents_no_test_is_suggested() -> None:
    assert suggest_static_test(NoiseHypothesis(BELIEVED, ()), BELIEVED) is None
    assert {effect.name for effect in NOISES} >= {"rate_random_walk", "bias_instability"}
