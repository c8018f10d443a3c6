"""What a test procedure is: it records on the FMU, and evaluates records from anywhere."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from pyhrg.bench.bench import Bench
from pyhrg.bench.outcome import BenchError, Outcome
from pyhrg.device.device import Device
from pyhrg.records.campaign import Campaign, Test


@dataclass(frozen=True)
class Option:
    """What a user may choose of a procedure's plan: a keyword of its `record`."""

    name: str
    kind: type[int] | type[float]
    help: str

    @property
    def flag(self) -> str:
        """On the command line."""
        return f"--{self.name.replace('_', '-')}"


@dataclass(frozen=True)
class Procedure:
    """One test.

    name: on the command line.
    group: of the report.
    title: what it measures.
    rows: of the paper's Table 1 that it gives, in their English terms.
    source: where the method and its formulas are from.
    kinds: of tests that it evaluates (campaign format).
    record: makes the test's power-ons on the virtual bench; takes the options as keywords.
    evaluate: gives the outcome of a campaign that holds tests of these kinds.
    model: the gyro that the virtual bench takes (`fmu_build.roots.ROOTS`), step: its communication
        step, s.
    options: of the plan.
    exported: the gyro as the test's result makes it, from the one that was tested.
    """

    name: str
    group: str
    title: str
    rows: tuple[str, ...]
    source: str
    kinds: tuple[str, ...]
    record: Callable[..., list[Test]]
    evaluate: Callable[[Campaign], Outcome]
    model: str = "HRG"
    step: float = 0.01
    options: tuple[Option, ...] = ()
    exported: Callable[[Campaign, Device], Device] | None = None

    def run(self, bench: Bench) -> Outcome:
        """Record on the virtual bench and evaluate."""
        return self.evaluate(bench.campaign(self.record(bench)))


def usable(campaign: Campaign, *kinds: str) -> list[Test]:
    """The campaign's tests of these kinds, if any; not those held out."""
    return [test for test in campaign.of_kind(*kinds) if not test.is_holdout]


def tests_of(campaign: Campaign, *kinds: str) -> list[Test]:
    """The campaign's tests of these kinds that may be used; not those held out.

    Raises:
        BenchError: there are none.
    """
    found = usable(campaign, *kinds)
    if not found:
        there = ", ".join(sorted({test.kind for test in campaign.tests})) or "no tests"
        raise BenchError(
            f"{campaign.device}: no test of kind {' or '.join(kinds)}; the campaign has {there}"
        )
    return found


def exclusions_of(tests: Sequence[Test]) -> tuple[str, ...]:
    """What was left out on reading their logs, each with its file."""
    return tuple(f"{test.log.source}: {text}" for test in tests for text in test.log.exclusions)
