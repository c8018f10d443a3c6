"""The bench command with short tests, also as a program: `python -m tests.pyhrg.bench.quick`."""

import sys
from dataclasses import replace

from pyhrg.bench import catalogue
from pyhrg.bench.bench import Bench
from pyhrg.bench.bias.position import fixed_position, full_circumference
from pyhrg.bench.procedure import Procedure
from pyhrg.common.cli import main
from pyhrg.records.campaign import Test
from tests.pyhrg.bench.cases import QUICK_PLAN

RUNS = 3
LONG = 20
"""Power-ons of the test that is long enough to be interrupted."""


def _fixed(bench: Bench) -> list[Test]:
    return bench.run(fixed_position.make_power_ons(bench, RUNS, segments=3))


def _circumference(bench: Bench) -> list[Test]:
    return bench.run(full_circumference.make_power_ons(bench, QUICK_PLAN, RUNS, segments=2))


def _long(bench: Bench) -> list[Test]:
    return bench.run(fixed_position.make_power_ons(bench, LONG, segments=18))


PROCEDURES: tuple[Procedure, ...] = (
    replace(fixed_position.PROCEDURE, record=_fixed, model="HRGSlow", step=0.1),
    replace(full_circumference.PROCEDURE, record=_circumference, model="HRGSlow", step=0.1),
)
LONG_TEST = replace(
    fixed_position.PROCEDURE, name="long", title="Long", record=_long, model="HRGSlow"
)


def offer(*procedures: Procedure) -> None:
    """Put these into the catalogue, before the command is loaded."""
    catalogue.PROCEDURES = procedures


if __name__ == "__main__":
    offer(*PROCEDURES, LONG_TEST)
    sys.exit(main())
