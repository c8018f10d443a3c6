"""A recorded ring-laser IMU in a standing vehicle that people move in."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.stats import chi2

from ins_eval.alignment.align import align
from ins_eval.alignment.analytic import level_and_gyrocompass
from ins_eval.alignment.inertial_frame import fit_inertial_frame
from ins_eval.alignment.measured_noise import MeasuredNoise, measure_noise
from ins_eval.common.rotation import euler_from_mat
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.common.state import State
from ins_eval.flights import sources
from ins_eval.flights.align_report import plot_alignment
from ins_eval.navigation.height import Clamped
from ins_eval.navigation.strapdown import navigate
from pyhrg.common.errors import HrgError
from pyhrg.common.units import ARCSEC, DEG, DEG_PER_H, DEG_PER_SQRT_H, MICRO_G
from pyhrg.records.imu.log import Increments, RecordedImu
from tests.recordings import find_recording

STATED = SensorErrors(
    gyro_bias=0.01 * DEG_PER_H,
    accelerometer_bias=50 * MICRO_G,
    angle_quantization_step=0.1 * ARCSEC,
    velocity_quantization_step=125 * MICRO_G,
)

"""Biases of the class; one count of the record."""
SPAN = 300.0


@pytest.fixture(scope="module")
def log() -> RecordedImu:
    return sources.read_record(find_recording("lasergyro.imu.gz"))


@pytest.fixture(scope="module")
def noise(log: RecordedImu) -> MeasuredNoise:
    return measure_noise(log.increments, log.position, STATED)


def spans(record: Increments) -> list[Increments]:
    each = round(SPAN / record.interval)
    return [record.between(first, first + each) for first in range(0, len(record) - each, each)]


def motion(log: RecordedImu, times: list[float]) -> np.ndarray:
    """Headings, rad, that the gyros carry from one attitude at the start; common error aside."""
    record = log.increments
    latitude, longitude, height = log.position
    fit = fit_inertial_frame(record, log.position)
    start = State(latitude, longitude, height, np.zeros(3), fit.mat_ib)
    even = record.between(0, len(record) // 2 * 2)
    track = navigate(start, even, Clamped(np.full(len(even) + 1, height)), 2)
    rows = np.searchsorted(track.time, np.array(times) - 1e-6)
    return np.array([euler_from_mat(track.mat_nb[row])[2] for row in rows])


def test_the_gyros_noise_is_found_under_the_motion(noise: MeasuredNoise) -> None:
    assert noise.errors.angle_random_walk < 0.001 * DEG_PER_SQRT_H
    assert noise.relative_sigma[0] < 0.25


def test_first_five_minutes(log: RecordedImu, noise: MeasuredNoise) -> None:
    """The log's own heading, coarse, is 90.6 deg."""
    result = align(spans(log.increments)[0], log.position, noise.errors)
    sigma = result.euler_sigma_deg
    assert result.heading_deg == pytest.approx(90.6, abs=2 * sigma[2])
    assert sigma[2] < 0.06
    assert result.time == pytest.approx(SPAN)


def test_spans_agree_within_their_sigma(log: RecordedImu, noise: MeasuredNoise) -> None:
    """Chi-square of six spans' headings less the motion between them, 99 %; the hidden bias is the
    same in all, so their sigmas are of noise alone. Averaging scatters by degrees."""
    parts = spans(log.increments)
    unbiased = replace(noise.errors, gyro_bias=0.0)
    results = [align(part, log.position, unbiased) for part in parts]
    moved = motion(log, [result.time for result in results])
    heading = np.array([result.heading_deg * DEG for result in results]) - moved
    weight = np.array([1 / result.covariance[2, 2] for result in results])
    mean = np.average(heading, weights=weight)
    chi_square = float(np.sum(weight * (heading - mean) ** 2))
    low, high = chi2.ppf([0.005, 0.995], len(parts) - 1)
    assert low < chi_square < high

    averaged = [euler_from_mat(level_and_gyrocompass(part, log.position[0]))[2] for part in parts]
    assert np.std(averaged - moved, ddof=1) > 100 * np.std(heading, ddof=1)


def test_a_span_agrees_with_the_whole(log: RecordedImu, noise: MeasuredNoise) -> None:
    unbiased = replace(noise.errors, gyro_bias=0.0)
    first = align(spans(log.increments)[0], log.position, unbiased)
    whole = align(log.increments, log.position, unbiased)
    moved = np.subtract(*motion(log, [whole.time, first.time]))
    difference = (whole.heading_deg - first.heading_deg) * DEG - moved
    assert abs(difference) < 3 * np.sqrt(first.covariance[2, 2])


def test_a_spoiled_span_is_refused(log: RecordedImu, noise: MeasuredNoise) -> None:
    """Latitude's sign, reversed gyros, gyros that stick for 100 s, a heading step in them alone."""
    record = spans(log.increments)[0]
    stuck, step = record.rotation.copy(), record.rotation.copy()
    stuck[15000:25000] = stuck[15000]
    step[15000:15500, 2] += 3 * DEG / 500
    spoiled = [
        (record.rotation, -1, "latitude 3[34].* expected the stated -34.25 deg.*latitude's sign"),
        (-record.rotation, 1, "latitude -3[34].* expected the stated 34.25 deg.*gyros reversed"),
        (stuck, 1, "rotation stuck from 150.00 s: the same sample for 99.99 s"),
        (step, 1, "displacement (drifts|jumps)"),
    ]
    for rotation, sign, message in spoiled:
        with pytest.raises(HrgError, match=message):
            align(replace(record, rotation=rotation), log.position * [sign, 1, 1], noise.errors)


def test_figure(log: RecordedImu) -> None:
    errors = replace(STATED, angle_random_walk=1e-7, velocity_random_walk=1e-4)
    result = align(spans(log.increments)[0], log.position, errors)
    figure = plot_alignment(result, "ring laser")
    titles = [axes.get_title(loc="left") for axes in figure.axes]
    assert [title.split()[0] for title in titles] == ["heading", "pitch", "roll"]
    assert f"{result.heading_deg:.4f}" in titles[0]
