"""What is known of a triad's gyros before a drive."""

import numpy as np

from ins_eval.aided.kalman.sensors import SensorStates
from ins_eval.error_model.effects import accelerometer_bias, gyro_bias, misalignment
from ins_eval.flights.assumed_errors import ASSUMED_FLICKER_TIMES
from ins_eval.imu.sensor_error_model import TYPICAL_ACCELEROMETERS
from ins_eval.mission_model.bench_map import BenchMap
from ins_eval.mission_model.gyro_map import TERMS
from ins_eval.mission_model.signals import (
    STEADY,
    WARMING,
    list_signal_effects,
    slice_coefficients,
)
from ins_eval.study.gyros.drawn_triad import (
    AXES,
    DrawnTriad,
    TriadDistribution,
    draw_gyros,
)
from ins_eval.study.gyros.true_maps import read_flight_coefficients
from ins_eval.study.gyros.witness_prior import make_study_drift
from ins_eval.study.witness.estimated_map import respond
from pyhrg.common.arrays import Array
from pyhrg.fmu import GyroFmu
from pyhrg.noise.coefficients import compute_process_variance
from pyhrg.witness.responses import measure_responses

LEARNING_SEED = 7
KNOWN = slice_coefficients(slice(STEADY.start, WARMING.stop))
"""Coefficients that are states: the map at power-on and by warmth."""


def learn_deviations(slow: GyroFmu, distribution: TriadDistribution, triads: int) -> Array:
    """(k,) rms over gyros of each of the coefficients `KNOWN` in flight."""
    found = [
        read_flight_coefficients(slow, gyro.flight.device, gyro.flight.rise)
        for number in range(triads)
        for gyro in draw_gyros(slow, distribution, np.random.default_rng([LEARNING_SEED, number]))
    ]
    return np.sqrt(np.mean(np.square(found), axis=0))[KNOWN]


def make_bench_maps(
    slow: GyroFmu, distribution: TriadDistribution, triad: DrawnTriad
) -> dict[int, BenchMap]:
    """Maps of the study's bench by axis, with the scatter over power-ons and the drift since."""
    maps = {}
    for axis, (device, measured) in enumerate(zip(triad.calibrated, triad.measured, strict=True)):
        drifted = make_study_drift(device, distribution.drift)
        response = respond(measure_responses(slow, device), 0.0)[: 2 * TERMS]
        second = drifted.covariance + np.outer(drifted.mean, drifted.mean)
        variance = np.diag(response @ second @ response.T) + measured.map_variance
        maps[axis] = BenchMap(measured.fitted_map, variance)
    return maps


def list_states(
    distribution: TriadDistribution, triad: DrawnTriad, deviations: Array
) -> SensorStates:
    """What is known of a triad before its flight: the population and its noise coefficients."""
    devices = [flown.device for flown in triad.flights]
    flicker = [np.sqrt(compute_process_variance(d.bias_instability)) for d in devices]
    sized = [
        *zip(list_signal_effects()[KNOWN], deviations, strict=True),
        *((effect, distribution.mounting) for effect in misalignment("gyro")),
        *((gyro_bias(time), flicker) for time in ASSUMED_FLICKER_TIMES),
        (accelerometer_bias(), distribution.accelerometer_bias),
    ]
    sizes = np.array([np.broadcast_to(size, AXES) for _, size in sized])
    walks = np.zeros_like(sizes)
    walks[0] = [device.rate_random_walk for device in devices]
    noise = [*(d.angle_random_walk for d in devices), *[TYPICAL_ACCELEROMETERS.random_walk] * AXES]
    return SensorStates(tuple(effect for effect, _ in sized), sizes, walks, np.array(noise))
