"""Ticks of a model: those of its sample clocks, and those that a counter takes from them."""

import operator
from collections.abc import Callable
from fractions import Fraction

from fmu_build.equations.dae import Json, Node

_LONGEST = 1_000_000
"""Ticks that are counted before a division of a clock is refused."""

_OPERATIONS: dict[str, Callable[[float, float], float]] = {
    "add": operator.add,
    "subtract": operator.sub,
    "multiply": operator.mul,
    "less": operator.lt,
    "less_equal": operator.le,
    "greater": operator.gt,
    "greater_equal": operator.ge,
}


class Ticks:
    """Periods of the ticks in the compiler's document, s. The first tick is at time 0."""

    def __init__(self, storage: Json, nodes: tuple[Node, ...]) -> None:
        """Read all clocks and Boolean variables.

        Raises:
            ValueError: for a clock with a phase, or a Boolean variable that is no tick.
        """
        self._nodes = nodes
        self._variables = storage["variables"]
        self._conditions = storage["conditions"]
        self._clocks = [_read_period(clock) for clock in storage["clocks"]]
        self._booleans = dict(self._read_boolean(o) for o in storage["discrete_value_owners"])
        self._samples = {
            nodes[nodes[e["residual"]].args[0]].value: e for e in storage["discrete_real_equations"]
        }
        for expression in self._booleans.values():
            self._find_period(expression)

    def find_period(self, condition: int) -> Fraction:
        """Period of a condition of the document."""
        ((kind, value),) = self._conditions[condition]["node"].items()
        if kind == "clock":
            return self._clocks[value]
        if kind == "discrete":
            return self._find_period(value)
        raise ValueError(f"a condition is no tick of a clock: {kind}")

    def _read_boolean(self, owner: Json) -> tuple[int, int]:
        """A Boolean variable and its expression."""
        (target,), (branch, *others) = owner["targets"], owner["branches"]
        if branch["activation"] != "always" or others:
            raise ValueError(f"{self._variables[target]['name']} is no tick of a clock")
        return target, branch["values"][0]["value"]

    def _find_period(self, expression: int) -> Fraction:
        """Period of the ticks at which a Boolean expression is true."""
        node = self._nodes[expression]
        if node.kind == "condition":
            return self.find_period(node.value)
        if node.kind == "discrete_value":
            return self._find_period(self._booleans[node.value])
        if node.kind == "and":
            period = self._find_period(node.args[0])
            return period * self._count(node.args[1], period)
        raise ValueError(f"a Boolean variable is no tick of a clock: {node.kind}")

    def _count(self, expression: int, period: Fraction) -> int:
        """Ticks from one at which a condition on counters is true to the next, by counting."""
        passed: list[int] = []
        before: dict[int, float] = {}
        for tick in range(_LONGEST):
            now: dict[int, float] = {}
            if self._evaluate(expression, period, before, now):
                passed.append(tick)
            if len(passed) == 3:
                break
            before = now
        if len(passed) < 3 or passed[0] != 0 or passed[2] != 2 * passed[1]:
            raise ValueError(f"a clock is not divided evenly: its ticks {passed} pass")
        return passed[1]

    def _evaluate(
        self, expression: int, period: Fraction, before: dict[int, float], now: dict[int, float]
    ) -> float:
        """Value of an expression at a tick, from those of counters at the tick before; adds those
        of now."""
        node = self._nodes[expression]
        values = (self._evaluate(arg, period, before, now) for arg in node.args)
        if node.kind == "literal":
            return float(node.value)
        if node.kind in _OPERATIONS:
            return _OPERATIONS[node.kind](*values)
        if node.kind == "builtin" and node.value == "no_event":
            return next(values)
        if node.kind == "conditional":
            *pairs, fallback = values
            chosen = (v for c, v in zip(pairs[::2], pairs[1::2], strict=True) if c)
            return next(chosen, fallback)
        if node.kind not in ("variable", "pre"):
            raise ValueError(f"a clock is divided by an expression of kind {node.kind}")
        attributes = self._variables[node.value]["attributes"]
        if node.value in self._samples:
            if node.kind == "pre":
                start = attributes["start"]
                return before[node.value] if before else self._evaluate(start, period, {}, {})
            if node.value not in now:
                counting = self._read_counting(node.value, period)
                now[node.value] = self._evaluate(counting, period, before, now)
            return now[node.value]
        if attributes["binding"] is None or attributes["is_tunable"]:
            name = self._variables[node.value]["name"]
            raise ValueError(f"a clock is divided by {name}, which is not final")
        return self._evaluate(attributes["binding"], period, before, now)

    def _read_counting(self, counter: int, period: Fraction) -> int:
        """The expression that a counter is given at each tick of a period."""
        equation = self._samples[counter]
        if self.find_period(equation["activation"]["when"]["guard"]) != period:
            name = self._variables[counter]["name"]
            raise ValueError(f"{name} divides a clock whose ticks it does not count")
        return self._nodes[equation["residual"]].args[1]


def _read_period(clock: Json) -> Fraction:
    lattice = clock["kind"]["periodic"]["lattice"]
    if lattice["phase"]["num"] != 0:
        raise ValueError("the sample clock does not start at time 0")
    return Fraction(lattice["period"]["num"], lattice["period"]["den"])
