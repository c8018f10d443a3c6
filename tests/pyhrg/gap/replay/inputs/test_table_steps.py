"""Steps of a table's encoder: found where they are, with errors that last where it rests."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.common.units import ARCSEC, DEG
from pyhrg.gap.replay.inputs.table_steps import (
    find_rests,
    find_table_step,
    find_turning_rows,
    shape_rounding_errors,
)
from pyhrg.gap.replay.reading_noise import NONE, describe_reading_noise, estimate_reading_noise
from pyhrg.records import Log
from tests.pyhrg.records.made_up import made_up_log

ROWS = 900
STEP = 360 * DEG / 2**22
DIGITS = 1e-7 * DEG


def turning(step: float, noise: float = 0.0, rate: float = 5 * DEG) -> Log:
    """Rest, rotation at a rate that wanders, rest; readings in steps and digits of a file."""
    log = made_up_log(ROWS, noise=0.0)
    generator = np.random.default_rng(5)
    is_turning = (np.arange(ROWS) >= 300) & (np.arange(ROWS) < 600)
    wander = 1 + 1e-4 * np.cumsum(generator.standard_normal(ROWS))
    angle = 0.3 * ARCSEC + np.cumsum(is_turning * rate * wander) * log.interval
    angle = angle + noise * generator.standard_normal(ROWS)
    shown = step * np.round(angle / step) if step else angle
    return replace(log, table_angle=DIGITS * np.round(shown / DIGITS), gyro_angle=angle)


@pytest.mark.parametrize("step", [1e-4 * DEG, STEP, 5 * ARCSEC])
def test_a_step_is_found(step: float) -> None:
    assert find_table_step([turning(step), turning(step, rate=20 * DEG)]) == pytest.approx(
        step, rel=1e-3
    )


@pytest.mark.parametrize("noise", [0.0, 0.03 * ARCSEC, ARCSEC])
def test_no_step_is_found_where_there_is_none(noise: float) -> None:
    assert find_table_step([turning(0.0, noise)]) == 0.0


@pytest.mark.parametrize(
    "angle",
    [
        0.01 * DEG * (0.1 * np.arange(ROWS)) ** 2 / 2,
        10 * ARCSEC * (np.arange(ROWS) // 20),
        20 * ARCSEC * np.cumsum(np.arange(ROWS) % 50 < 25),
    ],
    ids=["acceleration", "stepper", "ramps"],
)
def test_a_motion_that_the_gyro_shows_is_no_step(angle: np.ndarray) -> None:
    """Its second differences are multiples of one of them, too."""
    shown = DIGITS * np.round(angle / DIGITS)
    assert find_table_step([replace(turning(0.0), table_angle=shown, gyro_angle=angle)]) == 0.0


def test_too_little_says_nothing() -> None:
    assert find_table_step([]) == 0.0
    assert find_table_step([made_up_log(ROWS, noise=0.0)]) == 0.0


def test_rests_and_turning_rows() -> None:
    angle = turning(STEP).table_angle
    first, last = find_rests(angle, STEP)
    assert (first.start, last.stop) == (0, ROWS)
    assert abs(first.stop - 300) <= 1
    assert abs(last.start - 599) <= 1
    assert not find_turning_rows(angle)[:298].any()
    assert find_turning_rows(angle)[301:598].all()


def test_a_reading_that_flickers_is_one_rest() -> None:
    flickering = STEP * np.array([0, 0, 1, 0, 1, 1, 0, 1, 1, 0, 0, 40, *[80] * 10])
    assert find_rests(flickering, STEP) == [slice(0, 11), slice(12, 22)]


def test_the_start_each_rest_and_each_angle_passed_again_have_their_errors() -> None:
    """The angle counts from a first reading that is wrong as well."""
    angle = turning(STEP).table_angle
    start, last = (find_rests(angle, STEP)[k] for k in (0, 1))
    rests = shape_rounding_errors(angle, STEP)
    assert rests.shape == (ROWS, 2)
    assert np.unique(rests[rests > 0]) == pytest.approx([STEP / np.sqrt(12)])
    np.testing.assert_array_equal(rests[:, 0] > 0, np.arange(ROWS) >= start.stop)
    np.testing.assert_array_equal(rests[:, 1] > 0, np.arange(ROWS) >= last.start)
    around = np.arange(360) * 30 * DEG  # twelve angles, thirty times each
    shapes = shape_rounding_errors(around, STEP)
    assert shapes.shape == (360, 13)
    assert (np.count_nonzero(shapes, axis=0) == [360, *[30] * 12]).all()
    assert shape_rounding_errors(np.zeros(9), STEP).shape == (9, 0)
    assert shape_rounding_errors(around, 0.0).shape == (360, 0)


def test_errors_of_a_slow_motion_are_white() -> None:
    """Each angle is passed once, and there are more stretches than can be told apart."""
    assert shape_rounding_errors(0.11 * STEP * np.arange(7200), STEP).shape == (7200, 0)


def test_what_lasts_beside_an_encoder_that_starts_between_steps() -> None:
    """The angle at power-on is shown as zero, and all that follows the first rest is off by it."""
    log = turning(5 * ARCSEC)
    apart = log.table_angle - log.gyro_angle
    shapes = shape_rounding_errors(log.table_angle, 5 * ARCSEC)
    fitted = shapes @ np.linalg.lstsq(shapes, apart - apart[0], rcond=None)[0]
    rest = find_rests(log.table_angle, 5 * ARCSEC)[1]
    np.testing.assert_allclose(fitted[rest], (apart - apart[0])[rest], atol=0.01 * ARCSEC)


def test_rounding_is_no_noise_of_the_encoder() -> None:
    noise = estimate_reading_noise([turning(5 * ARCSEC), turning(5 * ARCSEC, rate=20 * DEG)])
    assert noise.encoder == NONE
    assert noise.encoder_step == pytest.approx(5 * ARCSEC, rel=1e-3)
    (sentence,) = describe_reading_noise(noise)
    assert sentence.startswith("table_angle_deg: in steps of 5 arcsec")
