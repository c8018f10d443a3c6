"""All test procedures, in the order of a full bench."""

from pyhrg.bench import fixed_position, full_circumference, position_plans, random_walk
from pyhrg.bench.procedure import Procedure

PROCEDURES: tuple[Procedure, ...] = (
    fixed_position.PROCEDURE,
    full_circumference.PROCEDURE,
    position_plans.PROCEDURE,
    random_walk.PROCEDURE,
)
BY_NAME = {procedure.name: procedure for procedure in PROCEDURES}
