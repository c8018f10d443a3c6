"""The strong outside predictor against this project's linear error model: the same maps, two
implementations."""

import numpy as np

from ins_eval.mission_model.gyro_map import start_maps
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.missions import CASE_WARM_UP, SETTLING, STILL, WARM_UP, StudyMission
from ins_eval.mission_model.position_errors import compute_map_errors
from ins_eval.mission_model.signals import COUNT
from ins_eval.trajectories.catalogue import find_mission_file
from pyhrg.common.units import DEG_PER_H
from tests.ins_eval.study.challenge.examples import load_strong

TRIADS, RISE = 5, 10.0
INDEX = {
    "still_s": STILL,
    "settling_s": SETTLING,
    "case_warm_up_s": CASE_WARM_UP,
    "resonator_warm_up_s": WARM_UP,
}


def test_errors_of_maps_are_those_of_the_linear_model(
    short: StudyMission, weights: MissionWeights
) -> None:
    """Within 2 % after six minutes of the car: the ellipsoid and its gravity are left out there."""
    generator = np.random.default_rng(4)
    cool = generator.normal(0.0, 1.0, (TRIADS, 3, 18)) * [*[DEG_PER_H] * 9, *[1e-5] * 9]
    per_kelvin = 0.02 * cool[::-1]
    start = generator.uniform(0.0, np.pi, (TRIADS, 3))
    gyros = np.stack([np.full_like(start, 0.277), start, np.full_like(start, RISE)], axis=-1)
    mission = {"hours": short.hours}
    file = find_mission_file(short.source)
    found = load_strong().propagate(mission, INDEX, file, gyros, cool, per_kelvin)
    coefficients = np.zeros((TRIADS, COUNT, 3))
    coefficients[:, :18] = np.moveaxis(cool, 1, -1)
    coefficients[:, 18:36] = RISE * np.moveaxis(per_kelvin, 1, -1)
    expected = compute_map_errors(weights.maps, start_maps(coefficients, start))[:, -1]
    difference = np.linalg.norm(found - expected)
    assert difference < 0.02 * np.linalg.norm(expected)
