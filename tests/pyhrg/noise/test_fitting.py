"""Coefficients are found within their intervals as often as the intervals say."""

import numpy as np
import pytest
from scipy.fft import dct
from scipy.stats import binom, norm

from fmu_build.bundle import build_fmu
from pyhrg.fmu import GyroFmu
from pyhrg.noise.coefficients import NoiseCoefficients, NoiseError
from pyhrg.noise.fitting import compute_critical_ratio, estimate_noise, fit_coefficients
from pyhrg.noise.likelihood import compute_misfit, compute_spectrum
from pyhrg.noise.ramp import estimate_rate_ramp
from tests.driving import drive
from tests.pyhrg.noises import Mixture, noisy_angle

NAMES = list(NoiseCoefficients.__dataclass_fields__)
REPEATS = 20
SAMPLES = 1000


@pytest.mark.parametrize("mixture", [(1, 1, 0, 0, 0), (0, 1, 1, 0, 0), (1, 0.3, 0, 0.02, 1e-2)])
def test_intervals_hold_what_was_put_in(mixture: Mixture) -> None:
    """In 95 % of 20 records less 3 sigma of the binomial (15 %), each of those that are there, and
    the rate ramp, which may be zero.

    The seed is fixed; `benchmarks/intervals/noise.py` has the thousands.
    """
    there = [(name, x) for name, x in zip(NAMES, mixture, strict=False) if x]
    held = dict.fromkeys((*(name for name, _ in there), "rate_ramp"), 0)
    for seed in range(REPEATS):
        angle = noisy_angle(SAMPLES, mixture, np.random.default_rng([1, seed]))
        found = estimate_noise(angle, 1.0)
        ramp = estimate_rate_ramp(angle, 1.0, found)
        held["rate_ramp"] += ramp.low <= mixture[4] <= ramp.high
        for name, truth in there:
            coefficient = getattr(found, name)
            held[name] += coefficient.low <= truth <= coefficient.high
    fewest = REPEATS * 0.95 - 3 * np.sqrt(REPEATS * 0.95 * 0.05)
    assert min(held.values()) >= fewest, held


def test_bound_of_what_is_not_there_excludes_it_seldom() -> None:
    """Negative control: flicker and rate random walk that are zero are told from zero in 5 % of 40
    records, in 18 % with a chance of 1e-3 each."""
    seen = np.zeros(2)
    for seed in range(40):
        angle = noisy_angle(SAMPLES, (1, 1, 0, 0, 0), np.random.default_rng([6, seed]))
        found = estimate_noise(angle, 1.0)
        seen += [found.bias_instability.present, found.rate_random_walk.present]
    assert np.all(seen <= binom.isf(1e-3, 40, 0.05)), seen


def test_what_is_large_is_told_from_zero_and_what_is_not_there_is_bounded() -> None:
    found = estimate_noise(noisy_angle(20_000, (1, 0.3, 0, 0, 0), np.random.default_rng(2)), 1.0)
    assert [getattr(found, name).present for name in NAMES] == [True, True, False, False]
    assert found.angle_white_noise.high / found.angle_white_noise.low < 1.05
    assert found.bias_instability.low == 0 < found.bias_instability.high < 0.1


def test_ramp_is_not_taken_for_a_walk() -> None:
    still = noisy_angle(4000, (0, 1, 0, 0, 0), np.random.default_rng(3))
    found, ramped = (
        estimate_noise(still, 1.0),
        estimate_noise(still + 1e-3 * np.arange(4000) ** 2, 1.0),
    )
    assert ramped.rate_random_walk.high == pytest.approx(found.rate_random_walk.high, rel=1e-3)


def test_trends_of_any_size_leave_no_trace() -> None:
    """Where they are named; a slow one that is not is taken for a rate random walk."""
    still = noisy_angle(2000, (1, 1, 0, 0, 0), np.random.default_rng(7))
    phase = np.arange(2000) / 40
    trends = [np.cos(phase), np.sin(phase), np.cos(phase / 100), np.sin(phase / 100)]
    moved = still + 100 * trends[0] - 1000 * trends[3]
    named, plain = (fit_coefficients([compute_spectrum(a, trends)], 1.0) for a in (moved, still))
    for name in NAMES:
        assert getattr(named, name).high == pytest.approx(getattr(plain, name).high, rel=1e-4)
    unnamed = estimate_noise(moved, 1.0)
    assert unnamed.rate_random_walk.low > plain.rate_random_walk.high


def test_a_trend_among_the_others_costs_nothing() -> None:
    angle = noisy_angle(1000, (1, 1, 0, 0, 0), np.random.default_rng(8))
    line = 5 * np.arange(1000.0) - 3
    with_line, without = compute_spectrum(angle, [line]).squares, compute_spectrum(angle).squares
    assert with_line == pytest.approx(without, abs=1e-12)
    assert (
        compute_spectrum(angle, [np.zeros(1000)]).products.shape
        == compute_spectrum(angle).products.shape
    )


def test_records_together_say_more_than_one() -> None:
    angles = [noisy_angle(1000, (1, 1, 0, 0, 0), np.random.default_rng([9, i])) for i in range(4)]
    one = estimate_noise(angles[0], 1.0).angle_random_walk
    four = fit_coefficients([compute_spectrum(angle) for angle in angles], 1.0).angle_random_walk
    assert four.high - four.low == pytest.approx((one.high - one.low) / 2, rel=0.2)


def test_restricted_likelihood_is_that_of_the_definition() -> None:
    """Change of the value, slope and information against dense algebra; one coefficient a band."""
    n = 34
    angle = noisy_angle(n, (1, 1, 0, 0.1, 0), np.random.default_rng(10))
    record = compute_spectrum(angle, [np.cos(np.arange(n))])
    assert np.all(record.bands.count == 1)
    strengths = np.array([1.0, 1.0, 0.1, 0.01])
    columns = np.column_stack([np.linspace(-1, 1, n) ** p for p in (1, 2)] + [np.cos(np.arange(n))])
    data, trends = (dct(x, axis=0, norm="ortho")[1:] for x in (angle, columns))
    inverse = np.diag(1 / (strengths @ record.bands.shapes))
    middle = np.linalg.inv(trends.T @ inverse @ trends)
    projected = inverse - inverse @ trends @ middle @ trends.T @ inverse
    changes = [projected @ np.diag(shape) for shape in record.bands.shapes]
    information = [[np.trace(a @ b) for b in changes] for a in changes]
    slope = [np.trace(a) - data @ a @ projected @ data for a in changes]
    found = compute_misfit([record], strengths)
    assert found.information == pytest.approx(np.array(information), rel=1e-9)
    assert found.information @ strengths - found.right_side == pytest.approx(
        np.array(slope), rel=1e-6
    )
    freedom = n - 1 - trends.shape[1]
    expected = freedom * np.log(2) - data @ projected @ data / 2
    assert compute_misfit([record], 2 * strengths).value - found.value == pytest.approx(
        expected, rel=1e-9
    )


def test_coefficients_have_their_units() -> None:
    """A record read at ten times the pace: Q stays, N grows by sqrt(10), B by 10, K by 31.6."""
    angle = noisy_angle(4000, (5, 1, 0.5, 0.02, 0), np.random.default_rng(4))
    slow, fast = estimate_noise(angle, 1.0), estimate_noise(angle, 0.1)
    for name, power in zip(NAMES, (0, 0.5, 1, 1.5), strict=True):
        assert getattr(fast, name).high == pytest.approx(
            10**power * getattr(slow, name).high, rel=1e-6
        )


@pytest.mark.parametrize("truth", [0.0, 0.3, 1.0, 1.9, 3.0])
def test_critical_ratio_covers_a_mean_that_is_not_negative(truth: float) -> None:
    seen = norm.rvs(truth, size=100_000, random_state=5)
    ratio = (seen - truth) ** 2 - (seen - np.maximum(seen, 0)) ** 2
    covered = np.mean(ratio <= compute_critical_ratio(truth))
    assert covered == pytest.approx(0.95, abs=4 * np.sqrt(0.95 * 0.05 / 100_000))


def test_the_gyros_own_noise_is_found() -> None:
    """HRGSlow at rest; each interval misses with a chance of 5 %, three times as wide hardly."""
    angle_walk, flicker, reading, bryan = 1e-7, 2e-8, 3e-7, 0.277
    parameters = {
        "noise.angleRandomWalk": angle_walk,
        "noise.pickOff": 2 * bryan * reading * 1e-3**0.5,
        "noise.biasInstability": flicker,
        "samplePeriod": 1.0,
    }
    with GyroFmu(build_fmu("HRGSlow")).power_on(parameters, 1, 0.3) as gyro:
        found = estimate_noise(drive(gyro, np.zeros(20_000), 1.0), 1.0)
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
        estimate_noise(angle, interval)
