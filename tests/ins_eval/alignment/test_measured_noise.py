"""Noise that was put in is found again, on a vehicle that sways."""

from dataclasses import replace

import numpy as np

from ins_eval.common.sensor_errors import SensorErrors
from pyhrg.common.units import DEG_PER_SQRT_H
from tests.ins_eval.alignment.cases import POSITION, add_sensor_errors, make_swaying_record
from tests.ins_eval.alignment.measured_noise import measure_noise

TRUE = SensorErrors(angle_random_walk=0.001 * DEG_PER_SQRT_H, velocity_random_walk=3e-4)


def test_walks_are_found_within_their_sigma() -> None:
    """Half an hour, seed 5; three sigma."""
    rng = np.random.default_rng(5)
    ideal, _ = make_swaying_record(1800.0, 0.2, rng)
    blank = replace(TRUE, angle_random_walk=0.0, velocity_random_walk=0.0)
    estimate = measure_noise(add_sensor_errors(ideal, TRUE, rng), POSITION, blank)
    walks = np.array([estimate.errors.angle_random_walk, estimate.errors.velocity_random_walk])
    truth = np.array([TRUE.angle_random_walk, TRUE.velocity_random_walk])
    assert np.all(np.abs(np.log(walks / truth)) < 3 * estimate.relative_sigma[:2])
    assert estimate.relative_sigma[0] < 0.5
