"""Flat equations of a model, as the Modelica compiler hands them over, in types of our own."""

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

Json = dict[str, Any]


@dataclass(frozen=True)
class Node:
    """One node of the shared expression graph; `args` are node numbers."""

    kind: str
    value: Any
    args: tuple[int, ...]


@dataclass(frozen=True)
class Variable:
    """A variable of the flat model: a scalar (`size` None) or a vector."""

    name: str
    role: str
    scalar: str
    size: int | None
    causality: str
    settable: bool
    tunable: bool
    """Declared with `annotation(Evaluate = false)`: a parameter that can be set in a run."""
    unit: str
    description: str
    binding: int | None
    start: int | None
    minimum: int | None
    maximum: int | None
    nominal: int | None
    offset: int
    type_name: str
    """Declared type as written, e.g. `Units.Angle`."""
    file: str
    """The Modelica file that declares it."""

    @property
    def count(self) -> int:
        """Number of scalars."""
        return 1 if self.size is None else self.size

    def element_name(self, element: int) -> str:
        """Modelica name of one scalar."""
        return self.name if self.size is None else f"{self.name}[{element + 1}]"


@dataclass(frozen=True)
class Local:
    """A variable of a function: a scalar (`size` None) or a vector."""

    name: str
    size: int | None


@dataclass(frozen=True)
class Function:
    """A Modelica function with an algorithm; `values` are its output, then its locals."""

    name: str
    inputs: tuple[Local, ...]
    values: tuple[Local, ...]
    statements: tuple[Json, ...]


@dataclass(frozen=True)
class Domain:
    """Range of a loop."""

    lower: int
    upper: int
    step: int


@dataclass(frozen=True)
class Sample:
    """A sampled equation, and how many base periods lie between its samples."""

    equation: int
    every: int


@dataclass(frozen=True, eq=False)
class Dae:
    """A flat model whose periodic clocks tick at whole multiples of one base period.

    Attributes:
        sample_period: the base period, s; the default of `settable_period`, where there is one.
    """

    model: str
    variables: tuple[Variable, ...]
    nodes: tuple[Node, ...]
    functions: tuple[Function, ...]
    domains: tuple[Domain, ...]
    continuous: tuple[int, ...]
    sampled: tuple[Sample, ...]
    sample_period: Fraction

    @property
    def scalar_count(self) -> int:
        return sum(variable.count for variable in self.variables)

    @property
    def settable_period(self) -> Variable | None:
        """The parameter that is the base period, where it can be set."""
        periods = (v for v in self.variables if v.name == "samplePeriod" and v.settable)
        return next(periods, None)

    def constant(self, node: int | None, element: int = 0) -> float | None:
        """Value of a constant expression, or of one element of a constant vector; None where it
        depends on anything."""
        if node is None:
            return None
        n = self.nodes[node]
        if n.kind == "literal":
            return float(n.value)
        if n.kind == "negate":
            value = self.constant(n.args[0], element)
            return None if value is None else -value
        if n.kind == "array":
            return self.constant(n.args[element])
        if n.kind == "comprehension":
            return self.constant(n.args[0])
        return None

    def is_constant(self, node: int | None, count: int) -> bool:
        """Whether every one of `count` elements of an expression is a constant."""
        return all(self.constant(node, element) is not None for element in range(count))
