"""What the identification tests find in gyros that are known."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import binom

from benchmarks.intervals import _identified as identified
from benchmarks.intervals import amplitude_sweep as amplitude_case
from benchmarks.intervals import phase_step as phase_case
from benchmarks.intervals import rate_reversal as rate_case
from benchmarks.intervals import ring_down as ring_down_case
from benchmarks.intervals import virtual_rotation as rotation_case
from benchmarks.intervals._identified import Intervals
from pyhrg.bench.identification import (
    amplitude_sweep,
    force_map,
    phase_step,
    rate_reversal,
    ring_down,
    virtual_rotation,
)
from pyhrg.bench.outcome import BenchError
from pyhrg.common.units import DEG
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from tests.pyhrg.bench.cases import QUIET, record_and_evaluate, slow_bench

REPEATS = 40
LEAST = int(binom.ppf(1e-4, REPEATS, 0.95))
"""Of 40 intervals of 95 %, fewer hold the truth once in 10 000 times."""
IDEAL = Device(angle_random_walk=1e-4 * DEG / 60, angle_white_noise=1e-7, frequency_split=2e-3)


def test_ring_down_finds_the_shell(slow_fmu: GyroFmu) -> None:
    """Errors of drives and pick-offs, which the device has, take no part."""
    outcome = record_and_evaluate(ring_down.PROCEDURE, slow_bench(slow_fmu, QUIET))
    found = {finding.name: finding.si_value for finding in outcome.findings}
    assert found["decay time"] == pytest.approx(QUIET.decay_time, rel=1e-7)
    assert found["damping anisotropy"] == pytest.approx(QUIET.damping_anisotropy, rel=1e-5)
    assert found["damping axis"] == pytest.approx(QUIET.damping_axis, abs=1e-5)
    assert found["frequency split"] == pytest.approx(QUIET.frequency_split, rel=1e-6)
    assert found["stiffness axis"] == pytest.approx(QUIET.stiffness_axis, abs=1e-6)
    assert not outcome.warnings


@pytest.mark.parametrize(("split", "cut"), [(1e-6, 0), (3.1e-3, 1), (5e-2, 1)])
def test_ring_down_settles_on_any_split(slow_fmu: GyroFmu, split: float, cut: int) -> None:
    """None to speak of; one whose quadrature after 300 s takes seconds to drive out; one that wants
    rows of 0.1 s. Rows beyond half a radian of split times time are left out."""
    bench = identified.bench(slow_fmu, 1005)
    bench = replace(bench, device=replace(bench.device, frequency_split=split))
    outcome = ring_down.evaluate(bench.campaign(ring_down.record(bench, 4, decay=300.0)))
    assert outcome.finding("decay time").si_value == pytest.approx(
        bench.device.decay_time, rel=1e-4
    )
    assert outcome.finding("frequency split").si_value == pytest.approx(split, abs=2e-5)
    assert [text.split(":")[0] for text in outcome.exclusions] == ["ring_down"] * cut


def test_intervals_of_a_ring_down_hold_a_large_split(slow_fmu: GyroFmu) -> None:
    """Of 0.6 to 1.8 mHz over 120 s, up to 1.36 rad. With all rows used, 84 of these
    100 intervals held the truth."""
    repeats = [ring_down_case.repeat(slow_fmu, seed) for seed in range(1, REPEATS, 2)]
    held = [
        low <= truth <= high
        for found in repeats
        for name, (truth, low, high) in found.items()
        if name.endswith(("time", "cos4", "sin4"))
    ]
    assert sum(held) >= binom.ppf(1e-4, len(held), 0.95)


def test_a_split_that_leaves_no_rows_is_refused(slow_fmu: GyroFmu) -> None:
    bench = slow_bench(slow_fmu, replace(QUIET, frequency_split=0.5))
    with pytest.raises(
        BenchError, match=r"79\.6 mHz allows 1 s of a ring-down .* 10 rows of 0\.1 s"
    ):
        ring_down.evaluate(bench.campaign(ring_down.record(bench, positions=2, decay=30.0)))


def test_rate_reversal_finds_the_pickoffs(slow_fmu: GyroFmu) -> None:
    outcome = record_and_evaluate(rate_reversal.PROCEDURE, slow_bench(slow_fmu, QUIET))
    gain = outcome.finding("pick-off gain mismatch").si_value
    skew = outcome.finding("pick-off non-orthogonality").si_value
    assert gain == pytest.approx(QUIET.pickoff_gain_mismatch, abs=1e-8)
    assert skew == pytest.approx(QUIET.pickoff_nonorthogonality, abs=1e-8)


def test_virtual_rotation_finds_pickoffs_and_drives_together(slow_fmu: GyroFmu) -> None:
    outcome = record_and_evaluate(virtual_rotation.PROCEDURE, slow_bench(slow_fmu, QUIET))
    gain = QUIET.pickoff_gain_mismatch + QUIET.drive_gain_mismatch
    found = outcome.finding("gain mismatch of pick-offs and drives").si_value
    assert found == pytest.approx(gain, abs=1e-8)


def test_force_map_finds_the_split(slow_fmu: GyroFmu) -> None:
    """The axis is the pick-offs', off by a quarter of their non-orthogonality."""
    outcome = record_and_evaluate(force_map.PROCEDURE, slow_bench(slow_fmu, QUIET))
    axis = QUIET.stiffness_axis + QUIET.pickoff_nonorthogonality / 4
    assert outcome.finding("frequency split").si_value == pytest.approx(
        QUIET.frequency_split, rel=1e-6
    )
    assert outcome.finding("stiffness axis").si_value == pytest.approx(axis, abs=2e-6)


def test_amplitude_sweep_finds_stiffness_and_cubic(slow_fmu: GyroFmu) -> None:
    device = replace(QUIET, duffing=1e-3, pickoff_cubic=2e-5)
    outcome = record_and_evaluate(amplitude_sweep.PROCEDURE, slow_bench(slow_fmu, device))
    assert outcome.finding("Duffing shift").si_value == pytest.approx(1e-3, rel=1e-4)
    assert outcome.finding("pick-off cubic").si_value == pytest.approx(2e-5, rel=2e-3)


def test_phase_step_responds_as_the_force_says(slow_fmu: GyroFmu) -> None:
    outcome = record_and_evaluate(phase_step.PROCEDURE, slow_bench(slow_fmu, QUIET))
    assert outcome.findings[0].si_value == pytest.approx(1.0, abs=1e-4)


@pytest.mark.parametrize(
    "repeat", [rotation_case.repeat, rate_case.repeat, phase_case.repeat, amplitude_case.repeat]
)
def test_intervals_hold_the_truth(
    slow_fmu: GyroFmu, repeat: Callable[[GyroFmu, int], Intervals]
) -> None:
    repeats = [repeat(slow_fmu, seed) for seed in range(REPEATS)]
    for name in repeats[0]:
        inside = sum(low <= truth <= high for truth, low, high in (r[name] for r in repeats))
        assert inside >= LEAST, name


def test_nothing_is_found_where_nothing_is(slow_fmu: GyroFmu) -> None:
    """A gyro without anisotropy: the intervals hold zero, and an axis is refused."""
    outcome = record_and_evaluate(ring_down.PROCEDURE, slow_bench(slow_fmu, IDEAL, seed=5))
    for name in ("damping anisotropy cos4", "damping anisotropy sin4"):
        finding = outcome.finding(name)
        assert finding.si_low < 0 < finding.si_high
    assert np.isnan(outcome.finding("damping axis").si_value)
    assert outcome.finding("damping anisotropy").si_low == 0.0


def test_one_direction_is_refused(slow_fmu: GyroFmu) -> None:
    """Bias and error of the pick-offs are the same at one rate."""
    bench = slow_bench(slow_fmu, QUIET)
    campaign = bench.campaign(rate_reversal.record(bench, rates=(5 * DEG,)))
    with pytest.raises(BenchError, match="both ways"):
        rate_reversal.evaluate(campaign)


def test_fast_turns_are_left_out(slow_fmu: GyroFmu) -> None:
    """Loops that lag would pass for pick-offs."""
    bench = slow_bench(slow_fmu, QUIET)
    rates = [sign * rate * DEG for rate in (5, 100) for sign in (1, -1)]
    outcome = rate_reversal.evaluate(bench.campaign(rate_reversal.record(bench, rates)))
    assert [text.split(":")[0] for text in outcome.exclusions] == [
        "rate_100dps_pos",
        "rate_100dps_neg",
    ]
    only_fast = bench.campaign(rate_reversal.record(bench, rates[2:]))
    with pytest.raises(BenchError, match="above 20 deg/s"):
        rate_reversal.evaluate(only_fast)


def test_one_angle_is_warned_of(slow_fmu: GyroFmu) -> None:
    bench = slow_bench(slow_fmu, QUIET)
    campaign = bench.campaign(ring_down.record(bench, positions=1))
    assert any("near one pattern angle" in text for text in ring_down.evaluate(campaign).warnings)


def test_a_drive_that_stays_on_is_no_ring_down(slow_fmu: GyroFmu) -> None:
    bench = slow_bench(slow_fmu, QUIET)
    tests = [replace(test, kind="ring_down") for test in phase_step.record(bench)]
    with pytest.raises(BenchError, match="nowhere off"):
        ring_down.evaluate(bench.campaign(tests))


def test_one_amplitude_is_refused(slow_fmu: GyroFmu) -> None:
    bench = slow_bench(slow_fmu, QUIET)
    campaign = bench.campaign(amplitude_sweep.record(bench, amplitudes=(1.0,)))
    with pytest.raises(BenchError, match="1 amplitude"):
        amplitude_sweep.evaluate(campaign)


def test_gaps_leave_the_result(slow_fmu: GyroFmu) -> None:
    """Rows that are missing split the record; the rest says the same."""
    bench = slow_bench(slow_fmu, QUIET)
    tests = rate_reversal.record(bench)
    holes = np.where(np.arange(len(tests[0].log.time)) % 500 < 3, np.nan, tests[0].log.gyro_angle)
    spoilt = replace(tests[0], recording=replace(tests[0].log, gyro_angle=holes))
    outcome = rate_reversal.evaluate(bench.campaign([spoilt, *tests[1:]]))
    found = outcome.finding("pick-off gain mismatch").si_value
    assert found == pytest.approx(QUIET.pickoff_gain_mismatch, abs=1e-8)
