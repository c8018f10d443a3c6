"""One triad whose channels are read in a short flight on the FMU, and the errors of its bench."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2

from ins_eval.mission_model.missions import plan_mission
from ins_eval.mission_model.weights_cache import load_mission_weights
from ins_eval.study.cosimulated import MissionTruth, cosimulate, sample_truth, seed_noise
from ins_eval.study.gyros.bench_plan import BenchPlan
from ins_eval.study.gyros.drawn_triad import (
    DrawnTriad,
    TriadDistribution,
    draw_triad,
    make_triad_seed,
)
from ins_eval.study.gyros.population import RAW
from ins_eval.study.predictors.prediction_columns import select_time
from ins_eval.study.witness.believed import BelievedGyro
from ins_eval.study.witness.block import TESTS, believe_triad, witness_triads
from ins_eval.study.witness.flight import fly_with_channels
from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.common.arrays import Array
from pyhrg.fmu import GyroFmu

HOURS = 0.1
SHORT = BenchPlan(runs=2, fixed_runs=2, positions=16, fixed_segments=2, periods=1)
DISTRIBUTION = TriadDistribution(population=RAW, method="map", bench=SHORT)


@pytest.fixture(scope="module")
def truth() -> MissionTruth:
    return sample_truth(plan_mission("car", HOURS))


@pytest.fixture(scope="module")
def triad(slow_fmu: GyroFmu) -> DrawnTriad:
    return draw_triad(slow_fmu, DISTRIBUTION, make_triad_seed(7, 0))


@pytest.fixture(scope="module")
def believed(slow_fmu: GyroFmu, triad: DrawnTriad) -> list[BelievedGyro]:
    return believe_triad(slow_fmu, DISTRIBUTION, triad)


@pytest.fixture(scope="module")
def found(
    fmu: GyroFmu,
    slow_fmu: GyroFmu,
    truth: MissionTruth,
    triad: DrawnTriad,
    believed: list[BelievedGyro],
) -> dict[str, Array]:
    """Results of a block of two triads of which the second is witnessed."""
    weights = select_time(load_mission_weights(plan_mission("car", HOURS)), -1)
    return witness_triads((fmu, slow_fmu), truth, weights, 3, {1: (triad, believed)}, range(2))


def test_a_triad_that_is_not_witnessed_has_no_figures(found: dict[str, Array]) -> None:
    for values in found.values():
        assert values.shape[:2] == (2, len(TESTS))
        assert np.isnan(values[0]).all()


def test_its_flight_is_the_studys(
    fmu: GyroFmu, truth: MissionTruth, triad: DrawnTriad, found: dict[str, Array]
) -> None:
    """The channels are read beside the flight that the study co-simulates, to 1 mm."""
    flown = cosimulate(fmu, truth, triad, seed_noise(triad, 3))[-1]
    assert found["flown"][1, 0] == pytest.approx(flown, abs=1e-3)


def test_a_correction_takes_out_what_is_predicted(found: dict[str, Array]) -> None:
    """The navigator with the estimated maps taken out differs by the error that the linear model
    makes of them, to a twentieth."""
    left = found["flown"][1, 0] - found["by_channels"][1, 0]
    assert left == pytest.approx(found["estimated"][1, 0], abs=0.05 * np.linalg.norm(left))
    assert np.isnan(found["by_self_test"][1, 0]).all()
    assert np.isfinite(found["by_self_test"][1, 1]).all()


def test_estimates_are_consistent_with_an_error_of_the_bench(found: dict[str, Array]) -> None:
    """99.8 % band of chi-square, of each kind of start."""
    for test in range(len(TESTS)):
        total, degrees = (found[name][1, test].sum() for name in ("squares", "degrees"))
        assert chi2.ppf(0.001, degrees) < total < chi2.ppf(0.999, degrees)
    assert found["p_values"][1].min() > 1e-3


def test_an_error_of_the_bench_is_drawn(triad: DrawnTriad, believed: list[BelievedGyro]) -> None:
    """Between noise and the drift of half a year, 1.4 %; what no bench measures is taken for
    zero."""
    sizes = np.array([device.damping_anisotropy for device in triad.calibrated])
    errors = np.array([each.device.damping_anisotropy for each in believed]) - sizes
    assert np.all((np.abs(errors) > 0) & (np.abs(errors) < 0.014 * sizes))
    assert all(each.device.bias_per_acceleration == 0 for each in believed)


def test_an_effect_outside_the_model_flies_and_is_recorded(
    fmu: GyroFmu, truth: MissionTruth, triad: DrawnTriad
) -> None:
    """A rate turns the output; what a form adds to a log stands in the channels."""
    rate, decay = 1e-6, 1e-7
    effect = Disturbance(
        rate=lambda course, start: np.array([[rate]]),
        shown=lambda log: replace(log, amplitude_force=log.amplitude_force + decay),
    )
    noise = [seed_noise(triad, 3)]
    as_built, disturbed = (
        fly_with_channels(fmu, truth, [triad], noise, disturbances=effects)[0]
        for effects in ([], [[effect] * 3])
    )
    turned = (disturbed.measured.rotation - as_built.measured.rotation).sum(axis=0)
    duration = truth.increments.interval * len(truth.increments)
    assert turned == pytest.approx(np.full(3, rate * duration), rel=1e-3)
    added = disturbed.witnesses[0].forces[:, 0] - as_built.witnesses[0].forces[:, 0]
    assert np.median(added) == pytest.approx(decay, rel=1e-2)
