"""Six minutes of the car, against closed forms and the co-simulation."""

import math
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from ins_eval.mission_model.flown import flown
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.missions import study_mission
from ins_eval.mission_model.weights_cache import kept_weights
from ins_eval.position.diagnosis import read
from ins_eval.position.errors import ALIGNMENT, errors, power_on_angles
from ins_eval.position.gyro import gyro
from ins_eval.position.leftover import leftover
from ins_eval.position.position import Asked, position
from ins_eval.study.gyros.true_maps import coefficients
from ins_eval.study.predictors.rms_over_angles import triad_rms_over_angles
from ins_eval.study.scores.resampling import Estimate
from pyhrg.common.units import DEG_PER_H
from pyhrg.fmu import GyroFmu
from pyhrg.gap.findings.diagnosis import Gap
from tests.ins_eval.position.conftest import ANGLE, BELIEVED, FOUND, RATE, Written

ASKED = Asked(("car",), hours=0.1, triads=400, seed=3)
WALK = "angle random walk"


@pytest.fixture(scope="module")
def weights() -> MissionWeights:
    return kept_weights(study_mission("car", 0.1))


def test_a_turned_force_frame_carries_the_position_as_a_bias_does(
    slow_fmu: GyroFmu, written: Written, weights: MissionWeights
) -> None:
    """Bias -e/(2 k tau); no power-on angle matters."""
    turned = 1e-5
    found = position(slow_fmu, read(written(drive_frame_rotation=turned)), ASKED)
    (car,) = found.missions
    bias = turned / (2 * BELIEVED.bryan_factor * BELIEVED.decay_time)
    expected = bias * np.hypot(*weights.gyros[:, :, 0].sum(axis=-1).T)
    assert car.missed == pytest.approx(expected, rel=5e-3)
    assert car.at_end.high - car.at_end.low < 0.02 * car.at_end.value


def test_rms_over_drawn_angles_is_that_over_all(
    slow_fmu: GyroFmu, written: Written, weights: MissionWeights
) -> None:
    diagnosis = read(written(damping_anisotropy=4e-8))
    (car,) = position(slow_fmu, diagnosis, ASKED).missions
    before, after = (
        coefficients(slow_fmu, device, 10.0) for device in (diagnosis.before, diagnosis.after)
    )
    maps = np.repeat((after - before)[None, :18, None], 3, axis=2)
    assert car.at_end.low < triad_rms_over_angles(weights.gyros, maps)[0, -1] < car.at_end.high


@pytest.mark.parametrize("anisotropy", [4e-8, 1e-6])
def test_the_linear_model_misses_what_is_flown_by_less_than_a_hundredth(
    anisotropy: float, slow_fmu: GyroFmu, written: Written
) -> None:
    """Of 0.2 deg/h as well."""
    found = position(slow_fmu, read(written(damping_anisotropy=anisotropy)), ASKED)
    assert found.sample is not None
    assert found.sample.share < 0.01


def test_the_same_gyro_misses_nothing(slow_fmu: GyroFmu, written: Written) -> None:
    found = position(slow_fmu, read(written()), ASKED)
    (car,) = found.missions
    assert car.missed.max() == 0.0
    assert (car.at_end.low, car.at_end.high) == (0.0, 0.0)
    assert found.sample is None


def test_noise_that_was_found_misses_nothing_but_widens_the_budget(
    slow_fmu: GyroFmu, written: Written
) -> None:
    diagnosis = read(written(angle_random_walk=3 * BELIEVED.angle_random_walk))
    (car,) = position(slow_fmu, diagnosis, ASKED).missions
    assert not diagnosis.moved
    assert car.missed.max() == 0.0
    assert car.after[WALK] == pytest.approx(3 * car.before[WALK])


def test_same_seed_same_figures(slow_fmu: GyroFmu, written: Written) -> None:
    def at_end(asked: Asked) -> Estimate:
        return position(slow_fmu, diagnosis, asked).missions[0].at_end

    diagnosis = read(written(angle_random_walk=0.0, damping_axis=0.5))
    few = replace(ASKED, triads=20)
    assert at_end(few) == at_end(few)
    assert at_end(few) != at_end(replace(few, seed=4))
    assert power_on_angles(3, 1).max() < math.pi


def test_what_is_left_is_bounded_by_rates_of_any_course(weights: MissionWeights) -> None:
    """Of steady biases none carries further than `steady`, nor that further than `most`."""
    rate = 1e-3 * DEG_PER_H
    found = leftover(weights, rate)
    signs = np.random.default_rng(1).choice([-1.0, 1.0], (50, 3))
    flown = np.hypot(*(rate * weights.gyros[-1, :, 0] @ signs.T))
    assert flown.max() == pytest.approx(found.steady)
    assert found.steady < found.most


def test_rest_beyond_the_least_that_noise_may_leave(written: Written) -> None:
    rest = read(written()).rest
    assert rest is not None
    assert rest.beyond_noise == pytest.approx(math.sqrt(8e-6) * DEG_PER_H)
    quiet = replace(RATE, after=0.5e-3)
    rest = read(written(replace(FOUND, gap=Gap(ANGLE, RATE, ANGLE, quiet, None, None)))).rest
    assert rest is not None
    assert rest.beyond_noise == 0.0
    assert read(written(replace(FOUND, gap=Gap(ANGLE, RATE, None, None, None, None)))).rest is None


def test_parts_are_those_of_the_study(slow_fmu: GyroFmu, weights: MissionWeights) -> None:
    """Of the same triads without noise; of 0.2 deg/h, whose alignment is not of first order."""
    device = replace(BELIEVED, damping_anisotropy=1e-6, bias_per_acceleration=1e-9)
    in_flight = gyro(slow_fmu, device).in_flight(power_on_angles(5, 1))
    triads: Any = SimpleNamespace(
        in_flight=in_flight[0],
        turning=in_flight[1],
        accelerometers=np.zeros((5, 3)),
        noise=np.zeros((5, 4, 3)),
        seeds=np.zeros((5, 2), dtype=np.uint64),
    )
    parts = errors(weights, in_flight)
    assert sum(parts.values()) == pytest.approx(flown(triads, weights, 0).error)
    assert np.abs(parts[ALIGNMENT]).max() > 1e-6
