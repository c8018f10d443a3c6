"""A reading that is off by itself is left out and told; what lasts, comes often or turns is not."""

import numpy as np
import pytest
from numpy.typing import NDArray

from pyhrg.common.units import ARCSEC
from pyhrg.gap.soundness import sound
from pyhrg.gap.soundness.glitches import FEW, INPUTS, LEAST, glitches
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign
from tests.pyhrg.gap.soundness.spoil import added as moved
from tests.pyhrg.gap.soundness.spoil import spoilt

Array = NDArray[np.float64]
ROWS = 1000
ALL = np.ones(ROWS, np.bool_)
BIG = 30.0


NOISY = ("gyro_angle", "quadrature_force", "amplitude", "temperature")


def noisy(seed: int) -> Array:
    return np.random.default_rng(seed).normal(size=ROWS) + 0.5 * np.arange(ROWS)


def off(*rows: slice | int) -> Array:
    series = noisy(1)
    for row in rows:
        series[row] += BIG
    return series


@pytest.mark.parametrize("length", [1, 2, 3])
def test_a_few_rows_that_are_off_together_are_found(length: int) -> None:
    rows = slice(500, 500 + length)
    found = glitches(off(rows), ALL)
    assert np.flatnonzero(found).tolist() == list(range(ROWS))[rows]


@pytest.mark.parametrize("rows", [[100, 700], [100, 104], [100, 700, 705], [3], [3, 996], [997]])
def test_what_is_off_in_several_places_or_near_an_end_is_found(rows: list[int]) -> None:
    assert np.flatnonzero(glitches(off(*rows), ALL)).tolist() == rows


def test_a_spark_in_what_never_changes_is_found() -> None:
    assert np.flatnonzero(glitches(np.where(np.arange(ROWS) == 500, 60.0, 25.0), ALL)) == [500]


def test_what_is_off_beside_missing_rows_is_found() -> None:
    series = off(500)
    series[[495, 503]] = np.nan
    assert np.flatnonzero(glitches(series, np.isfinite(series))).tolist() == [500]


@pytest.mark.parametrize(
    "series",
    [
        off(slice(500, 504)),
        off(slice(500, None)),
        off(*range(100, 900, 800 // (2 * FEW))),
        noisy(1) + BIG * np.abs(np.arange(ROWS) - 500),
        noisy(1) * np.where(np.arange(ROWS) // 40 == 10, BIG, 1.0),
        np.round(noisy(1) / BIG) * BIG,
        np.round(0.01 * noisy(1) + 0.6501 * np.arange(ROWS)),
        np.round(0.05 * noisy(1) + 1.0002 * np.arange(ROWS)),
        np.full(ROWS, np.nan),
    ],
    ids=["lasts", "step", "often", "turns", "noisy", "counted", "fast", "beating", "missing"],
)
def test_what_may_be_the_gyros_own_is_not(series: Array) -> None:
    assert not glitches(series, ALL & np.isfinite(series)).any()


@pytest.mark.parametrize("seed", range(20))
def test_noise_is_not(seed: int) -> None:
    assert not glitches(noisy(seed), ALL).any()
    assert not glitches(np.cumsum(noisy(seed)), ALL).any()


def test_too_few_rows_tell_nothing() -> None:
    assert not glitches(off(5)[:LEAST], ALL[:LEAST] & (np.arange(LEAST) > 0)).any()


def test_where_it_is_not_to_be_looked_at_nothing_is_found() -> None:
    assert not glitches(off(500), ALL & (np.arange(ROWS) != 501)).any()


@pytest.mark.parametrize(
    ("field", "size", "test", "column"),
    [
        ("gyro_angle", 100 * ARCSEC, "still", "gyro_angle_deg"),
        ("quadrature_force", 1e-4, "virtual", "quadrature_force_per_s"),
        ("amplitude", 1e-2, "sweep", "amplitude"),
        ("temperature", 20.0, "warm", "temperature_degC"),
        ("temperature", 20.0, "tumble", "temperature_degC"),
        ("table_angle", 100 * ARCSEC, "still", "table_angle_deg"),
        ("acceleration_z", 1.0, "pos", "accel_z_m_s2"),
    ],
)
def test_it_is_left_out_and_told(
    honest: Campaign, field: str, size: float, test: str, column: str
) -> None:
    log = next(one.log for one in honest.tests if one.id == test)
    row = len(log.time) - 20
    noise = size / 100 * np.random.default_rng(2).normal(size=len(log.time))
    quiet = spoilt(honest, moved(noise, field), test) if field in NOISY else honest
    assert sound(quiet)[1] == ()
    spark = np.where(np.arange(len(log.time)) == row, size, 0.0)
    found, exclusions = sound(spoilt(quiet, moved(spark, field), test))
    assert exclusions[0].startswith(f"{test}: column {column}: ")
    assert f"at time_s {log.time[row]:g}, expected" in exclusions[0]
    before, after = (_log(each, test) for each in (quiet, found))
    others = np.arange(len(log.time)) != row
    np.testing.assert_array_equal(getattr(before, field)[others], getattr(after, field)[others])
    if field in INPUTS:
        assert getattr(after, field)[row] == pytest.approx(
            getattr(before, field)[row], abs=0.05 * size
        )
    else:
        assert np.isnan(getattr(after, field)[row])
    assert np.isnan(after.wave_angle[row]) == (field == "gyro_angle")


def _log(campaign: Campaign, name: str) -> Log:
    return next(test.log for test in campaign.tests if test.id == name)
