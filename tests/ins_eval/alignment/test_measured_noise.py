"""Noise that was put in is found again, on a vehicle that sways."""

from dataclasses import replace

import numpy as np

from ins_eval.alignment.measured_noise import PRIOR_SIGMA, measure_noise
from ins_eval.common.sensor_errors import SensorErrors
from pyhrg.common.units import DEG_PER_SQRT_H
from tests.ins_eval.alignment.cases import POSITION, add_sensor_errors, make_swaying_record

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


def test_a_short_record_tells_the_accelerometers_noise_and_the_prior_the_rest() -> None:
    """Two minutes, seed 6, priors ten times too large and too small: the velocity random walk moves
    to the truth; the angle random walk, which two minutes hardly show, keeps a wide sigma."""
    rng = np.random.default_rng(6)
    ideal, _ = make_swaying_record(120.0, 0.002, rng)
    record = add_sensor_errors(ideal, replace(TRUE, velocity_random_walk=3e-3), rng)
    for factor in (0.1, 10.0):
        estimate = measure_noise(
            record, POSITION, replace(TRUE, velocity_random_walk=3e-3 * factor)
        )
        error = np.log(estimate.errors.velocity_random_walk / 3e-3)
        assert abs(error) < 3 * estimate.relative_sigma[1]
        assert abs(error) < 0.5 * np.log(10)
        assert 0.3 < estimate.relative_sigma[0] < 1.1 * PRIOR_SIGMA
