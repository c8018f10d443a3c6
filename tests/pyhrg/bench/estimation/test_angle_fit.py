"""Fits of angles: terms, noise and intervals."""

import numpy as np
import pytest

from pyhrg.bench.estimation.angle_fit import AngleFit, Record, compute_largest_inflation, fit_angles
from pyhrg.bench.estimation.harmonics import fit
from pyhrg.common.arrays import Array

STEP = 0.1
TIME = np.arange(400) * STEP
COLUMNS = {"rate": TIME, "wave": np.sin(TIME)}
REPEATS = 400


def noise(generator: np.random.Generator, rate: float, angle: float) -> Array:
    walk = np.cumsum(generator.normal(size=len(TIME))) * np.sqrt(rate * STEP)
    return np.asarray(walk + angle * generator.normal(size=len(TIME)))


def fits(rate: float, angle: float) -> list[AngleFit]:
    generator = np.random.default_rng(5)
    true = 2.0 * TIME - 0.5 * np.sin(TIME) + 7.0
    return [
        fit_angles([Record(STEP, true + noise(generator, rate, angle), COLUMNS)])
        for _ in range(REPEATS)
    ]


def inside(found: list[AngleFit], name: str, truth: float) -> int:
    intervals = [one.interval(name) for one in found]
    return sum(low <= truth <= high for low, high in intervals)


@pytest.mark.parametrize(("rate", "angle"), [(1.0, 0.0), (1.0, 1.0), (0.03, 1.0)])
def test_intervals_cover(rate: float, angle: float) -> None:
    """Whichever noise prevails: 380 +- 4.4 of 400 expected, 4 sigma either way."""
    found = fits(rate, angle)
    for name, truth in (("rate", 2.0), ("wave", -0.5)):
        assert 362 <= inside(found, name, truth) <= 397


def test_rate_noise_is_never_ruled_out() -> None:
    """Without any, the slope's interval is on the safe side: as much as the record can't exclude
    is allowed for. Of the wave the record knows its noise."""
    found = fits(0.0, 1.0)
    assert inside(found, "rate", 2.0) >= 380
    assert 362 <= inside(found, "wave", -0.5) <= 397


def test_noise_is_recovered() -> None:
    found = fits(1.0, 1.0)
    assert np.mean([one.rate_noise for one in found]) == pytest.approx(1.0, rel=0.05)
    assert np.mean([one.angle_noise for one in found]) == pytest.approx(1.0, rel=0.05)


def test_least_squares_on_the_angle_would_not_do() -> None:
    """Control: intervals that take a random walk for white noise hold the truth too rarely."""
    generator, hits = np.random.default_rng(5), 0
    for _ in range(100):
        columns = {"mean": np.ones_like(TIME), **COLUMNS}
        low, high = fit(columns, 2.0 * TIME + noise(generator, 1.0, 0.0)).interval("rate")
        hits += low <= 2.0 <= high
    assert hits < 50


def test_exact_without_noise() -> None:
    found = fit_angles([Record(STEP, 2.0 * TIME - 0.5 * np.sin(TIME), COLUMNS)])
    assert found.value("rate") == pytest.approx(2.0, rel=1e-12)
    assert found.value("wave") == pytest.approx(-0.5, rel=1e-12)


def test_records_of_other_offsets_join() -> None:
    parts = [slice(0, 150), slice(150, 400)]
    records = [
        Record(STEP, 2.0 * TIME[p] + i, {n: c[p] for n, c in COLUMNS.items()})
        for i, p in enumerate(parts)
    ]
    assert fit_angles(records).value("rate") == pytest.approx(2.0, rel=1e-12)


def test_inflation_tells_like_columns() -> None:
    assert compute_largest_inflation([Record(STEP, TIME, COLUMNS)]) < 1.1
    twice = {"rate": TIME, "again": 2 * TIME}
    assert compute_largest_inflation([Record(STEP, TIME, twice)]) == np.inf
    assert (
        compute_largest_inflation([Record(STEP, TIME, {"rate": TIME, "none": 0 * TIME})]) == np.inf
    )


def test_too_short_a_record_is_refused() -> None:
    short = {name: column[:4] for name, column in COLUMNS.items()}
    with pytest.raises(ValueError, match="3 increments can't determine 2 terms and two noises"):
        fit_angles([Record(STEP, TIME[:4], short)])


def test_a_line_without_noise_is_fitted() -> None:
    time = np.arange(50.0)
    found = fit_angles([Record(1.0, np.zeros(50), {"bias": time})])
    assert found.value("bias") == 0.0
    assert np.isfinite(found.interval("bias")).all()
