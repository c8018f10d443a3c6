"""The runs in several importers, compared."""

import math
from collections.abc import Iterator, Mapping, Sequence

from fmu_build.check.check import Check
from fmu_build.check.experiment import Run, Trace
from fmu_build.check.importer import Importer, MissingError, Planned
from pyhrg.common.errors import HrgError


def run_importers(importers: Sequence[Importer[Planned]], planned: Planned) -> Iterator[Check]:
    """A run in each importer that knows the standards, and whether they see equal numbers."""
    traces: dict[str, Trace] = {}
    skipped: list[str] = []
    for importer in importers:
        check = _run(importer, planned, traces)
        skipped += [importer.name] if check.skipped else []
        yield check
    yield _agreement(planned, traces, skipped)


def _run(importer: Importer[Planned], planned: Planned, traces: dict[str, Trace]) -> Check:
    name = f"{importer.name} runs it"
    try:
        name = f"{importer.name} {importer.find_version()} runs it"
        for standard in planned.standards:
            if standard not in importer.standards:
                return Check(name, remark=f"it knows no {standard}", asked=False)
        recording = importer.record(planned)
    except MissingError as error:
        return Check(name, skipped=str(error))
    except HrgError as error:
        return Check(name, [str(error)])
    traces[importer.name] = recording.trace
    return Check(name, remark=recording.remark)


def _agreement(planned: Run, traces: dict[str, Trace], skipped: list[str]) -> Check:
    name = "importers see equal numbers, to the last bit"
    if len(traces) < 2:
        reason = f"{len(traces)} importers ran it; two are needed to compare"
        if skipped:
            return Check(name, skipped=f"{reason}, and {', '.join(skipped)} can't run here")
        return Check(name, remark=reason, asked=False)
    if not planned.outputs:
        return Check(name, remark="there are no real outputs to compare")
    count = len(planned.outputs) * planned.steps
    remark = f"{count} numbers of {', '.join(traces)}"
    return Check(name, list(find_disagreements(planned, traces)), remark)


def find_disagreements(experiment: Run, traces: Mapping[str, Trace]) -> Iterator[str]:
    """Every output whose numbers aren't finite, too few, or not the first importer's, bit by bit.

    All formats hold every bit: FMPy, Ecos and libcosimpy hand over doubles, fmi-sim prints the
    shortest decimals that read back as the same double.
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
            for step, (expected, actual) in enumerate(zip(reference, values, strict=False), 1):
                if expected != actual and not (math.isnan(expected) and math.isnan(actual)):
                    time = experiment.start + step * experiment.step
                    yield f"{name} at {time:g} s: {expected!r} in {first}, {actual!r} in {importer}"
                    break
