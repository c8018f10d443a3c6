"""Verdicts on simulated records: nothing, one term more, and what no term is."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from scipy.stats import binomtest

from pyhrg.common.units import ARCSEC, DEG_PER_H, DEG_PER_SQRT_H
from pyhrg.gap.static_record.belief import Belief
from pyhrg.gap.static_record.fit.diagnosis import ChannelDiagnosis, diagnose_channel
from pyhrg.gap.static_record.record import Channel, channel_from_increments
from pyhrg.gap.static_record.terms import GYRO
from tests.pyhrg.noises import Mixture, noisy_angle

N = 4096
WHITE = Belief(np.array([1.0, 0.3, 0.0, 0.0]))
RECORDS = 30


def diagnosis(mixture: Mixture, belief: Belief = WHITE, seed: int = 0) -> ChannelDiagnosis:
    angle = noisy_angle(N, mixture, np.random.default_rng([11, seed]))
    return diagnose_channel(Channel("gyro", GYRO, 1.0, angle), belief, seed=seed)


def test_false_alarms() -> None:
    """n = 30, seed 11: the exact interval includes 2 % or lies below. 200 records of each belief:
    `benchmarks/static_record.py`."""
    belief = Belief(np.array([1.0, 0.3, 0.0, 0.003]))
    found = [diagnosis((1.0, 0.3, 0.0, 0.003, 0.0), belief, seed) for seed in range(RECORDS)]
    alarms = sum(d.verdict != "no_gap" for d in found)
    assert binomtest(alarms, RECORDS).proportion_ci().low <= 0.02


def test_a_held_out_half_that_differs_is_a_gap() -> None:
    """The fitted half is as believed, so that it alone raised no alarm; the other has 30 % more
    white noise."""
    generator = np.random.default_rng([11, 3])
    noise = generator.standard_normal((2, N))
    walk = np.cumsum(0.3 * noise[1])
    steady, changed = (
        diagnose_channel(Channel("gyro", GYRO, 1.0, grown * noise[0] + walk), WHITE)
        for grown in (1.0, np.repeat([1.0, 1.3], N // 2))
    )
    assert steady.verdict == "no_gap"
    assert steady.holdout_p_value > 0.01
    assert changed.ranking.log_ratio == pytest.approx(steady.ranking.log_ratio)
    assert changed.verdict == "unexplained"
    assert changed.holdout_p_value < 1e-4


@cache
def diagnosis_of_missing(effect: str, seed: int) -> ChannelDiagnosis:
    return diagnosis(MISSING[effect][0], seed=seed)


MISSING: dict[str, tuple[Mixture, float]] = {
    "angle_white_noise": ((2.5, 0.3, 0, 0, 0), 2.5 / ARCSEC),
    "angle_random_walk": ((1, 0.8, 0, 0, 0), 0.8 / DEG_PER_SQRT_H),
    "bias_instability": ((1, 0.3, 0.3, 0, 0), 0.3 / DEG_PER_H),
    "rate_random_walk": ((1, 0.3, 0, 0.03, 0), 0.03 * 60 / DEG_PER_H),
}


@pytest.mark.parametrize("effect", MISSING)
def test_a_missing_term_is_named(effect: str) -> None:
    found = diagnosis_of_missing(effect, 0)
    assert [cause.term.effect for cause in found.causes] == [effect]
    assert found.causes[0].probability > 0.5
    assert found.verdict in ("explained", "ambiguous")
    assert found.holdout.after.log_rms < 0.6 * found.holdout.before.log_rms
    assert found.holdout.before.p_value < 1e-6 < found.holdout.after.p_value


def test_intervals_cover() -> None:
    """n = 12, seed 11: the exact interval of the share that covers includes 95 %."""
    covered = []
    for effect, (_, level) in MISSING.items():
        for seed in range(3):
            named = {c.term.effect: c for c in diagnosis_of_missing(effect, seed).causes}
            covered += [named[effect].low < level < named[effect].high] if effect in named else []
    assert len(covered) >= 11
    assert binomtest(sum(covered), len(covered)).proportion_ci().high >= 0.95


def test_a_ramp_is_named() -> None:
    found = diagnosis((1, 0.3, 0, 0, 1e-4))
    assert [cause.term.effect for cause in found.causes] == ["rate_ramp"]
    assert found.causes[0].low < 1e-4 * 3600 / DEG_PER_H < found.causes[0].high


def test_a_ramp_beside_a_believed_one_is_stated_whole() -> None:
    found = diagnosis((1, 0.3, 0, 0, 1.5e-4), replace(WHITE, ramp=5e-5))
    assert found.causes[0].low < 1.5e-4 * 3600 / DEG_PER_H < found.causes[0].high


def test_a_line_is_no_noise() -> None:
    """Its period believed, it is no gap."""
    angle = noisy_angle(N, (1, 0.3, 0, 0, 0), np.random.default_rng(12))
    angle += 1.0 * np.sin(2 * np.pi * np.arange(N) / 7.3)
    channel = Channel("gyro", GYRO, 1.0, angle)
    found = diagnose_channel(channel, WHITE)
    assert found.verdict == "unexplained"
    assert found.causes == ()
    assert found.ranking.get_unknown_probability("periodic signal") > 0.5
    known = Belief(WHITE.levels, periods=(7.3,))
    assert diagnose_channel(channel, known).verdict == "no_gap"


def test_noise_that_grows_is_no_term() -> None:
    angle = noisy_angle(N, (1, 0.3, 0, 0, 0), np.random.default_rng(13))
    angle[N // 4 :] += 2 * np.random.default_rng(14).standard_normal(N - N // 4)
    found = diagnose_channel(Channel("gyro", GYRO, 1.0, angle), WHITE)
    assert found.verdict == "unexplained"
    assert found.ranking.get_unknown_probability("noise that changes with time") > 0.5


def test_temperature_is_named() -> None:
    generator = np.random.default_rng(15)
    temperature = 300 + 5 * np.sin(np.arange(N) / 150)
    angle = noisy_angle(N, (1, 0.3, 0, 0, 0), generator) + 0.02 * np.cumsum(temperature - 300)
    found = diagnose_channel(Channel("gyro", GYRO, 1.0, angle, temperature), WHITE)
    assert [cause.term.effect for cause in found.causes] == ["bias_temperature"]
    assert found.causes[0].low < 0.02 / DEG_PER_H < found.causes[0].high


def test_a_grid_is_quantisation() -> None:
    """Of the angle: readings are its steps; white noise of the same size has no grid."""
    generator = np.random.default_rng(16)
    walk = np.cumsum(0.3 * generator.standard_normal(N))
    belief = Belief(np.array([0.05, 0.3, 0.0, 0.0]))
    counted = channel_from_increments("gyro", GYRO, 1.0, np.diff(np.round(walk)))
    noisy = channel_from_increments(
        "gyro", GYRO, 1.0, np.diff(walk + generator.standard_normal(N) / np.sqrt(12))
    )
    for channel, effect in ((counted, "angle_quantisation"), (noisy, "angle_white_noise")):
        found = diagnose_channel(channel, belief)
        assert [cause.term.effect for cause in found.causes] == [effect]


def test_ceilings_hold_under_anything_else() -> None:
    """n = 2: the true level is below, whatever motion is added."""
    for seed in range(2):
        angle = noisy_angle(N, (1, 0.3, 0, 0, 0), np.random.default_rng([17, seed]))
        angle += 5 * np.sin(2 * np.pi * np.arange(N) / 9.1)
        found = diagnose_channel(Channel("gyro", GYRO, 1.0, angle), WHITE)
        assert found.ceilings["angle_white_noise_arcsec"] > 1 / ARCSEC
        assert found.ceilings["angle_random_walk_deg_sqrt_h"] > 0.3 / DEG_PER_SQRT_H
