"""All checks of an FMU, one after the other."""

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from fmu_build.check.archive import Fmu, open_fmu
from fmu_build.check.experiment import (
    Experiment,
    Trace,
    find_missing_binary,
    plan_experiment,
)
from fmu_build.check.importers import IMPORTERS, Importer, MissingError
from fmu_build.check.rules import (  # noqa: F401 (modules of rules register themselves)
    archive,
    capabilities,
    sources,
    structure,
    terminals,
    units,
    variables,
)
from fmu_build.check.rules.archive import INTACT
from fmu_build.check.rules.rule import RULES, Rule
from pyhrg.common.errors import HrgError, describe_briefly
from pyhrg.common.reading.limits import refuse_unreadable


@dataclass(frozen=True)
class Check:
    """What was asked, what was found, and a remark.

    `skipped` says why nothing was asked, and is empty where something was.
    """

    name: str
    findings: list[str] = field(default_factory=list)
    remark: str = ""
    skipped: str = ""


@dataclass(frozen=True)
class FmuReport:
    """All checks of an FMU, in the order in which they were made."""

    path: Path
    checks: tuple[Check, ...]

    __repr__ = describe_briefly

    @property
    def finding_count(self) -> int:
        """Number of findings; none means that the FMU passed every check that ran."""
        return sum(len(check.findings) for check in self.checks)

    @property
    def skipped_count(self) -> int:
        """Number of checks that could not run here."""
        return sum(bool(check.skipped) for check in self.checks)


def check_fmu(path: Path | str, *, progress: Callable[[Check], None] | None = None) -> FmuReport:
    """Report on an FMU of any maker: our own rules, FMPy's validation, a run in four importers.

    Args:
        path: an FMU of FMI 2.0 or 3.0.
        progress: is called with each check as it ends.

    Raises:
        HrgError: the file is no FMU that can be read.
    """
    path = Path(path)
    done = []
    for check in run_checks(open_fmu(path)):
        if progress is not None:
            progress(check)
        done.append(check)
    return FmuReport(path, tuple(done))


def run_checks(fmu: Fmu) -> Iterator[Check]:
    """Our own rules, FMPy's validation, and a short run in every importer with equal numbers.

    A damaged archive is one finding an entry, and nothing else is asked of it.
    """
    damaged = _apply_rule(RULES[INTACT], fmu)
    if damaged:
        yield Check(INTACT, damaged, "nothing else was checked")
        return
    for name, rule in RULES.items():
        yield Check(name, _apply_rule(rule, fmu))
    yield Check("FMPy validates it", _fmpy_findings(fmu))
    yield from _runs(fmu)


def _runs(fmu: Fmu) -> Iterator[Check]:
    """In importers, where one of them can load it."""
    try:
        with refuse_unreadable(fmu.path, "experiment that can be planned"):
            planned = plan_experiment(fmu)
    except HrgError as error:
        yield Check("importers run it", [str(error)])
        return
    if planned is None:
        yield Check("importers run it", remark="it offers no co-simulation: no importer was run")
        return
    missing = list(find_missing_binary(fmu, planned))
    if missing:
        yield Check("importers run it", missing)
        return
    traces: dict[str, Trace] = {}
    skipped: list[str] = []
    for importer in IMPORTERS:
        check = _run(importer, planned, traces)
        skipped += [importer.name] if check.skipped else []
        yield check
    yield _agreement(planned, traces, skipped)


def _apply_rule(rule: Rule, fmu: Fmu) -> list[str]:
    """Findings of a rule; a number or a document that can't be read is one."""
    try:
        return list(rule(fmu))
    except (HrgError, ValueError, KeyError) as error:
        return [f"can't be read: {error}"]


def _fmpy_findings(fmu: Fmu) -> list[str]:
    from fmpy.validation import validate_fmu

    try:
        return [str(problem) for problem in validate_fmu(str(fmu.path))]
    except Exception as error:  # FMPy raises what its readers raise
        return [f"{type(error).__name__}: {error}"]


def _run(importer: Importer, planned: Experiment, traces: dict[str, Trace]) -> Check:
    name = f"{importer.name} runs it"
    try:
        name = f"{importer.name} {importer.version()} runs it"
        if planned.fmi not in importer.fmi:
            return Check(name, remark=f"not asked: it knows no FMI {planned.fmi}.0")
        recording = importer.recording(planned)
    except MissingError as error:
        return Check(name, skipped=str(error))
    except HrgError as error:
        return Check(name, [str(error)])
    traces[importer.name] = recording.trace
    return Check(name, remark=recording.remark)


def _agreement(planned: Experiment, traces: dict[str, Trace], skipped: list[str]) -> Check:
    name = "importers see equal numbers, to the last bit"
    if len(traces) < 2:
        reason = f"{len(traces)} importers ran it; two are needed to compare"
        if skipped:
            return Check(name, skipped=f"{reason}, and {', '.join(skipped)} can't run here")
        return Check(name, [reason])
    if not planned.outputs:
        return Check(name, remark="there are no real outputs to compare")
    count = len(planned.outputs) * planned.steps
    remark = f"{count} numbers of {', '.join(traces)}"
    return Check(name, list(find_disagreements(planned, traces)), remark)


def find_disagreements(experiment: Experiment, traces: Mapping[str, Trace]) -> Iterator[str]:
    """Every output whose numbers aren't finite, too few, or not the first importer's, bit by bit.

    All formats hold every bit: two importers give doubles in memory, libcosimpy and Ecos too, and
    fmi-sim the shortest decimal digits that read back as the same double.
    """
    for name in experiment.outputs:
        for importer, trace in traces.items():
            values = trace[name]
            if len(values) != experiment.steps:
                yield f"{importer}: {len(values)} values of {name}, expected {experiment.steps}"
            elif not all(map(math.isfinite, values)):
                yield f"{importer}: {name} is not finite"
        (first, reference), *others = (
            (importer, trace[name]) for importer, trace in traces.items()
        )
        for importer, values in others:
            for step, (one, other) in enumerate(zip(reference, values, strict=False), 1):
                if one != other and not (math.isnan(one) and math.isnan(other)):
                    time = experiment.start + step * experiment.step
                    yield f"{name} at {time:g} s: {one!r} in {first}, {other!r} in {importer}"
                    break
