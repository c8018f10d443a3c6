"""Noise of the readings of angles: what encoder or gyro show alone, and grows with the rate."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.common.arrays import Array
from pyhrg.common.units import ARCSEC, DEG
from pyhrg.gap.replay.reading_noise import (
    NONE,
    Level,
    ReadingNoise,
    describe_reading_noise,
    estimate_reading_noise,
)
from pyhrg.records import Log
from tests.pyhrg.records.made_up import made_up_log

ROWS, INTERVAL = 1400, 0.1
GYRO_NOISE = 0.036 * ARCSEC
RATES = (0.0, 5 * DEG, -100 * DEG)


def draw_noise(size: float, seed: int) -> Array:
    return size * np.random.default_rng(seed).normal(size=ROWS)


def make_rates(rate: float) -> Array:
    """(n,) rates of a table at rest, accelerated to a rate, and at that rate, rad/s."""
    return np.clip(np.arange(ROWS) - 100, 0, 19) / 19 * rate


def make_log(rate: float, encoder: Array | float = 0.0, gyro: Array | float = 0.0) -> Log:
    """A log of such a motion with errors of encoder and gyro, rad."""
    motion = np.cumsum(make_rates(rate) * INTERVAL)
    noisy = motion + draw_noise(GYRO_NOISE, 2) + gyro
    log = made_up_log(ROWS)
    return replace(log, interval=INTERVAL, table_angle=motion + encoder, gyro_angle=noisy)


def jitter(size: float) -> list[Array]:
    """(n,) errors by reading at times that scatter, rad, for each rate."""
    return [draw_noise(size, 10 + i) * make_rates(rate) for i, rate in enumerate(RATES)]


def is_near(level: Level, value: float) -> bool:
    """Within 15 %, with its stated error."""
    return abs(level.value - value) < min(0.15 * value, 4 * level.sigma)


@pytest.mark.parametrize("size", [0.05 * ARCSEC, 1.0 * ARCSEC])
def test_noise_of_the_encoder_is_the_same_at_any_rate(size: float) -> None:
    noise = estimate_reading_noise([make_log(rate, draw_noise(size, 1)) for rate in RATES])
    assert is_near(noise.encoder, size)
    assert noise.encoder_jitter == noise.gyro_jitter == NONE


@pytest.mark.parametrize("size", [5e-6, 1e-4])
def test_jitter_grows_with_the_rate_and_has_an_owner(size: float) -> None:
    pairs = list(zip(RATES, jitter(size), strict=True))
    late_encoder = estimate_reading_noise([make_log(rate, error) for rate, error in pairs])
    assert is_near(late_encoder.encoder_jitter, size)
    assert late_encoder.gyro_jitter == late_encoder.encoder == NONE
    late_gyro = estimate_reading_noise([make_log(rate, 0.0, error) for rate, error in pairs])
    assert is_near(late_gyro.gyro_jitter, size)
    assert late_gyro.encoder_jitter == late_gyro.encoder == NONE


def test_noise_and_jitter_are_told_apart() -> None:
    noise = estimate_reading_noise(
        [
            make_log(rate, error + draw_noise(0.05 * ARCSEC, 20 + i))
            for i, (rate, error) in enumerate(zip(RATES, jitter(5e-6), strict=True))
        ]
    )
    assert is_near(noise.encoder, 0.05 * ARCSEC)
    assert is_near(noise.encoder_jitter, 5e-6)


@pytest.mark.parametrize("size", [5e-6, 1e-4])
def test_jitter_of_the_rows_is_shared(size: float) -> None:
    pairs = list(zip(RATES, jitter(size), strict=True))
    noise = estimate_reading_noise([make_log(rate, error, error) for rate, error in pairs])
    assert is_near(noise.row_jitter, size)
    assert replace(noise, row_jitter=NONE) == ReadingNoise()


def test_jitter_between_readings_is_found_below_that_of_the_rows() -> None:
    errors, shared = (
        [draw_noise(5e-6, 30 + i) * make_rates(rate) for i, rate in enumerate(RATES)],
        jitter(1e-4),
    )
    logs = [
        make_log(rate, both + own, both)
        for rate, own, both in zip(RATES, errors, shared, strict=True)
    ]
    noise = estimate_reading_noise(logs)
    assert noise.jitter == pytest.approx(5e-6, rel=0.15)
    assert is_near(noise.row_jitter, 1e-4)


@pytest.mark.parametrize("step", [0.1 * ARCSEC, 2 * ARCSEC])
def test_a_table_that_wanders_does_not_jitter(step: float) -> None:
    """A random walk of the table's angle, and a ripple of its rate twice a turn."""
    turned = np.cumsum(make_rates(100 * DEG) * INTERVAL)
    moves = np.cumsum(draw_noise(step, 5)), 100 * step * np.sin(2 * turned)
    for moved in moves:
        logs = [make_log(rate, moved * bool(rate), moved * bool(rate)) for rate in RATES]
        assert estimate_reading_noise(logs).row_jitter == NONE


def test_a_campaign_at_rest_has_no_jitter() -> None:
    still = make_log(0.0, draw_noise(0.1 * ARCSEC, 1), draw_noise(0.1 * ARCSEC, 3))
    noise = estimate_reading_noise([still])
    assert noise.jitter == noise.row_jitter.value == 0
    assert is_near(noise.encoder, 0.1 * ARCSEC)


@pytest.mark.parametrize("rows", [2, 3, 5])
def test_a_log_of_a_few_rows_has_none(rows: int) -> None:
    assert estimate_reading_noise([made_up_log(rows)]) == ReadingNoise()


@pytest.mark.parametrize("seed", range(20))
def test_common_scatter_is_motion(seed: int) -> None:
    """A table that shakes by 0.3 arcsec, and one at rest, have no noise of reading."""
    shaking = draw_noise(0.3 * ARCSEC, 100 + seed)
    assert (
        estimate_reading_noise([make_log(rate, shaking, shaking) for rate in RATES])
        == ReadingNoise()
    )
    assert estimate_reading_noise([make_log(0.0)]) == ReadingNoise()


def test_an_error_that_lasts_for_rows_is_no_noise() -> None:
    """An encoder's second harmonic of 2 arcsec at 100 deg/s."""
    turned = np.cumsum(make_rates(100 * DEG) * INTERVAL)
    log = make_log(100 * DEG, 2 * ARCSEC * np.sin(2 * turned))
    assert estimate_reading_noise([log]).encoder.value < 0.01 * ARCSEC


def test_rows_without_a_gyro_are_left_out() -> None:
    log = make_log(5 * DEG, draw_noise(ARCSEC, 1))
    angle = log.gyro_angle.copy()
    angle[200:260] = np.nan
    assert is_near(estimate_reading_noise([replace(log, gyro_angle=angle)]).encoder, ARCSEC)
    silent = replace(log, gyro_angle=np.full(ROWS, np.nan))
    assert estimate_reading_noise([silent]) == ReadingNoise()
    assert estimate_reading_noise([]) == ReadingNoise()


def test_a_sentence_states_each_noise() -> None:
    assert describe_reading_noise(ReadingNoise()) == []
    late = Level(3e-5, 1e-6)
    noise = ReadingNoise(Level(ARCSEC, 0.1 * ARCSEC), gyro_jitter=late, row_jitter=late)
    encoder, gyro, row = describe_reading_noise(noise)
    assert encoder.startswith("table_angle_deg: scatters by 1 arcsec where the gyro does not")
    assert gyro.startswith("gyro_angle_deg: scatters by 3e-05 s times the table's rate")
    assert row.startswith("time_s: table_angle_deg and gyro_angle_deg scatter together by 3e-05 s")


def test_starts_and_stops_of_the_table_are_no_jitter() -> None:
    """Rests of 300 s, and turns of 10 s between them at one rate, in rows of 1 s."""
    rate = np.where(np.arange(ROWS) % 310 < 300, 0.0, 8 * DEG)
    motion = np.cumsum(rate)
    gyro = motion + draw_noise(GYRO_NOISE, 2)
    log = replace(made_up_log(ROWS), interval=1.0, table_angle=motion, gyro_angle=gyro)
    assert estimate_reading_noise([log]) == ReadingNoise()
