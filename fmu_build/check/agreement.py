"""Whether importers saw the same numbers."""

import math
from collections.abc import Iterator, Mapping

from fmu_build.check.experiment import Experiment, Trace


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
        yield from _first_difference(experiment, name, traces)


def _first_difference(
    experiment: Experiment, name: str, traces: Mapping[str, Trace]
) -> Iterator[str]:
    (first, reference), *others = ((importer, trace[name]) for importer, trace in traces.items())
    for importer, values in others:
        for step, (one, other) in enumerate(zip(reference, values, strict=False), 1):
            if one != other and not (math.isnan(one) and math.isnan(other)):
                time = experiment.start + step * experiment.step
                yield f"{name} at {time:g} s: {one!r} in {first}, {other!r} in {importer}"
                break
