"""Isolated wrong readings are excluded and reported; lasting or frequent ones are not."""

import numpy as np
import pytest

from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC
from pyhrg.gap.soundness import screen_campaign
from pyhrg.gap.soundness.glitches import MAX_GLITCH_SHARE, MIN_ROWS, find_glitches
from pyhrg.gap.soundness.inputs import CONTINUOUS_INPUTS
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign
from tests.pyhrg.gap.soundness.spoil import added, change_logs

ROWS = 1000
ALL = np.ones(ROWS, np.bool_)
BIG = 30.0


NOISY = ("gyro_angle", "quadrature_force", "amplitude", "temperature")


def draw_series(seed: int) -> Array:
    return np.random.default_rng(seed).normal(size=ROWS) + 0.5 * np.arange(ROWS)


def add_glitches(*rows: slice | int) -> Array:
    series = draw_series(1)
    for row in rows:
        series[row] += BIG
    return series


def test_rounding_of_an_exact_series_is_no_glitch() -> None:
    exact = np.radians(0.5) * np.arange(1, ROWS + 1)
    exact[[300, 301, 600]] += 2e-14
    assert not find_glitches(exact, ALL).any()


@pytest.mark.parametrize("length", [1, 2, 3])
def test_a_glitch_of_up_to_three_rows_is_found(length: int) -> None:
    rows = slice(500, 500 + length)
    glitches = find_glitches(add_glitches(rows), ALL)
    assert np.flatnonzero(glitches).tolist() == list(range(ROWS))[rows]


@pytest.mark.parametrize("rows", [[100, 700], [100, 104], [100, 700, 705], [3], [3, 996], [997]])
def test_several_glitches_and_those_near_an_end_are_found(rows: list[int]) -> None:
    assert np.flatnonzero(find_glitches(add_glitches(*rows), ALL)).tolist() == rows


def test_a_glitch_in_a_constant_series_is_found() -> None:
    assert np.flatnonzero(find_glitches(np.where(np.arange(ROWS) == 500, 60.0, 25.0), ALL)) == [500]


def test_a_glitch_beside_missing_rows_is_found() -> None:
    series = add_glitches(500)
    series[[495, 503]] = np.nan
    assert np.flatnonzero(find_glitches(series, np.isfinite(series))).tolist() == [500]


@pytest.mark.parametrize(
    "series",
    [
        add_glitches(slice(500, 504)),
        add_glitches(slice(500, None)),
        add_glitches(*range(100, 900, round(400 / (MAX_GLITCH_SHARE * ROWS)))),
        draw_series(1) + BIG * np.abs(np.arange(ROWS) - 500),
        draw_series(1) * np.where(np.arange(ROWS) // 40 == 10, BIG, 1.0),
        np.round(draw_series(1) / BIG) * BIG,
        np.round(0.01 * draw_series(1) + 0.6501 * np.arange(ROWS)),
        np.round(0.05 * draw_series(1) + 1.0002 * np.arange(ROWS)),
        np.full(ROWS, np.nan),
    ],
    ids=["lasts", "step", "often", "turns", "noisy", "counted", "fast", "beating", "missing"],
)
def test_signals_that_the_gyro_may_produce_are_no_glitches(series: Array) -> None:
    assert not find_glitches(series, ALL & np.isfinite(series)).any()


@pytest.mark.parametrize("seed", range(20))
def test_noise_is_no_glitch(seed: int) -> None:
    assert not find_glitches(draw_series(seed), ALL).any()
    assert not find_glitches(np.cumsum(draw_series(seed)), ALL).any()


def test_too_few_rows_are_not_searched() -> None:
    assert not find_glitches(
        add_glitches(5)[:MIN_ROWS], ALL[:MIN_ROWS] & (np.arange(MIN_ROWS) > 0)
    ).any()


def test_rows_that_are_not_searched_have_no_glitch() -> None:
    assert not find_glitches(add_glitches(500), ALL & (np.arange(ROWS) != 501)).any()


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
def test_a_glitch_is_excluded_and_reported(
    error_free: Campaign, field: str, size: float, test: str, column: str
) -> None:
    log = next(other.log for other in error_free.tests if other.id == test)
    row = len(log.time) - 20
    noise = size / 100 * np.random.default_rng(2).normal(size=len(log.time))
    quiet = change_logs(error_free, added(noise, field), test) if field in NOISY else error_free
    assert screen_campaign(quiet)[1] == ()
    glitch = np.where(np.arange(len(log.time)) == row, size, 0.0)
    screened, exclusions, _ = screen_campaign(change_logs(quiet, added(glitch, field), test))
    assert exclusions[0].startswith(f"{test}: column {column}: ")
    assert f"at time_s {log.time[row]:g}, expected" in exclusions[0]
    before, after = (_log(each, test) for each in (quiet, screened))
    others = np.arange(len(log.time)) != row
    np.testing.assert_array_equal(getattr(before, field)[others], getattr(after, field)[others])
    if field in CONTINUOUS_INPUTS:
        assert getattr(after, field)[row] == pytest.approx(
            getattr(before, field)[row], abs=0.05 * size
        )
    else:
        assert np.isnan(getattr(after, field)[row])
    assert np.isnan(after.wave_angle[row]) == (field == "gyro_angle")


def _log(campaign: Campaign, name: str) -> Log:
    return next(test.log for test in campaign.tests if test.id == name)


@pytest.mark.parametrize("row", [0, 1, -2, -1])
def test_an_output_angle_that_contradicts_the_pattern_angle_is_left_out(
    error_free: Campaign, row: int
) -> None:
    log = next(other.log for other in error_free.tests if other.id == "pos")
    wrong = np.zeros(len(log.time))
    wrong[row] = 20 * ARCSEC
    screened, exclusions, _ = screen_campaign(
        change_logs(error_free, added(wrong, "gyro_angle"), "pos")
    )
    assert [sentence[-8:] for sentence in exclusions] == ["left out"]
    assert np.flatnonzero(np.isnan(_log(screened, "pos").gyro_angle)) == row % len(wrong)
