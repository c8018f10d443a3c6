"""Bias tests of a gyro whose bias map is known."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.bench.bench import PowerOn
from pyhrg.bench.bias.bias_test import BiasTest
from pyhrg.bench.bias.position import fixed_position, full_circumference
from pyhrg.bench.bias.position.positions import Plan
from pyhrg.bench.outcome import BenchError
from pyhrg.common.units import ARCSEC, DEG, DEG_PER_H
from pyhrg.device.device import Device
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from pyhrg.theory import closed_forms as theory
from tests.pyhrg.bench.cases import QUIET, make_points, slow_bench


def measure(fmu: GyroFmu, device: Device, plan: Plan, segments: int = 1) -> BiasTest:
    bench = slow_bench(fmu, device)
    power_ons = full_circumference.make_power_ons(bench, plan, 1, segments)
    return full_circumference.measure_bias(bench.campaign(bench.run(power_ons)))


@pytest.mark.parametrize("start", [0.0, 5.0, 11.25, 17.0])
def test_full_circumference_does_not_alias(slow_fmu: GyroFmu, start: float) -> None:
    """Its deviation is the map's, whatever the power-on angle: A/sqrt 2, with n - 1 of 8."""
    device = replace(QUIET, power_on_angle=start * DEG)
    test = measure(slow_fmu, device, full_circumference.SHORTEST)
    expected = theory.circumferential_bias_stability(device) * np.sqrt(8 / 7)
    assert test.stability == pytest.approx(expected, rel=0.005)
    assert test.bias == pytest.approx(theory.mean_bias(device), abs=1e-4 * DEG_PER_H)


def test_positions_45_degrees_apart_alias(slow_fmu: GyroFmu) -> None:
    """The trap that the procedure avoids: A |sin 4(th_0 - th_tau)|, by the start angle."""
    amplitude = abs(theory.static_bias_phasor(QUIET))
    for start in (0.0, 5.625, 11.25, 16.875):
        device = replace(QUIET, power_on_angle=start * DEG)
        first = theory.static_bias(device, device.power_on_angle) - theory.mean_bias(device)
        reported = measure(slow_fmu, device, Plan(8, 45 * DEG)).stability
        expected = abs(float(first)) * np.sqrt(8 / 7)
        assert reported == pytest.approx(expected, abs=0.015 * amplitude)


def test_map_and_tilt_are_recovered(slow_fmu: GyroFmu) -> None:
    """Harmonics of the closed form, Earth's rate times the pick-off errors, and the tilt."""
    device = replace(
        QUIET,
        misalignment=20 * ARCSEC,
        misalignment_direction=40 * DEG,
        drive_frame_rotation=1e-4,
    )
    bench = slow_bench(slow_fmu, device)
    campaign = bench.campaign(bench.run(full_circumference.make_power_ons(bench, runs=1)))
    fitted = full_circumference.fit_map(full_circumference.read_runs(campaign))
    phasor, earth = theory.static_bias_phasor(device), device.site.vertical_rate
    tilt = device.site.horizontal_rate * device.misalignment
    expected = {
        "mean": theory.mean_bias(device),
        "cos4": phasor.real - device.pickoff_gain_mismatch * earth,
        "sin4": phasor.imag - device.pickoff_nonorthogonality * earth,
        "tilt_cos": tilt * np.cos(device.misalignment_direction),
        "tilt_sin": -tilt * np.sin(device.misalignment_direction),
    }
    assert fitted.refused == ()
    for name in fitted.names:
        wanted = expected.get(name, 0.0)
        assert fitted.value(name) == pytest.approx(wanted, abs=2e-5 * DEG_PER_H), name
    points = full_circumference.evaluate(campaign).points
    assert list(points.attrs["units"]) == list(points.columns)
    theta = 4 * DEG * points["pattern_angle_deg"]
    on_map = expected["mean"] + expected["cos4"] * np.cos(theta) + expected["sin4"] * np.sin(theta)
    without_tilt = points["bias_without_tilt_deg_per_h"].to_numpy()
    assert without_tilt == pytest.approx(on_map.to_numpy() / DEG_PER_H, abs=5e-4)
    assert np.ptp(points["bias_deg_per_h"] - without_tilt) > tilt / DEG_PER_H


def test_eight_positions_can_not_show_the_eighth_harmonic(slow_fmu: GyroFmu) -> None:
    bench = slow_bench(slow_fmu, QUIET)
    power_ons = full_circumference.make_power_ons(bench, full_circumference.SHORTEST, 1)
    outcome = full_circumference.evaluate(bench.campaign(bench.run(power_ons)))
    assert "bias cos8" not in [finding.name for finding in outcome.findings]
    assert any("harmonic 8" in warning for warning in outcome.warnings)


def test_fixed_position_sees_one_point_of_the_map(slow_fmu: GyroFmu) -> None:
    bench = slow_bench(slow_fmu, QUIET)
    test = BiasTest(
        fixed_position.read_runs(bench.campaign(bench.run(fixed_position.make_power_ons(bench, 1))))
    )
    at_start = float(theory.static_bias(QUIET, QUIET.power_on_angle))
    assert test.bias == pytest.approx(at_start, abs=0.001 * DEG_PER_H)
    assert test.stability < 0.01 * theory.circumferential_bias_stability(QUIET)


def test_power_ons_differ_in_noise_and_angle(slow_fmu: GyroFmu) -> None:
    bench = slow_bench(slow_fmu, TYPICAL)
    first, second = bench.run(fixed_position.make_power_ons(bench, 2, segments=2))
    assert not np.any(np.isclose(first.log.gyro_angle, second.log.gyro_angle, rtol=1e-9, atol=0.0))
    assert abs(first.log.wave_angle[0] - second.log.wave_angle[0]) > 0.01 * DEG


def test_same_seed_same_numbers_on_any_number_of_workers(slow_fmu: GyroFmu) -> None:
    runs = []
    for workers in (1, 3):
        bench = replace(slow_bench(slow_fmu, TYPICAL), workers=workers)
        tests = bench.run(fixed_position.make_power_ons(bench, 3, segments=1))
        runs.append(np.stack([test.log.gyro_angle for test in tests]))
    assert np.array_equal(*runs)


def test_too_few_positions_are_refused(slow_fmu: GyroFmu) -> None:
    bench = slow_bench(slow_fmu, QUIET)
    (power_on,) = full_circumference.make_power_ons(bench, full_circumference.SHORTEST, 1)
    test = bench.log(power_on)
    half = {name: value[:1500] for name, value in vars(test.log).items() if np.ndim(value)}
    short = replace(test, recording=replace(test.log, **half))
    with pytest.raises(BenchError, match=r"positions_1: 5 positions .* at least 8"):
        full_circumference.evaluate(bench.campaign([short]))


def test_a_log_that_is_too_short_says_how_long_it_is(slow_fmu: GyroFmu) -> None:
    bench = slow_bench(slow_fmu, QUIET)
    short = bench.run([PowerOn("short", "static", bench.programme().rest(20.0))])
    with pytest.raises(BenchError, match=r"30 s from power-on; the longest rest lasts 20 s$"):
        fixed_position.evaluate(bench.campaign(short))


def test_stability_and_repeatability_are_the_papers() -> None:
    """Stability: mean of the runs' deviations; repeatability: deviation of the runs' means."""
    test = BiasTest([make_points([1.0, 3.0]), make_points([2.0, 6.0])])
    assert test.stability == pytest.approx((np.sqrt(2) + np.sqrt(8)) / 2)
    assert test.repeatability == pytest.approx(np.sqrt(2))
    assert test.bias == pytest.approx(3.0)


def test_positions_45_degrees_apart_show_no_harmonic_at_all(slow_fmu: GyroFmu) -> None:
    """The fourth would pass for a tilt of 0.15 deg/h: neither is reported."""
    bench = slow_bench(slow_fmu, QUIET)
    tests = full_circumference.record(bench, positions=8, spacing_deg=45.0, dwell_s=100.0, runs=1)
    outcome = full_circumference.evaluate(bench.campaign(tests))
    names = [finding.name for finding in outcome.findings]
    assert not [name for name in names if "tilt" in name or "cos" in name or "sin" in name]
    assert any("harmonic 4" in warning for warning in outcome.warnings)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"positions": 12}, "12 positions in 7 runs: expected 8, 16, 24"),
        ({"dwell_s": 150.0}, "150 s: expected whole segments of 100 s"),
        ({"runs": 0}, "0 runs"),
        ({"spacing_deg": 0.0}, "0 deg between positions: expected 1 to 720"),
    ],
)
def test_plans_that_can_not_be_had_are_refused(
    slow_fmu: GyroFmu, options: dict[str, float], message: str
) -> None:
    with pytest.raises(BenchError, match=message):
        full_circumference.record(slow_bench(slow_fmu, QUIET), **options)
