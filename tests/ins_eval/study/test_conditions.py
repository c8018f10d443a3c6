"""Conditions in which the thesis may fail: each is what it says it is."""

from dataclasses import replace

import numpy as np
import pytest

from ins_eval.mission_model.gyro_map import TERMS, undo_start
from ins_eval.mission_model.position_errors import TriadBlock
from ins_eval.study.conditions import CONDITIONS, NOISY_DRIVES, ConditionSample
from ins_eval.study.gyros.drawn_triad import (
    DrawnTriad,
    TriadDistribution,
    draw_triad,
    make_triad_seed,
    tabulate_triads,
)
from ins_eval.study.gyros.population import TRIMMED
from ins_eval.study.specification import TEST
from pyhrg.bench.calibration.calibration_maps import add_maps
from pyhrg.common.units import DEG_PER_H
from pyhrg.device.device import AngleMap
from pyhrg.fmu import GyroFmu
from tests.ins_eval.study.cases import study

KIND = TriadDistribution(TRIMMED, "mean")
STUDY = study(triads=80)
NUMBERS = (40, 41)


@pytest.fixture(scope="module")
def drawn(slow_fmu: GyroFmu) -> dict[int, DrawnTriad]:
    return {n: draw_triad(slow_fmu, KIND, make_triad_seed(STUDY.seed, n)) for n in NUMBERS}


@pytest.fixture(scope="module")
def flying(slow_fmu: GyroFmu, drawn: dict[int, DrawnTriad]) -> dict[str, TriadBlock]:
    sample = ConditionSample(
        STUDY, KIND, slow_fmu, drawn, tabulate_triads(slow_fmu, [*drawn.values()])
    )
    return {condition.title: condition.triads(sample) for condition in CONDITIONS}


def test_straight_and_level_flies_the_gyros_of_the_study(
    slow_fmu: GyroFmu, drawn: dict[int, DrawnTriad], flying: dict[str, TriadBlock]
) -> None:
    own = vars(tabulate_triads(slow_fmu, [*drawn.values()]))
    for name, values in vars(flying["straight and level for an hour"]).items():
        np.testing.assert_array_equal(values, own[name], err_msg=name)


def at_start(triads: TriadBlock) -> np.ndarray:
    """(r, 3) bias at power-on, rad/s: the mean and the cosines of the map from there."""
    return triads.in_flight[:, [0, 1, 3, 5, 7]].sum(axis=1)


def test_bias_at_power_on_is_what_the_bench_missed(flying: dict[str, TriadBlock]) -> None:
    """What is left is drift and the bench's noise: a small part of what was there."""
    there = at_start(flying["straight and level for an hour"])
    left = at_start(flying["straight and level for an hour, bias at power-on taken out"])
    assert np.sqrt(np.mean(left**2)) < 0.2 * np.sqrt(np.mean(there**2))


def test_calibration_at_the_fixed_position_takes_out_what_that_test_reads(
    flying: dict[str, TriadBlock],
) -> None:
    """Before, the test's mean bias is the map's value at the start angle; afterwards little of it
    is left, and the circumference's figure is as it was."""
    before = flying["straight and level for an hour"]
    there = at_start(before)
    assert np.sqrt(np.mean((before.fixed_bias - there) ** 2)) < 0.2 * np.sqrt(np.mean(there**2))
    for mission in ("car", "aircraft"):
        after = flying[f"calibrated at the fixed position, {mission}"]
        np.testing.assert_allclose(at_start(after), there - before.fixed_bias)
        change = after.fitted_map - before.fitted_map
        np.testing.assert_allclose(change[:, 0], -before.fixed_bias)
        assert not change[:, 1:].any()
        np.testing.assert_array_equal(after.circumference_stability, before.circumference_stability)


def test_self_calibrated_gyros_fly_small_maps_that_the_bench_saw_large(
    flying: dict[str, TriadBlock],
) -> None:
    before, after = flying["straight and level for an hour"], flying["self-calibrated"]
    np.testing.assert_array_equal(after.fitted_map, before.fitted_map)
    np.testing.assert_array_equal(after.circumference_stability, before.circumference_stability)
    power = [np.mean(triads.in_flight[:, 1:9] ** 2) for triads in (before, after)]
    assert power[1] < 0.05 * power[0]


def test_stale_maps_have_drifted_further(flying: dict[str, TriadBlock]) -> None:
    """After five years instead of half a year; the bench saw the same."""
    young, old = flying["self-calibrated"], flying["calibration five years old"]
    np.testing.assert_array_equal(old.fitted_map, young.fitted_map)
    fresh = flying["straight and level for an hour"]
    drifts = [
        np.mean((undo_start(each.in_flight[:, :TERMS], each.start_angle) - fitted) ** 2)
        for each in (fresh, old)
        for fitted in [each.fitted_map[:, :TERMS]]
    ]
    assert drifts[1] > 2 * drifts[0]


def test_drive_noise_hides_maps_from_both_tests(flying: dict[str, TriadBlock]) -> None:
    """Both show the noise of 100 s means; neither the map, of at most 0.01 deg/h or so."""
    noisy = flying["drive noise dominating"]
    walk = noisy.noise[:, 1]
    assert np.all((walk >= NOISY_DRIVES.smallest_walk) & (walk <= NOISY_DRIVES.largest_walk))
    expected = walk / np.sqrt(100.0)
    np.testing.assert_allclose(noisy.fixed_stability, expected, rtol=0.5, atol=0.01 * DEG_PER_H)
    ratio = noisy.circumference_stability / noisy.fixed_stability
    assert np.all((ratio > 0.5) & (ratio < 2))


def test_a_constant_taken_out_of_the_electronics_is_the_maps_mean(
    slow_fmu: GyroFmu, drawn: dict[int, DrawnTriad]
) -> None:
    """The sign of what conditions take out."""
    one = drawn[NUMBERS[0]]
    mean = AngleMap(mean=1 * DEG_PER_H)
    flights = tuple(replace(f, device=add_maps(f.device, mean, AngleMap())) for f in one.flights)
    before, after = (
        tabulate_triads(slow_fmu, [one]),
        tabulate_triads(slow_fmu, [replace(one, flights=flights)]),
    )
    np.testing.assert_allclose(
        after.in_flight[:, 0] - before.in_flight[:, 0], -1 * DEG_PER_H, rtol=1e-3
    )


def test_sample_is_of_the_judged_triads() -> None:
    for conditions in (0, 36, 40):
        chosen = replace(STUDY, conditions=conditions)
        numbers = [n for n in range(chosen.triads) if chosen.is_in_sample(n, chosen.conditions)]
        assert len(numbers) == conditions
        assert all(chosen.role_of(n) == TEST for n in numbers)
