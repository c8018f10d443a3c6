"""Random walk without and with virtual rotation, on the FMU and on records from elsewhere."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure

from benchmarks.intervals import random_walk as coverage
from pyhrg.bench.bench import PowerOn
from pyhrg.bench.noise import random_walk
from pyhrg.bench.outcome import BenchError, Outcome
from pyhrg.bench.readings.noise_records import find_noise_records
from pyhrg.common.units import ARCSEC, DEG
from pyhrg.device.device import Device
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from pyhrg.records import campaign
from tests.pyhrg.bench.cases import QUIET, slow_bench


def measured(fmu: GyroFmu, device: Device, seed: int = 1) -> Outcome:
    bench = slow_bench(fmu, device, seed)
    return random_walk.evaluate(
        bench.campaign(bench.run(random_walk.plan_power_ons(bench, 3000.0)))
    )


def test_typical_gyro_walks_ten_times_as_fast_under_virtual_rotation(slow_fmu: GyroFmu) -> None:
    """The paper's order of magnitude, by the relative noise s of the commanded rotation: V s."""
    turning = random_walk.ROTATION * TYPICAL.model[coverage.NOISE]
    expected = math.hypot(TYPICAL.angle_random_walk, turning) / TYPICAL.angle_random_walk
    assert expected == pytest.approx(10, rel=0.01)
    ratio = measured(slow_fmu, TYPICAL).finding(random_walk.RATIO)
    assert ratio.si_low < expected < ratio.si_high
    assert ratio.si_high / ratio.si_low < 1.5


def test_quiet_rotation_has_the_ratio_one(slow_fmu: GyroFmu) -> None:
    """Negative control: the bias map, fifty times as large, is not taken for noise."""
    device = replace(TYPICAL, damping_anisotropy=50 * TYPICAL.damping_anisotropy, model={})
    outcome = measured(slow_fmu, device)
    ratio = outcome.finding(random_walk.RATIO)
    assert ratio.si_low < 1 < ratio.si_high
    for name in ("bias instability", "rate random walk"):
        for state in ("", " under virtual rotation"):
            assert outcome.finding(name + state).si_low == 0


def test_intervals_hold_the_devices_noises(slow_fmu: GyroFmu) -> None:
    """95 % of 30 devices less 3.5 sigma: 24; `benchmarks.intervals` has the thousand."""
    held: dict[str, list[bool]] = {}
    for seed in range(30):
        for name, (truth, low, high) in coverage.repeat(slow_fmu, seed).items():
            held.setdefault(name, []).append(low <= truth <= high)
    for name, holds in held.items():
        n = len(holds)
        assert sum(holds) >= 0.95 * n - 3.5 * math.sqrt(n * 0.95 * 0.05), name


def test_without_noise_nothing_is_left_but_the_models_rounding(slow_fmu: GyroFmu) -> None:
    """What is removed is all that virtual rotation brings but noise: to 1e-4 arcsec of 1.2."""
    device = replace(QUIET, model={})
    bench = slow_bench(slow_fmu, device)
    (test,) = bench.run(random_walk.plan_power_ons(bench, 3000.0)[1:])
    (found,) = find_noise_records(test.log)
    assert np.std(found.spectrum.rest) < 1e-4 * ARCSEC
    time, angle = test.log.time, test.log.gyro_angle
    line = np.polynomial.Polynomial.fit(time, angle, 1)
    assert np.std(angle - line(time)) > 0.5 * ARCSEC


def test_commands_that_change_part_a_log(slow_fmu: GyroFmu) -> None:
    """Table, rotation and power-on leave stretches that begin after they have settled."""
    bench = slow_bench(slow_fmu, TYPICAL)
    course = bench.programme().attitude(0.0).rest(400.0).turn(30 * DEG, 10 * DEG).rest(400.0)
    course.command(virtual_rotation=1 * DEG).rest(400.0)
    course.command(virtual_rotation=-1 * DEG).rest(200.0)
    (test,) = bench.run([PowerOn("parts", "static", course)])
    found = find_noise_records(test.log)
    assert [part.rotation for part in found] == pytest.approx([0.0, 0.0, 1 * DEG])
    assert [part.n for part in found] == pytest.approx([371, 390, 390], abs=2)


def test_records_that_cannot_say_it_are_refused(slow_fmu: GyroFmu) -> None:
    bench = slow_bench(slow_fmu, TYPICAL)
    short = bench.run([PowerOn("short", "static", bench.programme().rest(200.0))])
    with pytest.raises(BenchError, match=r"short: no stretch .* 256 rows .*; the longest has 200"):
        random_walk.evaluate(bench.campaign(short))
    still = bench.programme().rest(400.0)
    wrong = bench.run([PowerOn("still", "virtual_rotation", still)])
    with pytest.raises(BenchError, match=r"still: .* is with virtual rotation"):
        random_walk.evaluate(bench.campaign(wrong))
    with pytest.raises(BenchError, match="no test of kind static or virtual_rotation"):
        random_walk.evaluate(bench.campaign([]))


def test_one_state_alone_has_no_ratio(slow_fmu: GyroFmu) -> None:
    bench = slow_bench(slow_fmu, TYPICAL)
    outcome = random_walk.evaluate(bench.campaign(bench.run(random_walk.plan_power_ons(bench)[:1])))
    assert outcome.finding("angle random walk").si_low > 0
    for name in ("angle random walk under virtual rotation", random_walk.RATIO):
        assert math.isnan(outcome.finding(name).si_value)
        assert outcome.finding(name).note


def test_recorded_campaign(recorded_campaign: Path) -> None:
    """Its noises are those of its nominal, and its rotation adds none."""
    recorded = campaign.read_campaign(recorded_campaign)
    outcome = random_walk.evaluate(recorded)
    for name, key in (
        ("angle random walk", "angle_random_walk_deg_sqrt_h"),
        ("white angle noise", "angle_white_noise_arcsec"),
    ):
        low, high = outcome.finding(name).interval
        assert low < recorded.nominal[key] < high
    ratio = outcome.finding(random_walk.RATIO)
    assert ratio.si_low < 1 < ratio.si_high
    assert any("crept over 2.7 deg" in text for text in outcome.warnings)
    assert outcome.draw is not None
    figure = Figure(figsize=(8, 5))
    outcome.draw(figure)
    assert len(figure.axes[0].lines) > 4


def test_pattern_angles_follow_from_the_output_where_they_are_not_logged(
    slow_fmu: GyroFmu,
) -> None:
    bench = slow_bench(slow_fmu, TYPICAL)
    given = bench.campaign(bench.run(random_walk.plan_power_ons(bench, 3000.0)))
    tests = [
        replace(t, recording=replace(t.log, wave_angle=np.full(len(t.log.time), np.nan)))
        for t in given.tests
    ]
    whole, lacking = (random_walk.evaluate(c) for c in (given, replace(given, tests=tuple(tests))))
    assert lacking.warnings == whole.warnings
    for name in ("angle random walk", "angle random walk under virtual rotation"):
        expected = whole.finding(name)
        assert lacking.finding(name).si_value == pytest.approx(expected.si_value, rel=1e-3)
