"""Six minutes of the car, against closed forms and the co-simulation."""

import math
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from ins_eval.mission_model.gyro_map import turn_weights
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.missions import plan_mission
from ins_eval.mission_model.position_errors import compute_linear_position_errors
from ins_eval.mission_model.weights_cache import load_mission_weights
from ins_eval.position.diagnosis import read_diagnosed_gyro
from ins_eval.position.position import PositionRequest, compute_mission_gaps
from ins_eval.position.triad_errors import (
    ALIGNMENT_PART,
    bound_residual_error,
    compute_error_parts,
    draw_power_on_angles,
    measure_gyro,
)
from ins_eval.study.gyros.true_maps import read_flight_coefficients
from ins_eval.study.scores.resampling import Estimate
from pyhrg.common.units import DEG_PER_H
from pyhrg.fmu import GyroFmu
from pyhrg.gap.findings.diagnosis import Gap
from tests.ins_eval.position.conftest import ANGLE, DIAGNOSIS, NOMINAL, RATE, WriteDiagnosis

REQUEST = PositionRequest(("car",), hours=0.1, triads=400, seed=3)
WALK = "angle random walk"


@pytest.fixture(scope="module")
def weights() -> MissionWeights:
    return load_mission_weights(plan_mission("car", 0.1))


def test_drive_frame_rotation_acts_as_its_bias(
    slow_fmu: GyroFmu, write_diagnosis: WriteDiagnosis, weights: MissionWeights
) -> None:
    """Bias -e/(2 k tau); no power-on angle matters."""
    turned = 1e-5
    gaps = compute_mission_gaps(
        slow_fmu, read_diagnosed_gyro(write_diagnosis(drive_frame_rotation=turned)), REQUEST
    )
    (car,) = gaps.missions
    bias = turned / (2 * NOMINAL.bryan_factor * NOMINAL.decay_time)
    expected = bias * np.hypot(*weights.gyros[:, :, 0].sum(axis=-1).T)
    assert car.distance == pytest.approx(expected, rel=5e-3)
    assert car.at_end.high - car.at_end.low < 0.02 * car.at_end.value


def test_interval_over_drawn_angles_holds_the_rms_over_all(
    slow_fmu: GyroFmu, write_diagnosis: WriteDiagnosis, weights: MissionWeights
) -> None:
    diagnosis = read_diagnosed_gyro(write_diagnosis(damping_anisotropy=4e-8))
    (car,) = compute_mission_gaps(slow_fmu, diagnosis, REQUEST).missions
    before, after = (
        read_flight_coefficients(slow_fmu, device, 10.0)
        for device in (diagnosis.nominal, diagnosis.identified)
    )
    maps = np.repeat((after - before)[None, :18, None], 3, axis=2)
    assert car.at_end.low < rms_over_all_angles(weights.gyros[-1:], maps[0]) < car.at_end.high


def rms_over_all_angles(weights: NDArray[np.float64], maps: NDArray[np.float64]) -> float:
    """Of triads whose gyros' angles are independent: means over angles add as vectors, variances
    add as squares. Sixteen angles average the squares of harmonics up to the eighth exactly."""
    angles = np.repeat(np.pi * np.arange(16)[:, None] / 16, 3, axis=1)
    errors = np.einsum("nkica,ca->nia", turn_weights(weights, angles), maps)
    steady = errors.mean(axis=0)
    power = np.mean((errors - steady) ** 2, axis=0).sum() + np.sum(steady.sum(axis=-1) ** 2)
    return float(np.sqrt(power))


@pytest.mark.parametrize("anisotropy", [4e-8, 1e-6])
def test_linear_model_agrees_with_cosimulation_to_a_hundredth(
    anisotropy: float, slow_fmu: GyroFmu, write_diagnosis: WriteDiagnosis
) -> None:
    """The larger anisotropy makes a bias of 0.2 deg/h."""
    gaps = compute_mission_gaps(
        slow_fmu, read_diagnosed_gyro(write_diagnosis(damping_anisotropy=anisotropy)), REQUEST
    )
    assert gaps.cosimulation is not None
    assert gaps.cosimulation.share < 0.01


def test_equal_devices_are_no_distance_apart(
    slow_fmu: GyroFmu, write_diagnosis: WriteDiagnosis
) -> None:
    gaps = compute_mission_gaps(slow_fmu, read_diagnosed_gyro(write_diagnosis()), REQUEST)
    (car,) = gaps.missions
    assert car.distance.max() == 0.0
    assert (car.at_end.low, car.at_end.high) == (0.0, 0.0)
    assert gaps.cosimulation is None


def test_identified_noise_changes_the_budget_alone(
    slow_fmu: GyroFmu, write_diagnosis: WriteDiagnosis
) -> None:
    diagnosis = read_diagnosed_gyro(
        write_diagnosis(angle_random_walk=3 * NOMINAL.angle_random_walk)
    )
    (car,) = compute_mission_gaps(slow_fmu, diagnosis, REQUEST).missions
    assert not diagnosis.is_changed
    assert car.distance.max() == 0.0
    assert car.identified_budget[WALK] == pytest.approx(3 * car.nominal_budget[WALK])


def test_same_seed_same_figures(slow_fmu: GyroFmu, write_diagnosis: WriteDiagnosis) -> None:
    def at_end(request: PositionRequest) -> Estimate:
        return compute_mission_gaps(slow_fmu, diagnosis, request).missions[0].at_end

    diagnosis = read_diagnosed_gyro(write_diagnosis(angle_random_walk=0.0, damping_axis=0.5))
    few = replace(REQUEST, triads=20)
    assert at_end(few) == at_end(few)
    assert at_end(few) != at_end(replace(few, seed=4))
    assert draw_power_on_angles(3, 1).max() < math.pi


def test_residual_bound_holds_for_steady_biases_of_any_sign(weights: MissionWeights) -> None:
    """No steady bias exceeds the bound for steady ones, which is below that for any course."""
    rate = 1e-3 * DEG_PER_H
    bound = bound_residual_error(weights, rate)
    signs = np.random.default_rng(1).choice([-1.0, 1.0], (50, 3))
    flown = np.hypot(*(rate * weights.gyros[-1, :, 0] @ signs.T))
    assert flown.max() == pytest.approx(bound.steady)
    assert bound.steady < bound.any_course


def test_residual_excess_is_above_the_lower_end_of_the_noise_floor(
    write_diagnosis: WriteDiagnosis,
) -> None:
    residual = read_diagnosed_gyro(write_diagnosis()).residual
    assert residual is not None
    assert residual.excess == pytest.approx(math.sqrt(8e-6) * DEG_PER_H)
    quiet = replace(RATE, after=0.5e-3)
    residual = read_diagnosed_gyro(
        write_diagnosis(replace(DIAGNOSIS, gap=Gap(ANGLE, RATE, ANGLE, quiet, None, None)))
    ).residual
    assert residual is not None
    assert residual.excess == 0.0
    assert (
        read_diagnosed_gyro(
            write_diagnosis(replace(DIAGNOSIS, gap=Gap(ANGLE, RATE, None, None, None, None)))
        ).residual
        is None
    )


def test_error_parts_add_up_to_those_of_the_study(
    slow_fmu: GyroFmu, weights: MissionWeights
) -> None:
    """Same triads without noise; at 0.2 deg/h the alignment has a second-order error."""
    device = replace(NOMINAL, damping_anisotropy=1e-6, bias_per_acceleration=1e-9)
    in_flight = measure_gyro(slow_fmu, device).compute_flight_coefficients(
        draw_power_on_angles(5, 1)
    )
    triads: Any = SimpleNamespace(
        in_flight=in_flight[0],
        turning=in_flight[1],
        accelerometers=np.zeros((5, 3)),
        mounting=np.zeros((5, 2, 3)),
        noise=np.zeros((5, 4, 3)),
        seeds=np.zeros((5, 2), dtype=np.uint64),
    )
    parts = compute_error_parts(weights, in_flight)
    assert sum(parts.values()) == pytest.approx(
        compute_linear_position_errors(triads, weights, 0).error
    )
    assert np.abs(parts[ALIGNMENT_PART]).max() > 1e-6
