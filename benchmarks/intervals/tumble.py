"""Bias under gravity: eight positions at four pattern angles."""

import numpy as np

from benchmarks.intervals._environment import Intervals, against
from benchmarks.intervals._force import feeling, linear, squares
from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.environment import tumble
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.theory import closed_forms as theory

MODEL = "HRGSlow"
EIGHT = (
    *tumble.SIX,
    (tumble.TILT, tumble.RIGHT / 2),
    (-tumble.TILT, tumble.RIGHT / 2),
)
"""Each axis up and down, and two tilted positions: `axis_up` and `across` of an attitude."""


def repeat(fmu: GyroFmu, seed: int) -> Intervals:
    """One power-on, one data point a position."""
    device = feeling(np.random.default_rng(seed), gain=1e-6, square=1e-7)
    bench = Bench(fmu, device, seed, step=1.0)
    course = tumble.make_programme(bench, EIGHT, segments=1)
    tests = bench.run([PowerOn("tumble", tumble.KIND, course)])
    return against(tumble.evaluate(bench.campaign(tests)), truths(device))


def truths(device: Device) -> dict[str, float]:
    """Earth's rate, which goes with specific force along z, included."""
    expected, (x, y, z) = linear(device), squares(device)
    earth = device.site.vertical_rate / device.site.gravity
    hold = theory.hold_scale_factor_error(device.control_period, 0.0, device.decay_time)
    expected["g bias z"] += earth * hold
    expected["g bias z cos4"] = -device.pickoff_gain_mismatch * earth
    expected["g bias z sin4"] -= device.pickoff_nonorthogonality * earth
    expected["g squared zz over mean"] = 0.0
    expected["g squared zz over mean sin4"] = z - (x + y + z) / 3
    expected["g squared half xx less yy sin4"] = (x - y) / 2
    return expected
