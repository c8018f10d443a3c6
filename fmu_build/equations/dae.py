"""Flat equations of a model, as the Modelica compiler hands them over, in types of our own."""

from collections.abc import Iterator
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
    tunable: bool
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
        """Number of scalars in all variables."""
        return sum(variable.count for variable in self.variables)

    @property
    def settable_period(self) -> Variable | None:
        """The parameter that is the base period, where it can be set."""
        found = (v for v in self.variables if v.name == "samplePeriod" and v.tunable)
        return next(found, None)

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


def parse(model: str, storage: Json, source_map: Json) -> Dae:
    """Read the compiler's document: the flat model, and the Modelica texts that it comes from.

    Raises:
        ValueError: it holds what this generator does not know.
    """
    _refuse_unknown(storage)
    nodes = tuple(_nodes(storage["expressions"]))
    continuous = []
    for operation in storage["continuous_equation_operations"]:
        ((kind, equation),) = operation.items()
        if kind == "residual":
            continuous.append(equation["residual"])
        elif kind == "structured" and len(equation["bodies"]) == 1:
            continuous.append(equation["bodies"][0])
        else:
            raise ValueError(f"an equation of kind {kind} is not supported")
    period, multiples = _periods(storage["clocks"])
    return Dae(
        model=model,
        variables=tuple(_variables(storage, source_map)),
        nodes=nodes,
        functions=tuple(_function(f, storage["value_types"]) for f in storage["functions"]),
        domains=tuple(_domain(d) for d in storage["domains"]),
        continuous=tuple(continuous),
        sampled=tuple(
            Sample(e["residual"], multiples[_clock(e, storage)])
            for e in storage["discrete_real_equations"]
        ),
        sample_period=period,
    )


_UNSUPPORTED = (
    "initialization_equation_operations",
    "initial_discrete_values",
    "initial_parameter_values",
    "discrete_value_owners",
    "model_event_transactions",
    "relations",
    "roots",
    "structured_roots",
    "time_events",
    "event_actions",
    "previous_values",
    "terminals",
    "delays",
)


def _refuse_unknown(storage: Json) -> None:
    for key in _UNSUPPORTED:
        if storage[key]:
            raise ValueError(f"the model has {key.replace('_', ' ')}; they are not supported")
    if not storage["clocks"]:
        raise ValueError("the model has no sample clock")
    for condition in storage["conditions"]:
        if "clock" not in condition["node"]:
            raise ValueError(f"a condition is not a sample clock: {condition['node']}")


def _periods(clocks: list[Json]) -> tuple[Fraction, list[int]]:
    """The shortest period, and each clock's period as a multiple of it."""
    periods = [_period(clock) for clock in clocks]
    base = min(periods)
    for period in periods:
        if (period / base).denominator != 1:
            raise ValueError(f"the sample period {period} s is no multiple of {base} s")
    return base, [int(period / base) for period in periods]


def _period(clock: Json) -> Fraction:
    lattice = clock["kind"]["periodic"]["lattice"]
    if lattice["phase"]["num"] != 0:
        raise ValueError("the sample clock does not start at time 0")
    return Fraction(lattice["period"]["num"], lattice["period"]["den"])


def _clock(equation: Json, storage: Json) -> int:
    return int(storage["conditions"][equation["activation"]["when"]["guard"]]["node"]["clock"])


def _nodes(expressions: Json) -> Iterator[Node]:
    """Operands and subscripts lie in lists of their own, in the order of the nodes."""
    operands = iter(expressions["operands"])
    subscripts = iter(expressions["subscripts"])
    for raw in expressions["nodes"]:
        ((kind, body),) = raw.items()
        if kind == "literal":
            yield Node("literal", next(iter(body.values())), ())
        elif kind == "coordinate":
            ((role, target),) = body.items()
            yield Node(_COORDINATES.get(role, role), target, ())
        elif kind == "binary":
            yield Node(body["operator"], None, (body["lhs"], body["rhs"]))
        elif kind == "unary":
            yield Node(body["operator"], None, (body["operand"],))
        elif kind in ("index", "array_update"):
            picks = tuple(next(subscripts)["kind"]["index"] for _ in range(body["subscript_count"]))
            rest = (body["value"],) if kind == "array_update" else ()
            yield Node(kind, None, (body["base"], *picks, *rest))
        elif kind in ("array", "builtin", "call", "conditional"):
            args = tuple(next(operands) for _ in range(body["operand_count"]))
            name = body.get("builtin") if kind == "builtin" else body.get("function")
            yield Node(kind, name, args)
        elif kind == "comprehension":
            yield Node(kind, body["domain"], (body["body"],))
        else:
            yield Node(kind, body, ())


_COORDINATES = {
    "parameter": "variable",
    "input": "variable",
    "algebraic": "variable",
    "state": "variable",
    "discrete_real": "variable",
    "derivative": "derivative",
    "pre_discrete_real": "pre",
    "function_parameter": "argument",
}


def _size(type_index: int, value_types: list[Json]) -> int | None:
    dimensions = value_types[type_index]["dimensions"]
    if len(dimensions) > 1:
        raise ValueError(f"an array of {len(dimensions)} dimensions is not supported")
    return dimensions[0] if dimensions else None


def _variables(storage: Json, source_map: Json) -> Iterator[Variable]:
    files = {source: (path, text.encode()) for source, path, text in source_map["files"]}
    offset = 0
    for raw in storage["variables"]:
        attributes = raw["attributes"]
        span = raw["declaration"]["span"]
        path, text = files[span["source"]]
        type_name = text[span["start"] : span["end"]].split()[0].decode()
        variable = Variable(
            name=raw["name"],
            role=raw["role"],
            scalar=storage["value_types"][raw["value_type"]]["scalar"],
            size=_size(raw["value_type"], storage["value_types"]),
            causality=attributes["causality"],
            tunable=attributes["is_tunable"],
            unit=attributes["unit"] or "",
            description=attributes["description"] or "",
            binding=attributes["binding"],
            start=attributes["start"],
            minimum=attributes["min"],
            maximum=attributes["max"],
            nominal=attributes["nominal"],
            offset=offset,
            type_name=type_name,
            file=path,
        )
        offset += variable.count
        yield variable


def _function(raw: Json, value_types: list[Json]) -> Function:
    if raw["external"] is not None or len(raw["outputs"]) != 1:
        raise ValueError(f"function {raw['name']}: one output and no external code are supported")

    def locals_of(key: str) -> tuple[Local, ...]:
        return tuple(Local(x["name"], _size(x["value_type"], value_types)) for x in raw[key])

    return Function(
        name=raw["name"],
        inputs=locals_of("parameters"),
        values=locals_of("outputs") + locals_of("locals"),
        statements=tuple(raw["statements"]),
    )


def _domain(raw: Json) -> Domain:
    binders = raw["domain"]["binders"]
    if len(binders) != 1:
        raise ValueError("a loop over several indices is not supported")
    return Domain(binders[0]["lower"], binders[0]["upper"], binders[0]["step"])
