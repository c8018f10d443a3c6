"""From calibration to flight."""

import numpy as np
import pytest

from ins_eval.mission_model.gyro_map import TERMS, measure_gyro_map
from ins_eval.study.gyros.drift import Drift, draw_flight
from ins_eval.study.gyros.population import RAW
from ins_eval.study.gyros.true_maps import list_slow_parameters
from pyhrg.common.errors import HrgError
from pyhrg.common.units import YEAR
from pyhrg.fmu import GyroFmu


def test_age_and_power_on_move_the_map(slow_fmu: GyroFmu) -> None:
    """By a share of it, more with age."""
    device = RAW.draw(np.random.default_rng(5))
    before = measure_gyro_map(slow_fmu, list_slow_parameters(device))[:TERMS]
    shares = []
    for age in (0.0, 4 * YEAR):
        flown = draw_flight(device, Drift(age=age), np.random.default_rng(6))
        after = measure_gyro_map(slow_fmu, list_slow_parameters(flown.device))[:TERMS]
        shares.append(np.linalg.norm(after - before) / np.linalg.norm(before))
    assert 0 < shares[0] < shares[1] < 0.5


def test_flight_is_its_seeds() -> None:
    device = RAW.draw(np.random.default_rng(5))
    one, same, other = (draw_flight(device, Drift(), np.random.default_rng(s)) for s in (1, 1, 2))
    assert one == same
    assert one.power_on_angle != other.power_on_angle
    for flight in (one, other):
        moved = flight.power_on_angle - device.power_on_angle
        assert abs(moved) < 5 * device.power_on_scatter, "the electronics start it where they did"
    assert one.device.turn_on_scatter == {}
    assert one.device.angle_random_walk == device.angle_random_walk


@pytest.mark.parametrize("wrong", [{"age": -1.0}, {"coolest": 20.0}, {"warmest": np.inf}])
def test_impossible_drift_is_refused(wrong: dict[str, float]) -> None:
    with pytest.raises(HrgError, match="expected 0 or more, the smaller first"):
        Drift(**wrong)
