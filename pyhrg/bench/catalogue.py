"""All test procedures of the bench."""

from pyhrg.bench.bias.environment import centrifuge, tumble, vibration_shock
from pyhrg.bench.bias.position import fixed_position, full_circumference, position_plans
from pyhrg.bench.bias.thermal import annual, full_temperature
from pyhrg.bench.calibration import calibration
from pyhrg.bench.dead_zone import dead_zone
from pyhrg.bench.dynamic import bandwidth, measuring_range, start_up, threshold
from pyhrg.bench.identification import (
    amplitude_sweep,
    force_map,
    phase_step,
    rate_reversal,
    ring_down,
    virtual_rotation,
)
from pyhrg.bench.noise import random_walk
from pyhrg.bench.procedure import Procedure
from pyhrg.bench.scale_factor import linearity, scale_factor_angle, scale_factor_rate
from pyhrg.bench.self_calibration import self_calibration

PROCEDURES: tuple[Procedure, ...] = tuple(
    module.PROCEDURE
    for module in (
        *(fixed_position, full_circumference, position_plans, full_temperature),
        *(tumble, centrifuge, vibration_shock, annual),
        *(scale_factor_angle, scale_factor_rate, linearity),
        *(random_walk, measuring_range, threshold, start_up, bandwidth),
        *(dead_zone, self_calibration),
        *(ring_down, rate_reversal, virtual_rotation, force_map, phase_step, amplitude_sweep),
        calibration,
    )
)
"""In the order in which a full bench runs them."""
