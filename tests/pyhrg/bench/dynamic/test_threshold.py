"""Threshold: none in whole-angle mode, unless a dead zone has had time to capture the pattern."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.bench.bench import PowerOn
from pyhrg.bench.dynamic import threshold
from pyhrg.bench.outcome import BenchError
from pyhrg.common.units import DEG
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from pyhrg.theory import closed_forms as theory
from tests.pyhrg.bench.cases import QUIET, slow_bench

PAPER = replace(QUIET, damping_anisotropy=1.93e-5)
"""Its dead zone is the paper's, 0.001 deg/s."""
CAPTURED = replace(QUIET.without_anisotropy(), damping_anisotropy=2e-3)


def test_an_ordinary_test_does_not_see_the_dead_zone(slow_fmu: GyroFmu) -> None:
    """The output is W + B(th) while the pattern is on its way to the lock, for hours."""
    assert theory.lock_rate(PAPER) / DEG == pytest.approx(1e-3, rel=0.01)
    bench = slow_bench(slow_fmu, PAPER)
    outcome = threshold.evaluate(bench.campaign(threshold.record(bench, repeats=2)))
    assert outcome.finding("threshold").si_value == pytest.approx(1e-5 * DEG)
    assert outcome.finding("response to positive 0.001 deg per s").si_value == pytest.approx(
        1.0, abs=0.005
    )
    assert "not seen here" in outcome.warnings[0]


def test_long_dwells_do(slow_fmu: GyroFmu) -> None:
    """Adler: half of the input comes out at 2/sqrt 3 W_L; less than W_L gives nothing."""
    lock = theory.lock_rate(CAPTURED)
    bench = slow_bench(slow_fmu, CAPTURED)
    rates = tuple(np.array([0.5, 1.05, 1.3]) * lock)
    tests = threshold.record(bench, rates, repeats=2, dwell=10000.0)
    found = threshold.measure_responses([test.log for test in tests])
    outcome = threshold.evaluate(bench.campaign(tests))
    for response in found:
        if abs(response.rate) < lock:
            assert abs(response.value) < 1e-3
    finding = outcome.finding("threshold")
    assert finding.si_low < 2 / np.sqrt(3) * lock < finding.si_high


def test_responses_are_covered(slow_fmu: GyroFmu) -> None:
    """24 intervals; 95 % each, so that 18 or fewer have a chance of 1e-3."""
    inside = 0
    for seed in range(6):
        bench = slow_bench(slow_fmu, TYPICAL, seed)
        tests = threshold.record(bench, (2e-4 * DEG, 5e-5 * DEG), repeats=3)
        found = threshold.measure_responses([test.log for test in tests])
        inside += sum(abs(r.value - 1) <= r.reach for r in found)
    assert inside >= 19


def test_noise_is_no_response(slow_fmu: GyroFmu) -> None:
    """At a rate far below the noise the threshold's interval says that nothing is certain."""
    noisy = replace(TYPICAL, angle_random_walk=10000 * TYPICAL.angle_random_walk)
    bench = slow_bench(slow_fmu, noisy)
    outcome = threshold.evaluate(bench.campaign(threshold.record(bench, repeats=2)))
    assert outcome.finding("threshold").si_high == np.inf


def test_a_log_without_repeats_is_refused(slow_fmu: GyroFmu) -> None:
    bench = slow_bench(slow_fmu, QUIET)
    course = threshold.make_programme(bench, [1e-3 * DEG], 1, 100.0)
    tests = bench.run([PowerOn("once", threshold.KIND, course)])
    with pytest.raises(BenchError, match="once: 2 dwells at 2 rates"):
        threshold.evaluate(bench.campaign(tests))
