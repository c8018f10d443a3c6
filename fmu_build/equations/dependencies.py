"""What each unknown of a model depends on, read off its equations."""

from collections.abc import Iterable
from dataclasses import dataclass

from fmu_build.equations.dae import Dae
from fmu_build.equations.sorting import (
    CURRENT,
    Assignment,
    Target,
    sort_equations,
    trace_references,
)


@dataclass(frozen=True)
class Dependencies:
    """Known scalars that a variable depends on: offsets in the model, ascending.

    Attributes:
        stepping: inputs, while the simulation runs: through continuous equations alone, since
            samples hold between ticks.
        initial: parameters and inputs, during initialization: through the tick at the start time,
            whose previous values are start values.
    """

    stepping: tuple[int, ...]
    initial: tuple[int, ...]


def trace_dependencies(dae: Dae, variables: Iterable[int]) -> dict[int, Dependencies]:
    """Dependencies of variables, by their index in the model."""
    plan = sort_equations(dae)
    continuous = _by_target((*plan.held, *plan.motion, *plan.derivatives, *plan.outputs))
    ticked = _by_target(plan.tick)
    before = {("pre", t[1]): a for t, a in _by_target(plan.starts).items() if t in ticked}
    at_start = _by_target((*plan.parameters, *plan.starts)) | continuous | ticked | before
    return {
        variable: Dependencies(
            _find_knowns(plan.dae, variable, continuous, {"input"}),
            _find_knowns(plan.dae, variable, at_start, {"input", "parameter"}),
        )
        for variable in variables
    }


def _find_knowns(
    dae: Dae, variable: int, assignments: dict[Target, Assignment], roles: set[str]
) -> tuple[int, ...]:
    """Scalars at which the way back ends: of these roles, and computed from nothing."""
    on_the_way = trace_references(dae, assignments, [("variable", variable)], (*CURRENT, "pre"))
    ends = (dae.variables[i] for kind, i in on_the_way if (kind, i) not in assignments)
    return tuple(
        sorted(
            v.offset + e
            for v in ends
            if v.role in roles and (v.role == "input" or v.settable)
            for e in range(v.count)
        )
    )


def _by_target(assignments: Iterable[Assignment]) -> dict[Target, Assignment]:
    return {a.target: a for a in assignments}
