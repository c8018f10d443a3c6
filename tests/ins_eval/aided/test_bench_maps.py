"""The bench's maps before a drive: taken where they are of these gyros, refused where not."""

import json
from pathlib import Path

import numpy as np
import pytest
from scipy.stats import chi2

import ins_eval
from ins_eval.aided.bench_maps import (
    TOGETHER,
    choose_bench_maps,
    take_bench_maps,
)
from ins_eval.aided.kalman.backward import Adjoint, smooth
from ins_eval.aided.kalman.sensors import SensorStates
from ins_eval.error_model.effects import gyro_bias
from ins_eval.mission_model.bench_map import read_bench_map
from ins_eval.mission_model.gyro_map import TERMS
from pyhrg.common.errors import HrgError
from pyhrg.common.units import DEG_PER_H, PPM
from tests.ins_eval.aided.drives import IMU, LEVER_ARM, DrivenFiles

DRIFT_DEG_H, DRIFT_PPM = 1e-3, 1.0
DRIFT = DRIFT_DEG_H * DEG_PER_H, DRIFT_PPM * PPM
FOURTH = [9 * axis + term for axis in range(3) for term in (3, 4)]
"""Places of the fourth harmonics among the terms of three bias maps."""


@pytest.fixture(scope="module")
def adjoint(aided: ins_eval.AidedDrive) -> Adjoint:
    """Of the drive without the bench's maps."""
    first, second = aided.filtered.segments[:2]
    step = (second.time - first.time) / len(second.steps)
    return smooth(aided.filtered, aided.sensors, step)[1]


@pytest.fixture(scope="module")
def benched(driven: DrivenFiles) -> ins_eval.AidedDrive:
    return ins_eval.aid(
        driven.log,
        driven.fixes,
        errors_of=IMU,
        lever_arm_m=LEVER_ARM,
        hold_out_h=0.2,
        bench=driven.bench,
        bench_drift=(DRIFT_DEG_H, DRIFT_PPM),
    )


def test_maps_of_the_bench_are_true_within_their_sigma(driven: DrivenFiles) -> None:
    square, degrees = 0.0, 0
    for path, true in zip(driven.bench, driven.maps, strict=True):
        found = read_bench_map(path, (0.0, 0.0))
        measured = np.isfinite(found.variances)
        assert not measured[0]
        # of three runs: Student's intervals are wider than normal ones of the same sigma
        square += np.sum((found.values - true)[measured] ** 2 / found.variances[measured])
        degrees += measured.sum()
    assert degrees == 3 * 13
    assert chi2.ppf(1e-4, degrees) < square < chi2.ppf(1 - 1e-3, degrees)


def test_maps_of_the_bench_narrow_those_of_the_drive(
    driven: DrivenFiles, aided: ins_eval.AidedDrive, benched: ins_eval.AidedDrive
) -> None:
    assert benched.bench_used == {0, 1, 2}
    assert "bench's maps in the prior: forward, right, down" in benched.summary
    error = (benched.bias_map.coefficients - driven.maps[:, :TERMS]).ravel()[FOURTH]
    covariance = benched.bias_map.joint[np.ix_(FOURTH, FOURTH)]
    assert error @ np.linalg.solve(covariance, error) < chi2.ppf(1 - 1e-3, len(FOURTH))
    before = np.sqrt(np.trace(aided.bias_map.joint[np.ix_(FOURTH, FOURTH)]))
    assert np.sqrt(np.trace(covariance)) < before / 20
    assert benched.hold_out.corrected[-1] < aided.hold_out.corrected[-1]


@pytest.mark.parametrize(
    ("order", "kept", "contradicting"),
    [
        ((0, 1, 2), {0, 1, 2}, []),
        ((1, 0, 2), {2}, ["forward", "right"]),
        ((2, 1, 0), {1}, ["forward", "down"]),
        # the drive sees the down gyro's map beside another's alone
        ((0, 2, 1), set(), ["right", TOGETHER]),
    ],
)
def test_a_map_of_another_gyro_is_noticed(
    driven: DrivenFiles,
    aided: ins_eval.AidedDrive,
    adjoint: Adjoint,
    order: tuple[int, ...],
    kept: set[int],
    contradicting: list[str],
) -> None:
    maps = {axis: read_bench_map(driven.bench[k], DRIFT) for axis, k in enumerate(order)}
    used, tests = choose_bench_maps(aided.sensors, maps, adjoint)
    assert set(used) == kept
    assert [each.gyro for each in tests if each.contradicts] == contradicting


def test_a_drive_without_maps_is_tested_by_none(aided: ins_eval.AidedDrive) -> None:
    assert (aided.bench_used, aided.bench_tests) == (frozenset(), ())


@pytest.mark.parametrize(
    ("findings", "message"),
    [
        ({}, "findings.keys: found 'none', expected those of the test calibration"),
        ({"bias_stability_deg_per_h": {}}, "found 'bias_stability_deg_per_h', expected those of"),
        ({"bias_map_cos4_deg_per_h": {"value": 1}}, "interval_95: found .*, expected 2 numbers"),
        (
            {"bias_map_cos4_deg_per_h": {"value": 1, "interval_95": [None, None]}},
            r"cos4_deg_per_h.interval_95\[0\]: found None, expected a number",
        ),
        (
            {"bias_map_cos4_deg_per_h": {"value": 1, "interval_95": [2, 1]}},
            r"interval_95: found \[2.0, 1.0\], expected \[low, high\]",
        ),
    ],
)
def test_bad_results_are_refused(tmp_path: Path, findings: object, message: str) -> None:
    path = tmp_path / "result.json"
    path.write_text(json.dumps({"findings": findings}))
    with pytest.raises(HrgError, match=message):
        read_bench_map(path, DRIFT)


def test_a_map_is_refused_where_the_imu_has_a_mean_alone(driven: DrivenFiles) -> None:
    states = SensorStates((gyro_bias(),), np.full((1, 3), 1e-8), np.zeros((1, 3)), np.zeros(6))
    with pytest.raises(HrgError, match="bench: right: found no term that the errors of the IMU"):
        take_bench_maps(states, {1: read_bench_map(driven.bench[1], DRIFT)})


def test_maps_without_their_drift_are_refused(driven: DrivenFiles) -> None:
    for bench, drift in ((driven.bench, None), (driven.bench[:2], (0.0, 0.0)), ((), (0.0, 0.0))):
        with pytest.raises(
            HrgError, match=r"bench: found .*, expected 3 results and a bench_drift"
        ):
            ins_eval.aid(driven.log, driven.fixes, bench=bench, bench_drift=drift)
