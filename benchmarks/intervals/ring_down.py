"""Coverage of the ring-down: four angles, all terms of the free shell. Splits are 0.2 to 0.6 mHz,
of odd seeds three times as large: rows are left out."""

from dataclasses import replace

import numpy as np

from benchmarks.intervals._identified import Intervals, bench, intervals
from pyhrg.bench.bench import PowerOn
from pyhrg.bench.identification import rate_reversal, ring_down
from pyhrg.fmu import GyroFmu

MODEL = "HRGSlow"
POSITIONS = 4


def repeat(fmu: GyroFmu, seed: int) -> Intervals:
    """One gyro: ring-downs at four angles, and its pick-offs by table rate."""
    on = bench(fmu, seed)
    larger = 3.0 if seed % 2 else 1.0
    device = replace(on.device, frequency_split=larger * on.device.frequency_split)
    on = replace(on, device=device)
    course = ring_down.make_programme(on, POSITIONS, ring_down.DECAY)
    tests = on.run([PowerOn("ring_down", ring_down.KIND, course)])
    campaign = on.campaign([*tests, *rate_reversal.record(on, duration=70.0)])
    damping = device.damping_anisotropy * np.exp(4j * device.damping_axis)
    split = device.frequency_split * np.exp(4j * device.stiffness_axis)
    return intervals(
        ring_down.evaluate(campaign),
        {
            "decay time": device.decay_time,
            "damping anisotropy": abs(damping),
            "damping anisotropy cos4": damping.real,
            "damping anisotropy sin4": damping.imag,
            "frequency split": abs(split),
            "frequency split cos4": split.real,
            "frequency split sin4": split.imag,
        },
    )
