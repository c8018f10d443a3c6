"""The tests of a campaign."""

from pathlib import Path

import numpy as np
import pytest

from pyhrg.bench.programme import make_course
from pyhrg.challenge.campaigns.plans import TESTS, plan_further_tests, plan_tests
from pyhrg.common.units import DEG
from pyhrg.records import campaign
from tests.pyhrg.challenge.short import GYRO


def test_kinds_roles_and_lengths_are_the_recorded_ones(recorded_campaign: Path) -> None:
    """Varied by a fifth at most, in order."""
    recorded = campaign.read_campaign(recorded_campaign).tests
    made = plan_tests(GYRO, np.random.default_rng(1), complete=True)
    assert [(p.kind, p.role) for p in made] == [(t.kind, t.role) for t in recorded]
    for plan, test in zip(made, recorded, strict=True):
        assert plan.programme.interval == test.log.interval
        assert len(plan.programme) == pytest.approx(len(test.log.time), rel=0.2)
        highest = np.abs(np.diff(test.log.table_angle)).max() / test.log.interval
        ours = np.abs(plan.programme.table_rate).max()
        assert bool(ours) == bool(highest)
        if plan.kind == "rate":
            assert ours == pytest.approx(highest, rel=0.12)


def test_inputs_stay_where_the_recorded_ones_do(recorded_campaign: Path) -> None:
    recorded = {test.id: test.log for test in campaign.read_campaign(recorded_campaign).tests}
    made = {p.kind: p.programme for p in plan_tests(GYRO, np.random.default_rng(2), complete=True)}
    ramp = recorded["thermal_ramp"].temperature
    temperature = made["thermal"].temperature
    assert temperature.min() == pytest.approx(ramp.min(), abs=5)
    assert temperature.max() == pytest.approx(ramp.max(), abs=5)
    sweep = recorded["amplitude_sweep"].amplitude_setpoint
    np.testing.assert_allclose(
        np.unique(made["amplitude"].values("amplitude_setpoint")), np.unique(sweep), rtol=0.06
    )
    commanded = made["virtual_rotation"].values("virtual_rotation")
    assert np.abs(commanded).max() == pytest.approx(1 * DEG, rel=0.12)


def test_positions_are_evenly_apart_in_pattern_angle() -> None:
    made = plan_tests(GYRO, np.random.default_rng(3), complete=True)
    course = next(p.programme for p in made if p.kind == "positions")
    still = course.table_angle[np.diff(course.table_angle, prepend=0.0) == 0.0]
    steps = np.diff(np.unique(np.round(still, 9)))
    np.testing.assert_allclose(steps * GYRO.bryan_factor, 22.5 * DEG, rtol=1e-6)
    assert len(steps) == 7


def test_same_seed_same_tests_and_another_seed_others() -> None:
    angles = [
        [plan.start_angle for plan in plan_tests(GYRO, np.random.default_rng(seed), complete=True)]
        for seed in (1, 1, 2)
    ]
    assert angles[0] == angles[1] != angles[2]


def test_some_campaigns_lack_kinds_but_never_rest_and_verification() -> None:
    made = [plan_tests(GYRO, np.random.default_rng(seed)) for seed in range(12)]
    assert {len({plan.kind for plan in campaign}) for campaign in made} >= {9, 10}
    for tests in made:
        kinds = {plan.kind for plan in tests}
        assert {"static", "manoeuvre"} <= kinds


def test_rows_are_whole_communication_steps() -> None:
    for plan in plan_tests(GYRO, np.random.default_rng(4), complete=True):
        course = make_course(plan.programme, plan.programme.interval / 100)
        assert course.steps == 100
        np.testing.assert_allclose(course.table_angle_at_ends, plan.programme.table_angle)


def test_further_tests_may_be_fitted() -> None:
    more = plan_further_tests("manoeuvre", 0.5, GYRO, np.random.default_rng(1))
    assert [(plan.id, plan.role) for plan in more] == [("next_1_manoeuvre_holdout", "fit")]
    longer = plan_further_tests("tumble", 2.0, GYRO, np.random.default_rng(1))
    times = [plan.programme.time for plan in longer]
    assert [plan.id for plan in longer] == [f"next_{i + 1}_tumble" for i in range(len(longer))]
    assert sum(times[:-1]) < 7200 <= sum(times)
    with pytest.raises(ValueError, match="centrifuge: expected one of static, positions"):
        plan_further_tests("centrifuge", 1.0, GYRO, np.random.default_rng(1))
    assert {kind for _, kind, _, _ in TESTS} >= {"thermal", "tumble"}


def test_few_data_are_one_or_two_kinds_short_tests_or_coarse_rows() -> None:
    full = {plan.id: plan for plan in plan_tests(GYRO, np.random.default_rng(3), True)}
    for seed in range(8):
        few = plan_tests(GYRO, np.random.default_rng(seed), data="few")
        assert len({plan.kind for plan in few if plan.role == "fit"}) in (1, 2)
        assert few[-1].role == "holdout"
    for plan in plan_tests(GYRO, np.random.default_rng(3), True, "short")[:-1]:
        assert 0.05 < plan.programme.time / full[plan.id].programme.time < 0.17
    for plan in plan_tests(GYRO, np.random.default_rng(3), True, "coarse"):
        assert plan.programme.interval >= 1.0
        assert plan.programme.time == pytest.approx(full[plan.id].programme.time)
