"""Readings of the output angle without their white noise, where that is a coarse quantization."""

import numpy as np

from pyhrg.common.arrays import Array, Mask
from pyhrg.common.caches.compiled import compile_loop
from pyhrg.device.device import Device
from pyhrg.gap.replay.observations import ObservedTest
from pyhrg.gap.whitening.channel_noise import build_angle_noise

COARSE_RATIO = 2.0
"""Ratio of the quantization step to the white noise of a reading above which the quantization error
repeats with the angle. Below it the repeating part is less than exp(-2 pi^2 / ratio^2) = 0.7 % of a
step. Chosen."""


def is_coarsely_quantized(device: Device) -> bool:
    """Whether the quantization step is so large beside the noise of a reading that the quantization
    error repeats with the angle, and is no noise."""
    return device.quantization_step > COARSE_RATIO * device.angle_white_noise


def is_table_coarse(test: ObservedTest, device: Device) -> bool:
    """Whether the encoder's step is so large beside the noise of a reading of the gyro, and the
    table turns, that the error of rounding repeats with the table angle."""
    is_coarse = test.encoder_step > COARSE_RATIO * device.angle_white_noise
    return is_coarse and bool(np.ptp(test.inputs.log.table_angle))


def smooth_readings(series: Array, is_read: Mask, interval: float, device: Device) -> Array:
    """(n, p) angles, rad, in rows `interval` seconds apart, as a walking angle that is read with
    the device's noise (docs/methods/effects.md, Eq. 3a)."""
    noise = build_angle_noise(device)
    walk = noise.angle_random_walk**2 * interval
    return np.asarray(smooth_walk(series, is_read, noise.angle_white_noise**2, walk))


@compile_loop
def smooth_walk(series: Array, is_read: Mask, white: float, walk: float) -> Array:
    """(n, p) posterior means of random walks from zero, given readings in some of n rows: the
    smoother of Rauch, Tung and Striebel (1965). `white` is the variance of a reading's noise,
    `walk` that of the walk in a row."""
    n = len(series)
    means, variances = np.zeros_like(series), np.zeros(n)
    mean, variance = np.zeros(series.shape[1]), 0.0
    for i in range(n):
        variance += walk
        if is_read[i]:
            gain = variance / (variance + white)
            for k in range(len(mean)):
                mean[k] += gain * (series[i, k] - mean[k])
            variance *= 1 - gain
        means[i], variances[i] = mean, variance
    for i in range(n - 2, -1, -1):
        gain = variances[i] / (variances[i] + walk)
        for k in range(len(mean)):
            means[i, k] += gain * (means[i + 1, k] - means[i, k])
    return means
