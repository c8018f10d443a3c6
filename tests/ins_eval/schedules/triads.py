"""Gyros for tests."""

from dataclasses import replace

import numpy as np

from pyhrg.device.device import Device


def draw_quiet_devices(device: Device, seed: int) -> list[Device]:
    """Three gyros of a kind, without noise and scatter."""
    quiet = replace(device.without_noise(), power_on_scatter=0.0, model={})
    generator = np.random.default_rng(seed)
    return [quiet.another(generator) for _ in range(3)]
