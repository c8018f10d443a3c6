"""Levels of noise as drawn; what is believed is not found again."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.common.units import ARCSEC, DEG_PER_H, DEG_PER_SQRT_H, HOUR
from pyhrg.gap.effects.catalogue import NOISES
from pyhrg.gap.evidence.noise.noise_levels import AngleRecord, alike
from pyhrg.gap.evidence.noise.noise_search import noise_found, told_apart
from pyhrg.gap.whitening.noise_draws import drawn
from pyhrg.gap.whitening.whitening import Correlated, SlowNoise

BELIEVED = SlowNoise(0.036 * ARCSEC, walk=3e-4 * DEG_PER_SQRT_H)
ROWS = (3000, 2000)


def records(noise: SlowNoise, seed: int) -> list[AngleRecord]:
    generator = np.random.default_rng(seed)
    return [AngleRecord(drawn(noise, n, 1.0, generator), np.ones(n)) for n in ROWS]


PLANTED = [
    ("angle_random_walk", replace(BELIEVED, walk=6e-4 * DEG_PER_SQRT_H), "walk"),
    ("rate_random_walk", replace(BELIEVED, rate_walk=0.03 * DEG_PER_H / HOUR**0.5), "rate_walk"),
    ("bias_instability", replace(BELIEVED, flicker=1e-2 * DEG_PER_H), "flicker"),
    ("angle_white_noise", replace(BELIEVED, white=0.08 * ARCSEC), "white"),
]


@pytest.mark.parametrize("seed", [1, 2])
@pytest.mark.parametrize(("name", "noise", "part"), PLANTED)
def test_a_noise_is_found_alone(name: str, noise: SlowNoise, part: str, seed: int) -> None:
    """By its level too: within twice the 95 % interval, so that 8 of 8 hold."""
    given = records(noise, seed)
    (added,) = told_apart(noise_found(given, BELIEVED), given, BELIEVED).added
    assert added.effect.name == name
    assert added.equivalents == ()
    half = np.log(added.interval[1] / added.interval[0]) / 2
    assert abs(np.log(added.total / getattr(noise, part))) < 2 * half


@pytest.mark.parametrize("seed", range(4))
def test_the_believed_noise_is_enough(seed: int) -> None:
    found = noise_found(records(BELIEVED, seed), BELIEVED)
    assert found.added == ()
    assert found.nameless is None
    assert alike(found.noise, BELIEVED) or found.noise.walk == pytest.approx(BELIEVED.walk, rel=0.1)


@pytest.mark.parametrize("seed", [1, 2])
def test_weak_noises_that_these_records_cannot_tell_apart_are_a_class(seed: int) -> None:
    weak = replace(BELIEVED, rate_walk=0.002 * DEG_PER_H / HOUR**0.5)
    given = records(weak, seed)
    (added,) = told_apart(noise_found(given, BELIEVED), given, BELIEVED).added
    assert {added.effect.name, *added.equivalents} == {"rate_random_walk", "bias_instability"}


def test_rivals_are_weighed_on_the_same_records() -> None:
    """Whatever the odds were when the noise was found, with less taken out of the records."""
    given = records(replace(BELIEVED, flicker=1e-2 * DEG_PER_H), 1)
    found = noise_found(given, BELIEVED)
    low = replace(found, added=(replace(found.added[0], log_odds=1.0),))
    assert told_apart(low, given, BELIEVED).added[0].equivalents == ()


LASTING = [Correlated(0.05 * DEG_PER_H, 100.0, True), Correlated(0.1 * ARCSEC, 30.0, False)]


@pytest.mark.parametrize("seed", [1, 2])
@pytest.mark.parametrize("correlated", LASTING)
def test_a_noise_that_the_catalogue_lacks_has_no_name(correlated: Correlated, seed: int) -> None:
    found = noise_found(records(replace(BELIEVED, correlated=correlated), seed), BELIEVED)
    assert found.added == ()
    assert found.nameless is not None
    assert found.nameless.correlated.of_rate == correlated.of_rate
    assert found.nameless.correlated.lag == pytest.approx(correlated.lag, rel=3)


@pytest.mark.parametrize("seed", [1, 2])
@pytest.mark.parametrize(("name", "noise", "part"), PLANTED)
def test_a_noise_that_is_left_out_has_no_name(
    name: str, noise: SlowNoise, part: str, seed: int
) -> None:
    others = [effect for effect in NOISES if effect.name != name]
    found = noise_found(records(noise, seed), BELIEVED, others)
    assert found.nameless is not None
    assert found.nameless.log_odds > 2
