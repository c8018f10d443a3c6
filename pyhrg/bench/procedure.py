"""A test procedure: it makes records on the simulated gyro, and evaluates records of any gyro."""

from collections.abc import Callable
from dataclasses import dataclass, replace

from pyhrg.bench.outcome import BenchError, Outcome
from pyhrg.device.device import Device
from pyhrg.records.campaign import Campaign, Test
from pyhrg.records.table import fold_absent_columns


@dataclass(frozen=True)
class Option:
    """A part of a procedure's plan that a user may change: a keyword argument of its `record`.

    Attributes:
        kind: type of the option's value.
        help: line for the help of the command.
    """

    name: str
    kind: type[int] | type[float]
    help: str


@dataclass(frozen=True)
class Procedure:
    """One test of the bench.

    Attributes:
        name: name by which users choose the test.
        group: heading in the list of tests.
        title: what the test measures.
        source: reference for method and formulas.
        kinds: kinds of campaign tests that it evaluates.
        record: makes the test's power-ons on the virtual bench; takes the options as keywords.
        evaluate: gives the outcome of a campaign that holds tests of these kinds; its exclusions
            are those of this procedure, such as a turn that is too short.
        model: model that the virtual bench simulates, a key of `fmu_build.roots.ROOTS`.
        step: communication step of the simulation, s.
        options: parts of the plan that a user may change.
        export: gives the device as the test makes it (a calibrated one) from the campaign and the
            device that was tested; None where the test makes none.
    """

    name: str
    group: str
    title: str
    source: str
    kinds: tuple[str, ...]
    record: Callable[..., list[Test]]
    evaluate: Callable[[Campaign], Outcome]
    model: str = "HRG"
    step: float = 0.01
    options: tuple[Option, ...] = ()
    export: Callable[[Campaign, Device], Device] | None = None


def select_tests(campaign: Campaign, *kinds: str) -> list[Test]:
    """The campaign's tests of these kinds without those that are held out; may be none."""
    return [test for test in campaign.of_kind(*kinds) if not test.is_holdout]


def require_tests(campaign: Campaign, *kinds: str) -> list[Test]:
    """The campaign's tests of these kinds without those that are held out, at least one."""
    tests = select_tests(campaign, *kinds)
    if not tests:
        present = ", ".join(sorted({test.kind for test in campaign.tests})) or "no tests"
        raise BenchError(
            f"{campaign.device}: no test of kind {' or '.join(kinds)}; the campaign has {present}"
        )
    return tests


def evaluate_tests(procedure: Procedure, campaign: Campaign) -> Outcome:
    """The outcome of a procedure; what its tests' logs lack, and what the reader excluded of them,
    is among the exclusions, with the file's name."""
    outcome = procedure.evaluate(campaign)
    logs = [test.log for test in select_tests(campaign, *procedure.kinds)]
    noted = (f"{log.source}: {x}" for log in logs for x in fold_absent_columns(log.exclusions))
    return replace(outcome, exclusions=(*noted, *outcome.exclusions))
