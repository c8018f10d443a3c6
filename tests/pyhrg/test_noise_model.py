"""Coefficients are found within their intervals as often as the intervals say."""

import numpy as np
import pytest
from scipy.stats import binom, norm

from fmu_build.bundle import built_fmu
from fmu_build.roots import ROOTS
from pyhrg.fmu import GyroFmu
from pyhrg.noise_model import NoiseCoefficients, NoiseError, critical_ratio, identify
from tests.pyhrg.noises import noisy_angle

NAMES = list(NoiseCoefficients.__dataclass_fields__)
Mixture = tuple[float, float, float, float, float]
REPEATS = 30


@pytest.mark.parametrize("mixture", [(1, 0.3, 0, 0, 0), (0, 1, 0.5, 0, 0), (1, 0.1, 0, 0.002, 0)])
def test_intervals_hold_what_was_put_in(mixture: Mixture) -> None:
    """No fewer than 95 % of 30 but for a chance of 1e-4 each; `benchmarks` has the many."""
    held = np.zeros(5)
    for seed in range(REPEATS):
        found = identify(noisy_angle(2000, mixture, np.random.default_rng([1, seed])), 1.0)
        all_found = [getattr(found, name) for name in NAMES]
        held += [c.low <= x <= c.high for c, x in zip(all_found, mixture, strict=True)]
    assert np.all(held >= binom.ppf(1e-4, REPEATS, 0.95)), held


def test_what_is_large_is_told_from_zero_and_what_is_not_there_is_bounded() -> None:
    found = identify(noisy_angle(20_000, (1, 0.3, 0, 0, 0), np.random.default_rng(2)), 1.0)
    assert [getattr(found, name).present for name in NAMES] == [True, True, False, False, False]
    assert found.white_angle.high / found.white_angle.low < 1.05
    assert found.bias_instability.low == 0 < found.bias_instability.high < 0.1


def test_ramp_is_not_taken_for_a_walk() -> None:
    still = noisy_angle(4000, (0, 1, 0, 0, 0), np.random.default_rng(3))
    found, ramped = identify(still, 1.0), identify(still + 1e-3 * np.arange(4000) ** 2, 1.0)
    assert ramped.rate_ramp.low < 2e-3 < ramped.rate_ramp.high
    assert ramped.rate_random_walk.high == pytest.approx(found.rate_random_walk.high, rel=1e-3)


def test_coefficients_have_their_units() -> None:
    """A record read at ten times the pace: Q stays, N grows by sqrt(10), B by 10, ..."""
    angle = noisy_angle(4000, (5, 1, 0.5, 0.02, 0), np.random.default_rng(4))
    slow, fast = identify(angle, 1.0), identify(angle, 0.1)
    for name, power in zip(NAMES, (0, 0.5, 1, 1.5, 2), strict=True):
        assert getattr(fast, name).high == pytest.approx(
            10**power * getattr(slow, name).high, rel=1e-6
        )


@pytest.mark.parametrize("truth", [0.0, 0.3, 1.0, 1.9, 3.0])
def test_critical_ratio_covers_a_mean_that_is_not_negative(truth: float) -> None:
    seen = norm.rvs(truth, size=100_000, random_state=5)
    ratio = (seen - truth) ** 2 - (seen - np.maximum(seen, 0)) ** 2
    covered = np.mean(ratio <= critical_ratio(truth))
    assert covered == pytest.approx(0.95, abs=4 * np.sqrt(0.95 * 0.05 / 100_000))


def test_the_gyros_own_noise_is_found() -> None:
    """HRGSlow at rest; each interval misses with a chance of 5 %, three times as wide hardly."""
    angle_walk, flicker, reading, bryan = 1e-7, 2e-8, 3e-7, 0.277
    parameters = {
        "noise.angleRandomWalk": angle_walk**2,
        "noise.pickOff": (2 * bryan * reading) ** 2 * 1e-3,
        "noise.biasInstability": flicker,
        "samplePeriod": 1.0,
    }
    with GyroFmu(built_fmu(root=ROOTS["HRGSlow"])).power_on(parameters, 1, 0.3) as gyro:
        found = identify(gyro.drive(np.zeros(20_000), 1.0), 1.0)
    expected = (reading, angle_walk, flicker)
    for name, value in zip(NAMES, expected, strict=False):
        c = getattr(found, name)
        assert c.value - 3 * (c.value - c.low) < value < c.value + 3 * (c.high - c.value), name


@pytest.mark.parametrize(
    ("angle", "interval", "message"),
    [
        (np.zeros(10), 1.0, r"angles are of shape \(10,\), expected \(256 or more,\)"),
        (np.zeros((300, 2)), 1.0, r"angles are of shape \(300, 2\)"),
        (np.full(300, np.inf), 1.0, "angle 0 is inf"),
        (np.arange(300.0), 0.0, "interval is 0.0 s, expected more than 0"),
        (np.arange(300.0) ** 2, 1.0, "no noise beyond rounding"),
    ],
)
def test_bad_record_is_refused(angle: np.ndarray, interval: float, message: str) -> None:
    with pytest.raises(NoiseError, match=message):
        identify(angle, interval)
