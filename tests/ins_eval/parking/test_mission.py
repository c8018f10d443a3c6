"""Five minutes from power-on: what alignment uses of them."""

from dataclasses import replace

import numpy as np
import pytest

from ins_eval.common import earth
from ins_eval.mission_model.missions import STILL
from ins_eval.parking.mission import INTERVAL, Mission, find_ready_time
from ins_eval.study.cosimulated import align_at_rest
from pyhrg.common.errors import HrgError
from tests.ins_eval.cases import short_mission

START_UP = 12.0
"""s."""


@pytest.fixture(scope="module")
def flight() -> Mission:
    return short_mission(0.1)


def test_start_up_is_left_out_of_alignment(flight: Mission) -> None:
    """An east gyro's bias of start-up turns the heading by its share of the five minutes
    (Groves 2013, section 5.6.2), unless alignment begins after it."""
    mat_nb = align_at_rest(flight.truth, flight.truth.increments, 0.0)
    east_b = mat_nb.T @ np.array([0.0, 1.0, 0.0])
    bias, latitude = 1e-6, flight.truth.start.latitude
    rotation = flight.truth.increments.rotation.copy()
    rotation[: round(START_UP / INTERVAL)] += bias * INTERVAL * east_b
    measured = replace(flight.truth.increments, rotation=rotation)
    turned = -START_UP / STILL * bias / (earth.RATE * np.cos(latitude))
    assert flight.heading_error(measured) == pytest.approx(turned, rel=1e-3)
    assert abs(flight.heading_error(measured, START_UP - STILL)) < 1e-6 * abs(turned)


def test_nothing_of_the_drive_is_aligned_on(flight: Mission) -> None:
    zero = round(STILL / INTERVAL)
    spoilt = flight.truth.increments.rotation.copy()
    spoilt[zero:] = np.nan
    measured = replace(flight.truth.increments, rotation=spoilt)
    assert np.array_equal(
        align_at_rest(flight.truth, measured, 0.0),
        align_at_rest(flight.truth, flight.truth.increments, 0.0),
    )


def test_start_up_ends_with_the_last_interval_that_is_not_good() -> None:
    good = np.ones(40_000, dtype=bool)
    assert find_ready_time(good) == find_ready_time(None) == -STILL
    good[[3, 1199, 35_000]] = False
    assert find_ready_time(good) == pytest.approx(12.0 - STILL)
    good[29_999] = False
    with pytest.raises(HrgError, match="not ready 300 s after power-on"):
        find_ready_time(good)
