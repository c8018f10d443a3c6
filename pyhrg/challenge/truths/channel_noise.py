"""Noise of each channel with which strengths are measured."""

import math
from dataclasses import replace

import numpy as np

from pyhrg.challenge.campaigns.instruments import Instruments
from pyhrg.device.device import Device
from pyhrg.gap.replay.observations import CHANNELS
from pyhrg.gap.whitening.whitening import NoiseModel
from pyhrg.records import Log


def state_angle_noise(device: Device) -> NoiseModel:
    """Noise of a device's output angle."""
    return NoiseModel(
        device.angle_white_noise,
        device.angle_random_walk,
        device.rate_random_walk,
        device.bias_instability,
    )


def build_noises(device: Device, instruments: Instruments, log: Log) -> dict[str, NoiseModel]:
    """Noise of the other channels in a test, whose log has no noise. A replay gets the logged
    temperature, so the thermometer's noise enters amplitude force and frequency, smoothed by the
    thermal lag. Of a steady temperature the replay gets the mean."""
    per_kelvin = {
        "amplitude_force": abs(device.decay_time_per_kelvin),
        "frequency_offset": abs(device.frequency * device.frequency_per_kelvin),
    }
    noises = {name: NoiseModel(getattr(instruments, name)) for name in CHANNELS[1:]}
    for name, slope in per_kelvin.items():
        kelvin = slope * instruments.temperature
        if np.ptp(log.temperature):
            lagged = kelvin * math.sqrt(log.interval)
            noises[name] = replace(noises[name], lagged=lagged, lag=device.thermal_lag)
        else:
            mean = kelvin / math.sqrt(len(log.time))
            noises[name] = replace(noises[name], offset=mean, offset_lag=device.thermal_lag)
    return noises
