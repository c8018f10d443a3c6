"""All test procedures, in the order of a full bench."""

from pyhrg.bench import (
    bandwidth,
    dead_zone,
    fixed_position,
    full_circumference,
    measuring_range,
    position_plans,
    start_up,
    threshold,
)
from pyhrg.bench.procedure import Procedure

PROCEDURES: tuple[Procedure, ...] = (
    fixed_position.PROCEDURE,
    full_circumference.PROCEDURE,
    position_plans.PROCEDURE,
    measuring_range.PROCEDURE,
    threshold.PROCEDURE,
    start_up.PROCEDURE,
    bandwidth.PROCEDURE,
    dead_zone.PROCEDURE,
)
BY_NAME = {procedure.name: procedure for procedure in PROCEDURES}
