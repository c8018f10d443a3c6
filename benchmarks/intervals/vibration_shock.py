"""Changes of the bias map by vibration, and by a mounting that came loose."""

from dataclasses import replace

import numpy as np

from benchmarks.intervals._environment import FAST, Intervals, against
from pyhrg.bench.bench import Bench
from pyhrg.bench.bias import vibration_shock
from pyhrg.bench.bias.vibration_shock import BEFORE, SHAKE, STEADY, power_ons
from pyhrg.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.parameters import TYPICAL

MODEL = "HRGSlow"
SQUARE = "pickOff.gainPerAccelerationSquared[3]"
MOUNTING, AXIS = "resonator.material.mountingDamping", "resonator.material.mountingAxis"
IMBALANCE = ("resonator.imbalanceX", "resonator.imbalanceY")


def repeat(fmu: GyroFmu, seed: int) -> Intervals:
    """Three power-ons before, three under vibration along the input axis, three after shock."""
    generator = np.random.default_rng(seed)
    shaken = dict(zip(IMBALANCE, 1e-6 * generator.standard_normal(2), strict=True))
    square = {SQUARE: 2e-8 * generator.standard_normal()}
    device = replace(TYPICAL.another(generator), model={**FAST, **shaken, **square})
    loose = {MOUNTING: generator.uniform(0, 1e-7), AXIS: generator.uniform(0, 1.5)}
    bench = Bench(fmu, device, seed, step=1.0)
    after = replace(bench, device=replace(device, model={**device.model, **loose}))
    tests = bench.run([*power_ons(bench, BEFORE, 3), *power_ons(bench, "vibration_along", 3)])
    tests += after.run(power_ons(after, "after_shock", 3))
    outcome = vibration_shock.evaluate(bench.campaign(tests))
    return against(outcome, {**during(device), **left(after.device)})


def during(device: Device) -> dict[str, float]:
    """Closed forms of `PartialResonator`, and of the mean square of specific force."""
    text, k = "change during vibration along the input axis", device.bryan_factor
    x, y = (device.model[name] * STEADY for name in IMBALANCE)
    square = device.model[SQUARE] * SHAKE**2
    return {
        f"bias {text}": 0.0,
        f"bias cos2 {text}": -y / (2 * k),
        f"bias sin2 {text}": x / (2 * k),
        f"bias cos4 {text}": -square * device.site.vertical_rate,
        f"bias sin4 {text}": square / (4 * k * device.decay_time),
    }


def left(device: Device) -> dict[str, float]:
    """The mounting's damping anisotropy D: -(D/4k) sin 4(th - axis)."""
    text, size = "change after shock", device.model[MOUNTING] / (4 * device.bryan_factor)
    turn = 4 * device.model[AXIS]
    return {
        f"bias {text}": 0.0,
        f"bias cos2 {text}": 0.0,
        f"bias cos4 {text}": size * float(np.sin(turn)),
        f"bias sin4 {text}": -size * float(np.cos(turn)),
        "noise ratio after shock": 1.0,
    }
