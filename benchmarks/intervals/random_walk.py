"""Random walk without and with virtual rotation, of gyros with random noises and bias maps."""

import math
from dataclasses import replace

import numpy as np

from pyhrg.bench.bench import Bench
from pyhrg.bench.noise import random_walk
from pyhrg.device.device import Device
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu

MODEL = "HRGSlow"
DURATION = 2000.0
NOISE = "noise.virtualRotation"


def repeat(fmu: GyroFmu, seed: int) -> dict[str, tuple[float, float, float]]:
    """Half an hour each; odd seeds have a rate random walk, even ones flicker, both clear."""
    device = drawn(seed)
    bench = Bench(fmu, device, seed, step=0.1)
    power_ons = random_walk.plan_power_ons(bench, DURATION)
    outcome = random_walk.evaluate(bench.campaign(bench.run(power_ons)))
    return {
        name: (truth, outcome.finding(name).si_low, outcome.finding(name).si_high)
        for name, truth in truths(device).items()
    }


def drawn(seed: int) -> Device:
    """A device whose every noise is within half of and twice the typical."""
    generator = np.random.default_rng(seed)
    factors = 2 ** generator.uniform(-1.0, 1.0, size=4)
    walk = TYPICAL.angle_random_walk * factors[0]
    return replace(
        TYPICAL.another(generator),
        angle_random_walk=walk,
        angle_white_noise=TYPICAL.angle_white_noise * factors[1],
        bias_instability=0.0 if seed % 2 else walk * 0.5 * factors[2],
        rate_random_walk=walk * 0.05 * factors[2] if seed % 2 else 0.0,
        model={NOISE: TYPICAL.model[NOISE] * factors[3]},
    )


def truths(device: Device) -> dict[str, float]:
    """Of what is there; virtual rotation at V adds V times its noise to the angle random walk."""
    turning = random_walk.ROTATION * device.model[NOISE]
    walk = device.angle_random_walk
    slow = {
        "bias instability": device.bias_instability,
        "rate random walk": device.rate_random_walk,
    }
    return {
        "angle random walk": walk,
        "white angle noise": device.angle_white_noise,
        "angle random walk under virtual rotation": math.hypot(walk, turning),
        random_walk.RATIO: math.hypot(walk, turning) / walk,
        **{name: truth for name, truth in slow.items() if truth},
    }
