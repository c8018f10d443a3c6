"""Steps of a table's encoder: found where they are, with errors that last where it rests."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.common.units import ARCSEC, DEG
from pyhrg.gap.replay.reading_noise import NONE, describe_reading_noise, estimate_reading_noise
from pyhrg.gap.replay.table_steps import (
    find_rests,
    find_table_step,
    find_turning_rows,
    shape_rounding_errors,
)
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
    flickering = STEP * np.array([0, 0, 1, 0, 1, 1, 0, 40, 80, 80, 80])
    assert find_rests(flickering, STEP) == [slice(0, 7), slice(8, 11)]


def test_each_rest_and_each_angle_passed_again_has_its_error() -> None:
    rests = shape_rounding_errors(turning(STEP).table_angle, STEP)
    assert rests.shape == (ROWS, 2)
    assert np.unique(rests[rests > 0]) == pytest.approx([STEP / np.sqrt(12)])
    around = np.arange(360) * 30 * DEG  # twelve angles, thirty times each
    shapes = shape_rounding_errors(around, STEP)
    assert shapes.shape == (360, 12)
    assert (np.count_nonzero(shapes, axis=0) == 30).all()
    assert shape_rounding_errors(np.zeros(9), STEP).shape == (9, 0)
    assert shape_rounding_errors(around, 0.0).shape == (360, 0)


def test_rounding_is_no_noise_of_the_encoder() -> None:
    noise = estimate_reading_noise([turning(5 * ARCSEC), turning(5 * ARCSEC, rate=20 * DEG)])
    assert noise.encoder == NONE
    assert noise.encoder_step == pytest.approx(5 * ARCSEC, rel=1e-3)
    (sentence,) = describe_reading_noise(noise)
    assert sentence.startswith("table_angle_deg: in steps of 5 arcsec")
