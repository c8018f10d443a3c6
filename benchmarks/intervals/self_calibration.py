"""Coverage of the self-calibration's intervals, on gyros and noises drawn at random."""

from dataclasses import replace

import numpy as np

from pyhrg.bench.bench import Bench
from pyhrg.bench.self_calibration.self_calibration import ROTATION, evaluate, record
from pyhrg.common.units import DEG_PER_SQRT_H
from pyhrg.device.device import Device
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from pyhrg.theory import closed_forms as theory

MODEL = "HRGSlow"
RUNS, CYCLES = 2, 2


def drawn(generator: np.random.Generator) -> Device:
    """A gyro of the typical kind whose rotation has an error and noise of its own."""
    walk = generator.uniform(3e-4, 3e-3) * DEG_PER_SQRT_H
    return replace(
        TYPICAL.another(generator),
        demodulation_offset=generator.normal(0.0, 2e-5),
        bryan_factor_error=generator.normal(0.0, 1e-5),
        virtual_rotation_error=generator.normal(0.0, 1e-4),
        model={"noise.virtualRotation": walk / ROTATION},
    )


def truth(device: Device) -> dict[str, float]:
    """By finding, SI; forces that are held lag both rotations alike."""
    off = device.angle_random_walk
    on = float(np.hypot(off, ROTATION * device.model["noise.virtualRotation"]))
    hold = theory.hold_scale_factor_error(device.control_period, 0.0, device.decay_time)
    cycle = np.pi / (device.bryan_factor * ROTATION) * 2
    return {
        "bias on": theory.mean_bias(device),
        "bias stability on": on / np.sqrt(cycle),
        "bias repeatability on": on / np.sqrt(CYCLES * cycle),
        "virtual rotation gain error": device.virtual_rotation_error + hold,
        "scale factor error on": device.bryan_factor_error + hold,
        "scale factor error off": device.bryan_factor_error + hold,
        "angle random walk on": on,
        "angle random walk off": off,
        "random walk on over off": on / off,
    }


def repeat(fmu: GyroFmu, seed: int) -> dict[str, tuple[float, float, float]]:
    """Truth, low and high of each figure."""
    device = drawn(np.random.default_rng(seed))
    bench = Bench(fmu, device, seed, step=0.1)
    outcome = evaluate(bench.campaign(record(bench, RUNS, CYCLES)))
    found = {name: outcome.finding(name) for name in truth(device)}
    return {name: (truth(device)[name], f.si_low, f.si_high) for name, f in found.items()}
