"""Changes of the bias map by vibration, and by a mounting that came loose."""

from dataclasses import replace

import numpy as np

from benchmarks.intervals._environment import FAST, Intervals, against, quiet
from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.environment import vibration_shock
from pyhrg.bench.bias.environment.shock import find_pulses, read_quiet_changes
from pyhrg.bench.bias.environment.vibration_shock import (
    BEFORE,
    KEPT_ANGLE,
    RUNS,
    SHAKE,
    SHOCK,
    STEADY,
    make_power_ons,
    make_shock_programme,
)
from pyhrg.device.device import Device
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from pyhrg.records import Log

MODEL = "HRGSlow"
SQUARE = "pickOff.gainPerAccelerationSquared[3]"
MOUNTING, AXIS = "resonator.material.mountingDamping", "resonator.material.mountingAxis"
IMBALANCE = ("resonator.imbalanceX", "resonator.imbalanceY")


def repeat(fmu: GyroFmu, seed: int) -> Intervals:
    """Power-ons before, under vibration along the input axis, under pulses, and after shock."""
    generator = np.random.default_rng(seed)
    shaken = dict(zip(IMBALANCE, 1e-6 * generator.standard_normal(2), strict=True))
    square = {SQUARE: 2e-8 * generator.standard_normal()}
    device = replace(TYPICAL.another(generator), model={**FAST, **shaken, **square})
    loose = {MOUNTING: generator.uniform(0, 1e-7), AXIS: generator.uniform(0, 1.5)}
    bench = Bench(fmu, device, seed, step=1.0)
    after = replace(bench, device=replace(device, model={**device.model, **loose}))
    states = (BEFORE, "vibration_along")
    tests = bench.run([course for state in states for course in make_power_ons(bench, state, RUNS)])
    tests += after.run(make_power_ons(after, "after_shock", RUNS))
    struck = replace(bench, device=replace(device, model={**shaken, **square}), step=0.1)
    pulses = PowerOn(SHOCK, SHOCK, make_shock_programme(struck))
    outcome = vibration_shock.evaluate(bench.campaign([*tests, struck.log(pulses)]))
    kept = {
        KEPT_ANGLE: kept_angle(replace(struck, device=quiet(struck.device)).log(pulses).log, device)
    }
    return against(outcome, {**during(device), **left(after.device), **kept})


def kept_angle(log: Log, device: Device) -> float:
    """Of the test without noise."""
    kept = np.mean([pulse.kept for pulse in find_pulses(log, device.site)])
    return float(kept - np.mean(read_quiet_changes(log, device.site)))


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
