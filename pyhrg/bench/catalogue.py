"""All test procedures, in the order of a full bench."""

from pyhrg.bench import (
    amplitude_sweep,
    fixed_position,
    force_map,
    full_circumference,
    phase_step,
    position_plans,
    rate_reversal,
    ring_down,
    virtual_rotation,
)
from pyhrg.bench.procedure import Procedure

PROCEDURES: tuple[Procedure, ...] = (
    fixed_position.PROCEDURE,
    full_circumference.PROCEDURE,
    position_plans.PROCEDURE,
    ring_down.PROCEDURE,
    rate_reversal.PROCEDURE,
    virtual_rotation.PROCEDURE,
    force_map.PROCEDURE,
    phase_step.PROCEDURE,
    amplitude_sweep.PROCEDURE,
)
BY_NAME = {procedure.name: procedure for procedure in PROCEDURES}
