"""The bench of the study: the paper's tests, shortened, on the fast gyro.

test                  here                               full procedure
fixed position        3 power-ons of 20 min              7 of an hour
full circumference    3 power-ons, 24 positions (8N),    7 power-ons, 24 positions,
                      100 s at each                      300 s at each
scale factor          3 power-ons each way at 5 deg/s,   7 each way
                      4 periods of the map
maps, warm            one power-on of each of the latter   soaks over the range of temperatures
                      two, 15 K warmer
"""

from dataclasses import dataclass
from functools import cache

from ins_eval.error_model.effects import BRYAN_FACTOR
from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.position import fixed_position, full_circumference
from pyhrg.bench.bias.position.positions import Plan, chosen
from pyhrg.bench.scale_factor.rate_tests import turn_power_ons
from pyhrg.common.units import DEG
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.records.campaign import Campaign

STEP = 0.1
"""Of the fast gyro, s."""
WARMER = 15.0
"""Than at the calibration, K: where the maps are taken that tell how they change with it."""
RATE = 5 * DEG
"""Of the table in scale-factor tests, rad/s."""


@dataclass(frozen=True)
class BenchPlan:
    """runs: power-ons of each test; positions: 8N; segments, fixed_segments: of 100 s, at each
    position and at the fixed one; periods: of the map, in a scale-factor test."""

    runs: int = 3
    positions: int = 24
    segments: int = 1
    fixed_segments: int = 12
    periods: int = 4


CALIBRATION = BenchPlan(runs=1)
"""A maker's: one power-on."""


def campaign(
    fmu: GyroFmu, device: Device, plan: BenchPlan, seed: int, fixed: bool = True
) -> Campaign:
    """The tests of a plan.

    Args:
        fmu: `HRGSlow`.
        device: the gyro.
        plan: of the bench.
        seed: of all noise, from 0.
        fixed: whether the fixed position is wanted.
    """
    bench = Bench(fmu, device, seed=seed, step=STEP)
    power_ons = _mapping(bench, plan)
    if fixed:
        power_ons += fixed_position.power_ons(bench, plan.runs, plan.fixed_segments)
    return bench.campaign([bench.log(power_on) for power_on in power_ons])


def _mapping(bench: Bench, plan: BenchPlan) -> list[PowerOn]:
    return [
        *full_circumference.power_ons(bench, _positions(plan), plan.runs, plan.segments),
        *turn_power_ons(bench, RATE, plan.periods, plan.runs),
    ]


@cache
def _positions(plan: BenchPlan) -> Plan:
    """Spaced for the nominal gyro."""
    return chosen(plan.positions, BRYAN_FACTOR)
