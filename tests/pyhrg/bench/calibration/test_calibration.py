"""Calibration: maps recovered, applied, and refused where the records can't give them."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from benchmarks.intervals.calibration import PLAN, drawn, repeat, truth
from pyhrg.bench.bias.position.full_circumference import make_power_ons
from pyhrg.bench.calibration.calibration import (
    AFTER,
    CONTROL,
    PERIODS,
    RATE,
    apply_maps,
    evaluate,
    record,
    select_stage,
    stage_bench,
)
from pyhrg.bench.calibration.calibration_maps import add_maps, fit_maps, turn_map
from pyhrg.bench.outcome import BenchError, Outcome
from pyhrg.bench.scale_factor.scale_factor import make_turn_power_ons
from pyhrg.common.units import ARCSEC, DEG, DEG_PER_H
from pyhrg.device import device_file
from pyhrg.device.device import AngleMap, Device
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from pyhrg.records.campaign import Campaign
from pyhrg.theory import closed_forms as theory
from tests.pyhrg.bench.cases import QUIET, slow_bench

RICH = replace(TYPICAL, demodulation_offset=2e-5, pickoff_cubic=3e-5, misalignment=5e-5)
"""Errors in every harmonic, and a tilted input axis."""
NOISELESS = replace(RICH.without_noise(), power_on_scatter=0.0)


def measured(fmu: GyroFmu, device: Device, seed: int = 1) -> Campaign:
    bench = slow_bench(fmu, device, seed)
    turns = make_turn_power_ons(bench, RATE, PERIODS, 1)
    tests = bench.run([*make_power_ons(bench, PLAN, 3, 1), *turns])
    return bench.campaign(tests)


def deviation(campaign: Campaign) -> float:
    """Over the circumference, deg/h."""
    return evaluate(campaign).finding("bias stability before").value


@pytest.fixture(scope="module")
def campaign(slow_fmu: GyroFmu) -> Campaign:
    bench = slow_bench(slow_fmu, RICH)
    return bench.campaign(record(bench, PLAN, runs=3, segments=1))


@pytest.fixture(scope="module")
def outcome(campaign: Campaign) -> Outcome:
    return evaluate(campaign)


def test_maps_of_a_noiseless_gyro(slow_fmu: GyroFmu) -> None:
    """Within 2e-4 deg/h of 0.15 and 2e-3 arcsec of 2: a thousandth."""
    found, expected = fit_maps(measured(slow_fmu, NOISELESS)), truth(NOISELESS)
    for coefficients, tolerance in (
        (found.bias_map, 2e-4 * DEG_PER_H),
        (found.scale_factor_map, 2e-3 * ARCSEC),
    ):
        assert len(coefficients) > 5
        for finding in coefficients.values():
            assert finding.si_value == pytest.approx(expected[finding.name], abs=tolerance)


def test_maps_leave_the_noise(outcome: Outcome) -> None:
    before, after = (outcome.finding(f"bias stability {x}") for x in ("before", "after"))
    assert before.value > 0.1
    # noise of 100 s means, 1e-4 deg/sqrt(h) * 6, and tilt, 5e-5 of 11.5 deg/h once a turn
    assert after.value == pytest.approx(np.hypot(6e-4, 4.1e-4), rel=0.25)
    assert after.si_high < before.si_low / 50
    left = outcome.finding("scale factor variation after")
    assert left.si_high < outcome.finding("scale factor variation before").si_low / 50


def test_wrong_maps_make_it_worse(outcome: Outcome) -> None:
    """Those of a gyro whose axes stand at 45 deg: the fourth harmonic doubles."""
    for name in ("bias stability", "scale factor variation"):
        before, wrong = (outcome.finding(f"{name} {x}") for x in ("before", "with a wrong map"))
        assert 1.5 * before.si_high < wrong.si_low < 2.1 * before.si_value


@pytest.mark.parametrize("seed", [1, 4, 5])
def test_map_of_another_gyro_leaves_the_difference(slow_fmu: GyroFmu, seed: int) -> None:
    """Fourth harmonics H of both: what is left is |H - H'|/sqrt 2, with n - 1 of 24 positions."""
    found = fit_maps(measured(slow_fmu, QUIET))
    other = QUIET.another(np.random.default_rng(seed))
    left = theory.static_bias_phasor(other) - theory.static_bias_phasor(QUIET)
    expected = abs(left) / np.sqrt(2) * np.sqrt(24 / 23) / DEG_PER_H
    assert deviation(measured(slow_fmu, apply_maps(other, found))) == pytest.approx(
        expected, rel=0.05
    )


def test_noise_of_the_second_measurement_is_its_own(slow_fmu: GyroFmu) -> None:
    bench = slow_bench(slow_fmu, TYPICAL)
    seeds = {bench.seed, *(stage_bench(bench, TYPICAL, x).seed for x in (AFTER, CONTROL))}
    assert len(seeds) == 3


def test_without_a_second_measurement_it_says_so(slow_fmu: GyroFmu) -> None:
    outcome = evaluate(measured(slow_fmu, RICH))
    assert any("not measured" in text for text in outcome.warnings)
    assert "not verified" in outcome.verdict
    with pytest.raises(KeyError):
        outcome.finding("bias stability after")


def test_maps_add_to_those_applied(slow_fmu: GyroFmu) -> None:
    """Calibrating a calibrated gyro changes nothing."""
    first = fit_maps(measured(slow_fmu, NOISELESS))
    second = fit_maps(measured(slow_fmu, apply_maps(NOISELESS, first)))
    for one, other in (
        (first.bias_map, second.bias_map),
        (first.scale_factor_map, second.scale_factor_map),
    ):
        largest = max(abs(f.si_value) for f in one.values())
        assert max(abs(f.si_value) for f in other.values()) < 2e-3 * largest
    assert abs(second.scale_factor) < 0.02 * abs(first.scale_factor)


def test_true_bryan_factor_is_kept() -> None:
    device = add_maps(replace(TYPICAL, bryan_factor_error=3e-6), AngleMap(), AngleMap(), 2e-6)
    true = device.bryan_factor * (1 + device.bryan_factor_error)
    assert true == pytest.approx(TYPICAL.bryan_factor * (1 + 3e-6), rel=1e-12)
    assert device.bryan_factor == pytest.approx(TYPICAL.bryan_factor * (1 + 2e-6), rel=1e-12)


def test_turned_map_is_the_map_of_turned_axes() -> None:
    coefficients = AngleMap(0.1, 0.2, -0.3, 0.4, 0.5, -0.6, 0.7)

    def value(m: AngleMap, th: float) -> float:
        waves = ((m.cos2, m.sin2, 2), (m.cos4, m.sin4, 4), (m.cos8, m.sin8, 8))
        return m.mean + sum(c * np.cos(h * th) + s * np.sin(h * th) for c, s, h in waves)

    for angle in (0.0, 0.3, 45 * DEG):
        assert value(turn_map(coefficients, angle), 1.0) == pytest.approx(
            value(coefficients, 1.0 - angle)
        )


def test_calibrated_gyro_is_a_device_file(outcome: Outcome, tmp_path: Path) -> None:
    maps = [AngleMap(**outcome.values[name]) for name in ("bias_map", "scale_factor_map")]  # type: ignore[arg-type]
    device = add_maps(RICH, *maps)
    device_file.write(device, tmp_path / "gyro.toml")
    back = device_file.read(tmp_path / "gyro.toml")
    assert back.scale_factor_map.sin4 == pytest.approx(-RICH.pickoff_gain_mismatch / 4, rel=0.01)
    assert vars(back.bias_map) == pytest.approx(vars(device.bias_map), rel=1e-12)
    assert "[scale_factor_map]" in (tmp_path / "gyro.toml").read_text()


def test_turns_one_way_are_refused(campaign: Campaign) -> None:
    one_way = replace(campaign, tests=tuple(t for t in campaign.tests if "neg" not in t.id))
    with pytest.raises(BenchError, match="both ways"):
        fit_maps(one_way)


def test_other_kinds_are_refused(campaign: Campaign) -> None:
    turns = replace(campaign, tests=tuple(t for t in campaign.tests if t.kind == "rate"))
    with pytest.raises(BenchError, match="no test of kind positions"):
        fit_maps(turns)


def test_stages_are_told_apart(campaign: Campaign) -> None:
    after = select_stage(campaign, AFTER)
    assert after is not None
    assert {t.kind for t in after.tests} == {"positions", "rate"}
    assert all(t.id.endswith(AFTER) for t in after.tests)
    assert select_stage(campaign, "elsewhere") is None


def test_a_perfect_gyro_has_maps_of_zero(slow_fmu: GyroFmu) -> None:
    """Of 104 intervals 99 hold zero on average; 3.5 binomial deviations below is 91."""
    noise = TYPICAL.without_anisotropy()
    inside = []
    for seed in range(8):
        found = fit_maps(measured(slow_fmu, noise, seed))
        coefficients = [*found.bias_map.values(), *found.scale_factor_map.values()]
        inside += [f.si_low <= 0.0 <= f.si_high for f in coefficients]
    assert len(inside) == 104
    assert sum(inside) >= 91


def test_intervals_hold_what_was_put_in(slow_fmu: GyroFmu) -> None:
    """As above, of gyros drawn at random; `benchmarks.intervals` has the thousand."""
    inside = [
        low <= value <= high for s in range(8) for value, low, high in repeat(slow_fmu, s).values()
    ]
    assert len(inside) == 104
    assert sum(inside) >= 91


def test_drawn_gyros_differ() -> None:
    one, other = (truth(drawn(np.random.default_rng(seed))) for seed in (1, 2))
    zero = {"bias map cos2", "bias map cos8", "scale factor map cos2", "scale factor map cos8"}
    assert {name for name in one if one[name] == other[name]} == zero
