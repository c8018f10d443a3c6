"""Records of standing vehicles with sensor errors, and statistics of alignments."""

import numpy as np
from scipy.spatial.transform import Rotation
from scipy.stats import chi2

from ins_eval.alignment.result import Alignment
from ins_eval.common import earth
from ins_eval.common.rotation import mat_from_euler
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.imu.sensor_error_model import AxisConstants, SensorErrorModel
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG
from pyhrg.records.imu.log import Increments

LATITUDE = 40 * DEG
POSITION = np.array([LATITUDE, 0.3, 100.0])
GRAVITY = float(earth.gravity(LATITUDE, 100.0))
MAT_NB = mat_from_euler(*map(np.array, (0.02, -0.03, 1.0)))


def make_still_record(seconds: float, interval: float, latitude: float = LATITUDE) -> Increments:
    """Ideal increments of a vehicle that stands still at MAT_NB, 100 m high."""
    rate = earth.RATE * np.array([np.cos(latitude), 0.0, -np.sin(latitude)])
    level = earth.horizontal_gravity(latitude, 100.0, (0.0, 0.0))
    force = -np.array([*level, earth.gravity(latitude, 100.0)])
    count = round(seconds / interval)
    return Increments(
        interval,
        np.tile(MAT_NB.T @ rate * interval, (count, 1)),
        np.tile(MAT_NB.T @ force * interval, (count, 1)),
    )


def make_swaying_record(
    seconds: float, interval: float, rng: np.random.Generator
) -> tuple[Increments, Array]:
    """Ideal increments of a vehicle that rolls and pitches by about a degree and shifts by about
    2 cm, at many frequencies from 0.1 to 0.5 Hz; `mat_nb` at the end."""
    time = _knots(seconds)

    def waves(sigma: float) -> Array:
        return _waves(time, sigma, (0.1, 0.5), rng)

    shift = [waves(0.02), waves(0.02), waves(0.01)]
    return _make_record(
        time, shift, [waves(1 * DEG), waves(0.5 * DEG), waves(0.2 * DEG)], seconds, interval
    )


def make_boarded_record(
    seconds: float, interval: float, rng: np.random.Generator
) -> tuple[Increments, Array]:
    """Likewise for a vehicle that people board: it tilts by 1.5 mrad and shifts by 1.5 mm eight
    times, and it trembles by 0.1 mm at 0.3 to 1 Hz."""
    time = _knots(seconds)
    moments = rng.uniform(0, seconds, 8)

    def steps(sigma: float, tremble: float) -> Array:
        s = np.clip((time - moments[:, None]) / 2.0, 0, 1)
        smooth = rng.normal(0, sigma, 8) @ (s**3 * (10 - 15 * s + 6 * s**2))
        return np.asarray(smooth + _waves(time, tremble, (0.3, 1.0), rng))

    shift = [steps(1.5e-3, 1e-4) for _ in range(3)]
    tilt = [steps(1.5e-3, 5e-5), steps(1.5e-3, 5e-5), steps(1e-4, 2e-5)]
    return _make_record(time, shift, tilt, seconds, interval)


def _knots(seconds: float) -> Array:
    return np.arange(-10.0, seconds + 10.0, 0.2)


def _waves(
    time: Array, sigma: float, band_hz: tuple[float, float], rng: np.random.Generator
) -> Array:
    frequency, phase = rng.uniform(*band_hz, 30), rng.uniform(0, 2 * np.pi, 30)
    waves = np.sin(2 * np.pi * np.outer(time, frequency) + phase)
    return np.asarray(sigma * np.sqrt(2 / 30) * waves.sum(axis=1))


def _make_record(
    time: Array, shift: list[Array], turn: list[Array], seconds: float, interval: float
) -> tuple[Increments, Array]:
    radius = earth.meridian_radius(LATITUDE)
    channels = [
        POSITION[0] + shift[0] / radius,
        POSITION[1] + shift[1] / radius,
        POSITION[2] + shift[2],
        0.02 + turn[0],
        -0.03 + turn[1],
        1.0 + turn[2],
    ]
    trajectory = Trajectory("standing", time, np.stack(channels, axis=-1))
    record = trajectory.increments(0.0, interval, round(seconds / interval))
    return record, trajectory.mat_nb(np.array(seconds))


def make_creeping_record(
    seconds: float, interval: float, rng: np.random.Generator
) -> tuple[Increments, Array]:
    """Likewise for a vehicle that tilts at a steady rate, by about 1 mrad in all."""
    time = _knots(seconds)
    still = np.zeros_like(time)
    roll, pitch = rng.normal(0, 1e-3, 2)[:, None] * time / seconds
    return _make_record(time, [still, still, still], [roll, pitch, still], seconds, interval)


def make_turned_record(seconds: float, interval: float, turn: float) -> tuple[Increments, Array]:
    """Likewise for a vehicle on a turntable that turns by `turn`, rad, in 20 s half-way."""
    time = _knots(seconds)
    s = np.clip((time - seconds / 2) / 20.0, 0, 1)
    still = np.zeros_like(time)
    yaw = turn * s**3 * (10 - 15 * s + 6 * s**2)
    return _make_record(time, [still, still, still], [still, still, yaw], seconds, interval)


def add_sensor_errors(
    ideal: Increments, errors: SensorErrors, rng: np.random.Generator
) -> Increments:
    """Add biases, white noise, bias instability and quantization to ideal increments."""
    gyros = SensorErrorModel(
        bias=AxisConstants(deviation=errors.gyro_bias),
        random_walk=errors.angle_random_walk,
        bias_instability=errors.gyro_bias_instability,
        quantization_step=errors.angle_quantization_step,
    )
    accelerometers = SensorErrorModel(
        bias=AxisConstants(deviation=errors.accelerometer_bias),
        random_walk=errors.velocity_random_walk,
        bias_instability=errors.accelerometer_bias_instability,
        quantization_step=errors.velocity_quantization_step,
    )
    return Increments(
        ideal.interval,
        gyros.measure(ideal.rotation, ideal.interval, rng),
        accelerometers.measure(ideal.velocity, ideal.interval, rng),
        ideal.start,
    )


def attitude_error(mat_nb: Array, truth: Array) -> Array:
    """(3,) about north, east, down, rad."""
    return np.asarray(Rotation.from_matrix(mat_nb @ truth.T).as_rotvec())


def normalised_square(result: Alignment, truth: Array) -> float:
    """Squared attitude error over its covariance; its mean should be 3."""
    error = attitude_error(result.mat_nb, truth)
    return float(error @ np.linalg.solve(result.covariance, error))


def chi_square_interval(count: int, freedom: int) -> tuple[float, float]:
    """99 % interval of the mean of `count` chi-squares of `freedom` degrees of freedom."""
    low, high = chi2.ppf([0.005, 0.995], count * freedom) / count
    return float(low), float(high)
