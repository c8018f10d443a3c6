"""Measuring range, start-up and bandwidth of the gyro with its loops."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.dynamic import bandwidth, measuring_range, start_up
from pyhrg.bench.outcome import BenchError
from pyhrg.bench.reporting.judgement import judge_findings
from pyhrg.common.units import DEG
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from pyhrg.theory import closed_forms as theory
from tests.pyhrg.bench.cases import QUIET

IDEAL = QUIET.without_anisotropy()


def test_force_to_rebalance_ends_at_the_drives_authority(fmu: GyroFmu) -> None:
    """F = 2 k W holds the pattern at the x axis."""
    model = {"controller.forceToRebalance": 1.0, "drive.authority": 0.1}
    bench = Bench(fmu, replace(IDEAL, power_on_angle=0.0, model=model))
    tests = measuring_range.record(bench, tuple(np.array([5.0, 8, 12]) * DEG), stages=2)
    outcome = measuring_range.evaluate(bench.campaign(tests))
    end = 0.1 / (2 * IDEAL.bryan_factor)
    for name in ("measuring range", "measuring range positive", "measuring range negative"):
        finding = outcome.finding(name)
        assert finding.si_low <= end <= finding.si_high
        assert finding.si_high - finding.si_low < 1 * DEG


def test_whole_angle_has_no_such_end(fmu: GyroFmu) -> None:
    bench = Bench(fmu, replace(TYPICAL, model={"drive.authority": 0.1}))
    tests = measuring_range.record(bench, tuple(np.array([50.0, 500, 5700]) * DEG))
    outcome = measuring_range.evaluate(bench.campaign(tests))
    assert outcome.finding("measuring range").si_value == pytest.approx(5700 * DEG)
    assert outcome.finding("measuring range").si_high == np.inf
    limits = {"measuring_range_deg_per_s": 500.0}
    assert [judgement.word for judgement in judge_findings(outcome, limits)] == ["meets"]
    assert "at least" in outcome.verdict


def test_saturated_pickoffs_leave_no_range(fmu: GyroFmu) -> None:
    bench = Bench(fmu, replace(TYPICAL, model={"pickOff.fullScale": 0.9}))
    tests = measuring_range.record(bench, tuple(np.array([50.0, 80, 100]) * DEG))
    finding = measuring_range.evaluate(bench.campaign(tests)).finding("measuring range")
    assert finding.si_value == 0.0
    assert "slowest step" in finding.note
    assert finding.si_high == pytest.approx(50 * DEG)


def test_range_takes_three_rates(fmu: GyroFmu) -> None:
    bench = Bench(fmu, IDEAL)
    tests = measuring_range.record(bench, (50 * DEG,), stages=1)
    with pytest.raises(BenchError, match="1 positive rates"):
        measuring_range.evaluate(bench.campaign(tests))


def test_two_stages_give_a_rate_within_a_second(fmu: GyroFmu) -> None:
    """Paper 2.3; full accuracy once the average lies behind the ramp that ends at 10 s."""
    bench = Bench(fmu, TYPICAL)
    outcome = start_up.evaluate(bench.campaign(start_up.record(bench, duration=60.0)))
    valid, _, within, greatest = outcome.findings
    assert valid.si_high < 1.0
    assert 10 + start_up.AVERAGE - 0.5 < within.si_value < 10 + start_up.AVERAGE + 1.0
    assert greatest.si_value >= within.si_value


def test_without_start_up_accuracy_takes_one_average(fmu: GyroFmu) -> None:
    """Negative control: full amplitude at once and no noise."""
    model = {"startAmplitude": 1.0, "controller.startUp.firstAmplitude": 1.0}
    bench = Bench(fmu, replace(IDEAL, model=model))
    outcome = start_up.evaluate(bench.campaign(start_up.record(bench, runs=2, duration=60.0)))
    valid, _, within, _ = outcome.findings
    assert valid.si_value <= 0.02
    assert within.si_value == pytest.approx(start_up.AVERAGE, abs=0.02)


def test_least_and_greatest_time_hold_the_median() -> None:
    """Skewed times in whole rows: 98.4 % of 2000 sevens, sigma 0.28 %; more where rows are wide."""
    generator = np.random.default_rng(4)
    for row, most in ((1e-4, 0.984 + 0.01), (0.2, 1.0)):
        whole = np.ceil(generator.lognormal(0.0, 1.0, (2000, 7)) / row) * row
        found = [start_up.summarize_times("time", samples.tolist(), row)[0] for samples in whole]
        inside = np.mean([finding.si_low <= 1.0 <= finding.si_high for finding in found])
        assert 0.984 - 0.01 <= inside <= most


def test_five_times_give_no_interval() -> None:
    median, _ = start_up.summarize_times("time", [1.0, 1.0, 1.0, 1.0, 9.0], 0.01)
    assert median.si_value == 1.0
    assert np.isnan(median.si_low)
    assert "5 of at least 6" in median.note


def test_start_up_without_the_valid_column_says_so(fmu: GyroFmu) -> None:
    bench = Bench(fmu, TYPICAL)
    tests = start_up.record(bench, runs=2, duration=60.0)
    logs = [replace(t.log, valid=np.full_like(t.log.time, np.nan)) for t in tests]
    bare = [replace(t, recording=log) for t, log in zip(tests, logs, strict=True)]
    outcome = start_up.evaluate(bench.campaign(bare))
    assert "taken from the amplitude" in outcome.warnings[0]
    assert outcome.findings[0].si_value == pytest.approx(8.0, abs=0.1)  # of 1 to 10 s, 0.1 to 1


def test_a_short_start_up_is_refused(fmu: GyroFmu) -> None:
    bench = Bench(fmu, TYPICAL)
    with pytest.raises(BenchError, match="30 s; the start-up takes 40 s"):
        start_up.evaluate(bench.campaign(start_up.record(bench, runs=2, duration=30.0)))


def test_whole_angle_output_follows_at_once(fmu: GyroFmu) -> None:
    bench = Bench(fmu, IDEAL)
    outcome = bandwidth.evaluate(bench.campaign(bandwidth.record(bench, periods=4)))
    width, delay, low, high = outcome.findings
    assert width.si_high == np.inf
    assert width.value == pytest.approx(450)
    assert delay.si_value == pytest.approx(0.0, abs=1e-8)
    expected = 1 + theory.hold_scale_factor_error(1e-3, 0.0, IDEAL.decay_time)
    assert low.si_value == pytest.approx(expected, abs=2e-7)
    assert high.si_value == pytest.approx(1.0, abs=1e-5)


def test_a_slow_output_has_a_bandwidth_and_a_delay(fmu: GyroFmu) -> None:
    """What is found of an output behind a first-order lag is the lag's own, to a row's length."""
    bench = Bench(fmu, IDEAL)
    test = bandwidth.record(bench, periods=6)[0]
    lag, step = 2e-3, 1e-3
    share = np.exp(-step / lag)
    slow = np.zeros_like(test.log.gyro_angle)
    for i in range(1, len(slow)):
        slow[i] = share * slow[i - 1] + (1 - share) * test.log.gyro_angle[i]
    found = bandwidth.measure_response(replace(test.log, gyro_angle=slow))
    turn = np.exp(-2j * np.pi * found.frequency * step)
    np.testing.assert_allclose(found.mean, (1 - share) / (1 - share * turn), rtol=1e-2)
    assert 50 < bandwidth.find_bandwidth(found).value < 100


def test_rows_of_a_second_show_no_bandwidth(fmu: GyroFmu) -> None:
    bench = Bench(fmu, IDEAL)
    course = bench.programme(1.0).spin(1 * DEG, 20.0)
    tests = bench.run([PowerOn("slow", bandwidth.KIND, course)])
    with pytest.raises(BenchError, match="slow: 0 seconds"):
        bandwidth.evaluate(bench.campaign(tests))
