"""Drives whose sensors' errors are drawn from the filter's own prior: is its covariance right?"""

from collections.abc import Iterator

import numpy as np
from scipy.signal import lfilter

from ins_eval.aided.correction import correct_increments
from ins_eval.aided.fixes import make_position_fixes
from ins_eval.aided.kalman.drive import measure_turn, sample_drive
from ins_eval.aided.kalman.forward import run_filter
from ins_eval.aided.kalman.sensors import SensorStates
from ins_eval.aided.kalman.start import align_in_motion
from ins_eval.common.state import State, Track, displace, track_error
from ins_eval.error_model.dynamics import HEIGHT_INTEGRAL
from ins_eval.error_model.effects import ANGULAR_GAIN
from ins_eval.error_model.linear_model import AXES
from ins_eval.flights.assumed_errors import assume_errors
from ins_eval.flights.sources import load_imu_at_rate
from ins_eval.trajectories.catalogue import load_trajectory
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG_PER_H, HOUR
from pyhrg.records.imu.log import Increments

IMU, RATE_HZ, FIX_SIGMA = "typical-hrg", 50, 2.0
RATE_WALK = 0.003 * DEG_PER_H / np.sqrt(HOUR)
"""Rate random walk of the gyros, rad/s/sqrt(s), which the IMU lacks."""


def filter_drawn(mission: str, hours: float, count: int) -> Iterator[tuple[float, int]]:
    """Normalised squared error of all states at the end of a drive, and its degrees of freedom."""
    imu = load_imu_at_rate(IMU, RATE_HZ)
    truth = load_trajectory(mission, hours * HOUR + 10)
    increments = truth.increments(0.0, imu.interval, round(hours * HOUR / imu.interval))
    turned = measure_turn(increments, None)
    for seed in range(count):
        generator = np.random.default_rng(seed)
        angle = generator.uniform(0, np.pi, AXES)
        assumed = assume_errors(imu)
        walks = np.zeros_like(assumed.deviations)
        walks[[effect.name == "gyro bias" for effect in assumed.effects]] = RATE_WALK
        density = np.repeat(
            [assumed.noise.angle_random_walk, assumed.noise.velocity_random_walk], AXES
        )
        states = SensorStates(assumed.effects, assumed.deviations, walks, density)
        begun = turned - angle / ANGULAR_GAIN
        measured, true = draw_record(increments, begun, states, generator)
        drive = sample_drive(measured, begun)
        time = np.arange(0.5, hours * HOUR)
        errors = generator.normal(0.0, FIX_SIGMA, (len(time), 3))
        fixes = make_position_fixes(time, displace(truth.position(time), errors), FIX_SIGMA)
        start = align_in_motion(drive, fixes, states, np.zeros(3))
        found = run_filter(drive, fixes, states, start, np.zeros(3))
        at = truth.track(drive.increments.start + np.array([drive.steps * drive.step]))
        difference = track_error(make_track(found.state, at.time), at)
        own = [difference.position[0], difference.velocity[0], difference.attitude[0], [0.0]]
        # what feedback left of the navigator's errors is true less estimated
        error = np.concatenate([*own, true - found.coefficients])
        kept = np.diag(found.covariance) > 0
        kept[HEIGHT_INTEGRAL] = False
        square = error[kept] @ np.linalg.solve(found.covariance[np.ix_(kept, kept)], error[kept])
        yield float(square), int(kept.sum())


def make_track(state: State, time: Array) -> Track:
    return Track(time, state.position[None], state.velocity[None], state.mat_nb[None])


def draw_record(
    increments: Increments, turned: Array, states: SensorStates, generator: np.random.Generator
) -> tuple[Increments, Array]:
    """Increments with drawn errors, and the coefficients (c,) at the end."""
    first = generator.normal(0.0, np.ravel(states.deviations))
    wanders = np.repeat([np.isfinite(e.correlation_time) for e in states.effects], AXES)
    constant = np.where(wanders, 0.0, first)
    record = correct_increments(increments, turned, states, -constant, np.inf)
    count, interval = len(increments), increments.interval
    persistence = states.list_persistence(interval)
    driving = np.sqrt(states.list_driving_variance(interval))
    rotation, velocity = record.rotation.copy(), record.velocity.copy()
    last = constant.copy()
    for number in np.flatnonzero(driving > 0):
        effect, axis = states.effects[number // AXES], number % AXES
        begin = first[number] if wanders[number] else 0.0
        steps = np.append(begin, driving[number] * generator.standard_normal(count))
        walk = lfilter([1.0], [1.0, -persistence[number]], steps)
        added = rotation if effect.sensor == "gyro" else velocity
        added[:, axis] += interval * walk[1:]
        last[number] += walk[-1]
    white = generator.standard_normal((count, 2 * AXES)) * states.noise * np.sqrt(interval)
    rotation, velocity = rotation + white[:, :AXES], velocity + white[:, AXES:]
    return Increments(interval, rotation, velocity, increments.start), last
