"""Allan deviation against allantools, and its intervals against repeats."""

from typing import Any

import allantools
import numpy as np
import pytest
import xarray as xr
from scipy.stats import binom

from pyhrg.common.errors import HrgError
from pyhrg.noise.allan import allan_deviation, estimate_allan_deviation
from pyhrg.noise.coefficients import (
    Coefficient,
    NoiseCoefficients,
    NoiseError,
    compute_allan_deviation,
)
from tests.pyhrg.noises import noisy_angle

PURE = {2: (1, 0, 0, 0, 0), 0: (0, 1, 0, 0, 0), -1: (0, 0, 1, 0, 0), -2: (0, 0, 0, 1, 0)}
"""By the exponent of the rate's density, as allantools has it."""


@pytest.mark.parametrize("mixture", [*PURE.values(), (5, 1, 0.3, 0.02, 1e-3)])
def test_deviation_is_that_of_allantools(mixture: tuple[float, float, float, float, float]) -> None:
    angle = noisy_angle(3000, mixture, np.random.default_rng(1))
    found = estimate_allan_deviation(angle, 0.5, per_octave=3)
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
    found = estimate_allan_deviation(angle, 1.0, per_octave=1)
    for tau, freedom in zip(found.tau[6:9], found.freedom[6:9], strict=True):
        theirs = allantools.edf_greenhall(alpha, 2, int(tau), n, overlapping=True)
        assert freedom == pytest.approx(theirs, rel=0.05), tau


def test_degrees_of_freedom_of_neighbours_are_exact() -> None:
    """White rate, one angle a cluster: neighbours correlate by -1/2, so two thirds are free."""
    n = 4000
    found = estimate_allan_deviation(noisy_angle(n, PURE[0], np.random.default_rng(5)), 1.0)
    assert found.freedom[0] == pytest.approx(2 / 3 * (n - 2), rel=0.02)


@pytest.mark.parametrize("tau", [1, 32, 512])
def test_interval_holds_the_promised_deviation(tau: int) -> None:
    """In 95 % of 100 records; a number outside has a chance of 1e-3."""
    mixture = (5, 1, 0.1, 0.01, 0)
    truth = compute_allan_deviation(
        tau, NoiseCoefficients(*(Coefficient(x, x, x) for x in mixture[:4]))
    )
    held = 0
    for seed in range(100):
        angle = noisy_angle(2000, mixture, np.random.default_rng([3, seed]))
        found = estimate_allan_deviation(angle, 1.0, per_octave=1)
        (at,) = np.flatnonzero(found.tau == tau)
        held += bool(found.low[at] <= truth <= found.high[at])
    assert binom.ppf(5e-4, 100, 0.95) <= held <= binom.isf(5e-4, 100, 0.95)


def test_interval_scales_with_the_unit() -> None:
    angle = noisy_angle(1000, PURE[0], np.random.default_rng(4))
    small, large = estimate_allan_deviation(1e-9 * angle, 1.0), estimate_allan_deviation(angle, 0.1)
    assert large.tau == pytest.approx(0.1 * small.tau)
    assert large.high == pytest.approx(1e10 * small.high, rel=1e-3)


def test_gap_is_refused() -> None:
    angle = np.arange(1000.0) ** 1.5
    angle[500] = np.nan
    with pytest.raises(NoiseError, match="angle 500 is nan, expected a stretch without gaps"):
        estimate_allan_deviation(angle, 1.0)


def test_frame_of_rates_and_angles_is_the_estimate() -> None:
    angle = noisy_angle(1000, (1, 1, 0, 0, 0), np.random.default_rng(6))
    estimate = estimate_allan_deviation(angle, 0.5, per_octave=2)
    of_angles = allan_deviation(angle, 0.5, kind="angle", per_octave=2)
    of_rates = allan_deviation(np.diff(angle) / 0.5, 0.5, per_octave=2)
    np.testing.assert_array_equal(of_angles["deviation"], estimate.deviation)
    np.testing.assert_array_equal(of_angles["high_95"], estimate.high)
    assert of_rates["deviation"].to_numpy() == pytest.approx(estimate.deviation, rel=1e-9)
    assert of_rates["low_95"].to_numpy() == pytest.approx(estimate.low, rel=1e-6)
    assert list(of_rates.attrs["units"]) == list(of_rates.columns)
    assert of_rates.attrs["units"]["deviation"] == "unit of the rates"
    labelled = xr.DataArray(angle, attrs={"units": "rad"})
    of_labelled = allan_deviation(labelled, 0.5, kind="angle", per_octave=2)
    assert of_labelled.attrs["units"]["deviation"] == "rad/s"


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"interval_s": 0.0}, "interval_s: found 0, expected"),
        ({"kind": "phase"}, "kind: found 'phase', expected 'rate' or 'angle'"),
        ({"per_octave": 0}, "per_octave: found 0, expected a whole number"),
        ({"values": np.zeros((2, 300))}, r"values: found shape \(2, 300\)"),
        ({"values": np.append(np.ones(300), np.nan)}, "values: found a value that is not finite"),
        ({"values": np.ones(300)}, "no noise beyond rounding"),
        ({"values": np.arange(10.0) ** 3}, r"expected \(256 or more,\)"),
    ],
)
def test_an_argument_of_no_use_is_named(arguments: dict[str, Any], message: str) -> None:
    rates = np.random.default_rng(7).normal(size=300)
    with pytest.raises(HrgError, match=message):
        allan_deviation(**{"values": rates, "interval_s": 1.0, **arguments})
