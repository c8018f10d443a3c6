"""Dead zone against Adler's closed form, on a gyro whose damping captures within minutes."""

import math
from dataclasses import replace

import numpy as np
import pytest

from pyhrg.bench.bench import PowerOn
from pyhrg.bench.dead_zone import dead_zone
from pyhrg.bench.dead_zone.lock import read_run
from pyhrg.bench.estimation.sizes import compute_length_interval
from pyhrg.bench.outcome import BenchError, Outcome
from pyhrg.common.site import Site
from pyhrg.common.units import DEG, DEG_PER_H
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from pyhrg.records.campaign import Campaign
from pyhrg.theory import closed_forms as theory
from tests.pyhrg.bench.cases import QUIET, slow_bench

CAPTURING = replace(
    QUIET.without_anisotropy(), damping_anisotropy=1e-3, damping_axis=20 * DEG, name="capturing"
)


@pytest.fixture(scope="module")
def campaign(slow_fmu: GyroFmu) -> Campaign:
    bench = slow_bench(slow_fmu, CAPTURING)
    return bench.campaign(dead_zone.record(bench))


@pytest.fixture(scope="module")
def outcome(campaign: Campaign) -> Outcome:
    return dead_zone.evaluate(campaign)


def test_lock_rate_is_a_quarter_of_the_damping_over_the_bryan_factor(outcome: Outcome) -> None:
    """To 5e-6: the bias bends the turning pattern's path between rows, which falls as the square
    of the damping (3.6e-6 here, 0.9e-6 at half of it)."""
    expected = 1e-3 / (4 * CAPTURING.bryan_factor)
    assert outcome.finding("lock rate").si_value == pytest.approx(expected, rel=5e-6)
    assert outcome.finding("lock rate from mean rates").si_value == pytest.approx(
        expected, rel=2e-4
    )


def test_pattern_locks_within_and_only_within(campaign: Campaign) -> None:
    lock = theory.lock_rate(CAPTURING)
    runs, excluded = dead_zone.read_runs(campaign, dead_zone.PLAIN)
    assert len(runs) == len(dead_zone.NET_RATES) + len(dead_zone.FEWER)
    assert not excluded
    for run in runs:
        assert run.locked == (abs(run.net) < lock)
        expected = float(theory.adler_mean_rate(run.net, lock))
        assert run.pattern_rate == pytest.approx(expected, rel=2e-4, abs=1e-6 * lock)


def test_locks_at_adlers_angle(outcome: Outcome) -> None:
    """Slowly near the edge: 0.9 W_L relaxes 2.3 times as slowly as 0."""
    assert outcome.finding("lock angle error").si_value == pytest.approx(0.0, abs=0.01 * DEG)


def test_virtual_rotation_moves_the_dead_zone_by_itself(campaign: Campaign) -> None:
    runs, _ = dead_zone.read_runs(campaign, dead_zone.PLAIN)
    moved = [run for run in runs if run.rotation > 0]
    lock = theory.lock_rate(CAPTURING)
    assert all(run.rate > 5 * lock for run in moved)
    assert {run.locked for run in moved} == {True, False}


def test_compensation_gives_the_rate_of_a_pattern_that_rests(outcome: Outcome) -> None:
    """Eq. 5: within 0.1 % of W_L; without it the error is the input itself."""
    finding = outcome.finding("rate error by compensation while locked")
    assert finding.n == 4
    assert abs(finding.si_value) < 1e-3 * theory.lock_rate(CAPTURING)


def test_cancellation_lets_the_pattern_turn(campaign: Campaign) -> None:
    """Eq. 7: the pattern turns with the input, also where it would lock."""
    runs, _ = dead_zone.read_runs(campaign, dead_zone.CANCELLED)
    assert len(runs) == len(dead_zone.FEWER)
    for run in runs:
        assert not run.locked
        assert run.pattern_rate == pytest.approx(run.rate, rel=1e-3)


def test_printed_factor_of_the_paper_would_leave_a_dead_zone() -> None:
    """D/2, as printed in Eq. 4, is 2k times the bias; D/(4k) is it."""
    assert theory.lock_rate(CAPTURING) == pytest.approx(1e-3 / 2 / (2 * CAPTURING.bryan_factor))


def test_a_slow_capture_is_not_waited_for(slow_fmu: GyroFmu) -> None:
    bench = slow_bench(slow_fmu, TYPICAL)
    tests = dead_zone.record(bench)
    outcome = dead_zone.evaluate(bench.campaign(tests))
    lock = outcome.finding("lock rate")
    assert len(tests) == 2
    assert lock.si_value == pytest.approx(theory.lock_rate(TYPICAL), abs=0.001 * DEG_PER_H)
    assert math.isnan(outcome.finding("lock angle error").si_value)
    assert "no free run shows it" in outcome.verdict


def test_no_anisotropy_no_dead_zone(slow_fmu: GyroFmu) -> None:
    bench = slow_bench(slow_fmu, TYPICAL.without_anisotropy(), seed=4)
    outcome = dead_zone.evaluate(bench.campaign(bench.run(dead_zone.plan_map_runs(bench))))
    lock = outcome.finding("lock rate")
    assert lock.si_low == 0.0
    assert lock.si_high < 0.001 * DEG_PER_H


def test_interval_of_a_length_holds_it() -> None:
    """40 of each: at most 6 of 95 % intervals miss, but for 1.4 % of chance."""
    generator = np.random.default_rng(3)
    for true in (0.0, 1.0, 3.0, 30.0):
        missed = 0
        for _ in range(40):
            x, y = generator.normal([true, 0.0], 1.0)
            low, high = compute_length_interval(math.hypot(x, y), 1.0, 200)
            missed += not low <= true <= high
        assert missed <= 6


def test_a_short_run_has_no_mean_rate(slow_fmu: GyroFmu) -> None:
    bench = slow_bench(slow_fmu, CAPTURING)
    course = dead_zone.make_spin(bench, 1.0, 2 * theory.lock_rate(CAPTURING), 200.0)
    log = bench.log(PowerOn("short", dead_zone.PLAIN, course)).log
    with pytest.raises(BenchError, match="short: the pattern is not locked and turned by"):
        read_run(log, Site(latitude=0.0), 0.277)


def test_a_resting_table_has_no_map(slow_fmu: GyroFmu) -> None:
    bench = slow_bench(slow_fmu, CAPTURING)
    course = dead_zone.make_spin(bench, 1.0, 0.0, 200.0)
    campaign = bench.campaign(bench.run([PowerOn("rest", dead_zone.MAP, course)]))
    with pytest.raises(BenchError, match="no log turns the pattern by 90 deg"):
        dead_zone.evaluate(campaign)
