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

    stepping: inputs, while the simulation runs: through continuous equations alone, since samples
        hold between ticks.
    initial: parameters and inputs, during initialization: through the tick at the start time, whose
        previous values are start values.
    """

    stepping: tuple[int, ...]
    initial: tuple[int, ...]


class Graph:
    """Assignments of a model, to be followed back to what can be set."""

    def __init__(self, dae: Dae) -> None:
        plan = sort_equations(dae)
        self._dae = plan.dae
        self._continuous = _by_target((*plan.held, *plan.derivatives, *plan.outputs))
        ticked = _by_target(plan.tick)
        before = {("pre", t[1]): a for t, a in _by_target(plan.starts).items() if t in ticked}
        at_start = _by_target((*plan.parameters, *plan.starts)) | self._continuous | ticked
        self._initial = at_start | before

    def of(self, variable: int) -> Dependencies:
        """Dependencies of the variable with this index."""
        return Dependencies(
            self._knowns(variable, self._continuous, {"input"}),
            self._knowns(variable, self._initial, {"input", "parameter"}),
        )

    def _knowns(
        self, variable: int, assignments: dict[Target, Assignment], roles: set[str]
    ) -> tuple[int, ...]:
        """Scalars at which the way back ends: of these roles, and computed from nothing."""
        on_the_way = trace_references(
            self._dae, assignments, [("variable", variable)], (*CURRENT, "pre")
        )
        ends = (self._dae.variables[i] for kind, i in on_the_way if (kind, i) not in assignments)
        return tuple(
            sorted(
                v.offset + e
                for v in ends
                if v.role in roles and (v.role == "input" or v.tunable)
                for e in range(v.count)
            )
        )


def _by_target(assignments: Iterable[Assignment]) -> dict[Target, Assignment]:
    return {a.target: a for a in assignments}
