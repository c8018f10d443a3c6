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

PROCEDURES: tuple[Procedure, ...] = (
    fixed_position.PROCEDURE,
    full_circumference.PROCEDURE,
    position_plans.PROCEDURE,
    full_temperature.PROCEDURE,
    tumble.PROCEDURE,
    centrifuge.PROCEDURE,
    vibration_shock.PROCEDURE,
    annual.PROCEDURE,
    scale_factor_angle.PROCEDURE,
    scale_factor_rate.PROCEDURE,
    linearity.PROCEDURE,
    random_walk.PROCEDURE,
    measuring_range.PROCEDURE,
    threshold.PROCEDURE,
    start_up.PROCEDURE,
    bandwidth.PROCEDURE,
    dead_zone.PROCEDURE,
    self_calibration.PROCEDURE,
    ring_down.PROCEDURE,
    rate_reversal.PROCEDURE,
    virtual_rotation.PROCEDURE,
    force_map.PROCEDURE,
    phase_step.PROCEDURE,
    amplitude_sweep.PROCEDURE,
    calibration.PROCEDURE,
)
"""In the order in which a full bench runs them."""
