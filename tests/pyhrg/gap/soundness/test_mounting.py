"""A table encoder or an input axis that counts the other way is found and turned."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.common.units import DEG, DEG_PER_H
from pyhrg.gap.closing.prediction import predict
from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.effects.catalogue import Catalogue
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.gap.soundness import screen_campaign
from pyhrg.gap.soundness.mounting import find_mounting_faults
from pyhrg.records.campaign import Campaign
from tests.pyhrg.gap.bench import recorded
from tests.pyhrg.gap.soundness.conftest import NOMINAL
from tests.pyhrg.gap.soundness.spoil import change_logs, scaled

SIGNS = {"table_angle": "table_angle_sign", "axis_up": "axis_up_sign"}


def find_signs(campaign: Campaign) -> dict[str, float]:
    logs = [test.log for test in campaign.tests]
    return {fault.kind.parameter: fault.value for fault in find_mounting_faults(logs, NOMINAL)}


@pytest.mark.parametrize("fields", [("table_angle",), ("axis_up",), ("table_angle", "axis_up")])
def test_reversed_signs_are_turned(error_free: Campaign, fields: tuple[str, ...]) -> None:
    screened, sentences, faults = screen_campaign(change_logs(error_free, scaled(-1, *fields)))
    assert [fault.kind.parameter for fault in faults] == [SIGNS[field] for field in fields]
    for fault in faults:
        assert fault.value == pytest.approx(-1, abs=0.02)
        assert fault.beyond_probability > 0.99
    assert len(sentences) == len(fields) * len(error_free.tests)
    for before, after in zip(error_free.tests, screened.tests, strict=True):
        for field in fields:
            np.testing.assert_array_equal(getattr(after.log, field), getattr(before.log, field))


def test_right_signs_stay(error_free: Campaign) -> None:
    assert find_signs(error_free) == {}


def test_one_log_does_not_reverse_a_campaign(error_free: Campaign) -> None:
    assert find_signs(change_logs(error_free, scaled(-1, "table_angle"), "pos")) == {}


def test_a_bias_that_does_not_follow_the_attitude_is_no_reversed_axis(error_free: Campaign) -> None:
    """Twice Earth's rate with the axis up, in a campaign that also has it level and down."""
    earth = float(NOMINAL.site.compute_earth_rate(1.0))
    logs = [
        replace(test.log, gyro_angle=test.log.gyro_angle - 2 * earth * test.log.time)
        for test in error_free.tests
    ]
    assert find_mounting_faults(logs, NOMINAL) == []


def test_a_large_bias_in_one_attitude_is_no_reversed_axis(error_free: Campaign) -> None:
    still = [test.log for test in error_free.tests if test.id == "still"]
    for bias in (-5 * DEG_PER_H, 5 * DEG_PER_H):
        logs = [replace(log, gyro_angle=log.gyro_angle + bias * log.time) for log in still]
        assert find_mounting_faults(logs, NOMINAL) == []


@pytest.fixture(scope="module")
def spun(simulation: Simulation) -> Campaign:
    """Rest, then a turn of the table."""
    bench = Bench(simulation.sampled, NOMINAL)
    turns = bench.programme().rest(150).turn(90 * DEG, 10 * DEG).rest(150)
    again = bench.programme().rest(120).turn(-60 * DEG, 10 * DEG).rest(150)
    power_ons = [PowerOn("turned", "positions", turns), PowerOn("again", "manoeuvre", again)]
    return recorded(simulation.sampled, NOMINAL, power_ons=power_ons)


def test_the_cause_is_named_and_predictions_are_turned_too(
    simulation: Simulation, spun: Campaign
) -> None:
    known: dict[str, Any] = {"catalogue": Catalogue(known=()), "simulation": simulation}
    result = diagnose(change_logs(spun, scaled(-1, *SIGNS)), **known)
    (cause,) = result.diagnosis.causes
    assert (result.verdict, cause.effect, cause.family) == ("explained", "mounting_sign", "bench")
    assert set(cause.parameters) == set(SIGNS.values())
    assert result.identified.without_noise() == result.nominal.without_noise()
    reversed_log = change_logs(spun, scaled(-1, *SIGNS)).tests[-1].log
    predicted = predict(result, reversed_log, spun, simulation=simulation)
    apart = predicted["gyro_angle_deg"].to_numpy() * DEG - reversed_log.gyro_angle
    assert np.abs(apart).max() < 1e-3 * DEG
