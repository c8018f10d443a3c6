"""Allan deviation against allantools, and its intervals against repeats."""

import allantools
import numpy as np
import pytest
from scipy.stats import binom

from pyhrg.noise.allan import allan_deviation, expected_deviation
from pyhrg.noise.model import Coefficient, NoiseCoefficients, NoiseError
from tests.pyhrg.noises import noisy_angle

PURE = {2: (1, 0, 0, 0, 0), 0: (0, 1, 0, 0, 0), -1: (0, 0, 1, 0, 0), -2: (0, 0, 0, 1, 0)}
"""By the exponent of the rate's density, as allantools has it."""


@pytest.mark.parametrize("mixture", [*PURE.values(), (5, 1, 0.3, 0.02, 1e-3)])
def test_deviation_is_that_of_allantools(mixture: tuple[float, float, float, float, float]) -> None:
    angle = noisy_angle(3000, mixture, np.random.default_rng(1))
    found = allan_deviation(angle, 0.5, per_octave=3)
    taus, theirs, _, _ = allantools.oadev(angle, rate=2.0, data_type="phase", taus=found.tau)
    assert taus == pytest.approx(found.tau)
    assert found.deviation == pytest.approx(theirs, rel=1e-9)
    assert np.all(found.low < found.deviation)
    assert np.all(found.deviation < found.high)


@pytest.mark.parametrize("alpha", PURE)
def test_degrees_of_freedom_are_those_of_allantools(alpha: int) -> None:
    """Within 5 %: what is identified in a record of pure noise is nearly pure. At short cluster
    times theirs is the limit of long ones, up to 17 % off; see the next test."""
    n = 4000
    angle = noisy_angle(n, PURE[alpha], np.random.default_rng(2))
    found = allan_deviation(angle, 1.0, per_octave=1)
    for tau, freedom in zip(found.tau[6:9], found.freedom[6:9], strict=True):
        theirs = allantools.edf_greenhall(alpha, 2, int(tau), n, overlapping=True)
        assert freedom == pytest.approx(theirs, rel=0.05), tau


def test_degrees_of_freedom_of_neighbours_are_exact() -> None:
    """White rate, one angle a cluster: neighbours correlate by -1/2, so two thirds are free."""
    n = 4000
    found = allan_deviation(noisy_angle(n, PURE[0], np.random.default_rng(5)), 1.0)
    assert found.freedom[0] == pytest.approx(2 / 3 * (n - 2), rel=0.02)


@pytest.mark.parametrize("tau", [1, 32, 512])
def test_interval_holds_the_promised_deviation(tau: int) -> None:
    """In 95 % of 100 records; a number outside has a chance of 1e-3."""
    mixture = (5, 1, 0.1, 0.01, 0)
    truth = expected_deviation(tau, NoiseCoefficients(*(Coefficient(x, x, x) for x in mixture[:4])))
    held = 0
    for seed in range(100):
        angle = noisy_angle(2000, mixture, np.random.default_rng([3, seed]))
        found = allan_deviation(angle, 1.0, per_octave=1)
        (at,) = np.flatnonzero(found.tau == tau)
        held += bool(found.low[at] <= truth <= found.high[at])
    assert binom.ppf(5e-4, 100, 0.95) <= held <= binom.isf(5e-4, 100, 0.95)


def test_interval_scales_with_the_unit() -> None:
    angle = noisy_angle(1000, PURE[0], np.random.default_rng(4))
    small, large = allan_deviation(1e-9 * angle, 1.0), allan_deviation(angle, 0.1)
    assert large.tau == pytest.approx(0.1 * small.tau)
    assert large.high == pytest.approx(1e10 * small.high, rel=1e-3)


def test_gap_is_refused() -> None:
    angle = np.arange(1000.0) ** 1.5
    angle[500] = np.nan
    with pytest.raises(NoiseError, match="angle 500 is nan, expected a stretch without gaps"):
        allan_deviation(angle, 1.0)
