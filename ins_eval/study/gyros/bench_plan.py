"""The bench of the study: the paper's tests, shortened, on the fast gyro.

test                  here                               full procedure
fixed position        7 power-ons of 20 min              7 of an hour
full circumference    3 power-ons, 24 positions (8N),    7 power-ons, 24 positions,
                      100 s at each                      300 s at each
scale factor          3 power-ons each way at 5 deg/s,   7 each way
                      4 periods of the map
maps, warm            one power-on of each of the latter   soaks over the range of temperatures
                      two, 15 K warmer
"""

from dataclasses import dataclass
from functools import cache

from ins_eval.error_model.effects import ANGULAR_GAIN
from pyhrg.bench.bench import Bench
from pyhrg.bench.bias.position import fixed_position, full_circumference
from pyhrg.bench.bias.position.positions import Plan, choose_plan
from pyhrg.bench.scale_factor.scale_factor import make_turn_power_ons
from pyhrg.common.units import DEG
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.records.campaign import Campaign

SAMPLE_INTERVAL = 0.1
"""Sample interval of the FMU on the bench, s. Chosen."""
WARM_RISE = 15.0
"""Temperature above that of the calibration at which maps are taken a second time, K. Chosen."""
TABLE_RATE = 5 * DEG
"""Rate of the turntable in scale-factor tests, rad/s. Chosen."""


@dataclass(frozen=True)
class BenchPlan:
    """Length of the bench's tests.

    Attributes:
        runs: power-ons of each map test.
        fixed_runs: power-ons of the fixed-position test.
        positions: positions around the circumference, 8N.
        segments, fixed_segments: segments of 100 s at each of these and at the fixed position.
        periods: periods of the map in a scale-factor test.
    """

    runs: int = 3
    fixed_runs: int = 7
    positions: int = 24
    segments: int = 1
    fixed_segments: int = 12
    periods: int = 4


CALIBRATION = BenchPlan(runs=1)
"""The maker's tests: one power-on."""


def record_campaign(
    fmu: GyroFmu, device: Device, plan: BenchPlan, seed: int, fixed: bool = True
) -> Campaign:
    """Records of the tests of a plan.

    Args:
        fmu: `HRGSlow`.
        seed: seed of all noise, from 0.
        fixed: whether the fixed-position test is among them.
    """
    bench = Bench(fmu, device, seed=seed, step=SAMPLE_INTERVAL)
    positions = _choose_positions(plan)
    power_ons = [
        *full_circumference.make_power_ons(bench, positions, plan.runs, plan.segments),
        *make_turn_power_ons(bench, TABLE_RATE, plan.periods, plan.runs),
    ]
    if fixed:
        power_ons += fixed_position.make_power_ons(bench, plan.fixed_runs, plan.fixed_segments)
    return bench.campaign(bench.log_all(power_ons))


@cache
def _choose_positions(plan: BenchPlan) -> Plan:
    """Table positions whose pattern angles are spaced evenly for the nominal gyro."""
    return choose_plan(plan.positions, ANGULAR_GAIN)
