"""Which inputs and parameters an output depends on, read from the equations."""

from collections.abc import Mapping

from fmu_build.dae import Dae
from fmu_build.sorting import references, schedule


class Dependencies:
    """Knowns behind each unknown, as indices of variables.

    At a communication point outputs are algebraic in inputs; states and sampled variables are
    given. During initialization these have their start values, so that parameters matter.
    """

    def __init__(self, dae: Dae) -> None:
        plan = schedule(dae)
        self._dae = plan.dae
        continuous = {
            a.target[1]: a.expression
            for a in (*plan.held, *plan.derivatives, *plan.outputs)
            if a.target[0] == "variable"
        }
        given = {a.target[1]: a.expression for a in (*plan.parameters, *plan.starts)}
        self._continuous = continuous
        self._initial = continuous | given

    def at_communication_points(self, unknown: int) -> list[int]:
        """Inputs that an output depends on without a step in between, ascending."""
        reached = self._reached(unknown, self._continuous)
        return [i for i in reached if self._dae.variables[i].role == "input"]

    def at_initialization(self, unknown: int) -> list[int]:
        """Inputs and settable parameters that a start value depends on, ascending."""
        reached = self._reached(unknown, self._initial)
        roles = ("input", "parameter")
        return [
            i
            for i in reached
            if self._dae.variables[i].role in roles and i not in self._initial and i != unknown
        ]

    def _reached(self, root: int, expressions: Mapping[int, int]) -> list[int]:
        seen = {root}
        pending = [root]
        while pending:
            expression = expressions.get(pending.pop())
            if expression is not None:
                new = {i for _, i in references(self._dae, expression)} - seen
                seen |= new
                pending.extend(new)
        return sorted(seen)
