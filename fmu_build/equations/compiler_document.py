"""Reads the Modelica compiler's document as a `Dae`; refuses what the generator does not know."""

import re
from collections.abc import Iterator
from fractions import Fraction

from fmu_build.equations.dae import Dae, Domain, Function, Json, Local, Node, Sample, Variable
from fmu_build.equations.ticks import Ticks


def read_document(model: str, storage: Json, source_map: Json) -> Dae:
    """Read the compiler's document: the flat model, and the Modelica texts that it comes from."""
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
    guards = [e["activation"]["when"]["guard"] for e in storage["discrete_real_equations"]]
    period, multiples = _read_periods(Ticks(storage, nodes), guards)
    equations = (e["residual"] for e in storage["discrete_real_equations"])
    sampled = tuple(map(Sample, equations, multiples))
    return Dae(
        model=model,
        variables=tuple(_variables(storage, source_map)),
        nodes=nodes,
        functions=tuple(_function(f, storage["value_types"]) for f in storage["functions"]),
        domains=tuple(_domain(d) for d in storage["domains"]),
        continuous=tuple(continuous),
        sampled=sampled,
        sample_period=period,
    )


_UNSUPPORTED = (
    "initialization_equation_operations",
    "initial_discrete_values",
    "initial_parameter_values",
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


def _read_periods(ticks: Ticks, guards: list[int]) -> tuple[Fraction, list[int]]:
    """The shortest period, and that of each sampled equation, by its guard, as a multiple of it."""
    periods = [ticks.find_period(guard) for guard in guards]
    base = min(periods)
    for period in periods:
        if (period / base).denominator != 1:
            raise ValueError(f"the sample period {period} s is no multiple of {base} s")
    return base, [int(period / base) for period in periods]


def _nodes(expressions: Json) -> Iterator[Node]:
    """Operands and subscripts lie in lists of their own, in the order of the nodes."""
    operands = iter(expressions["operands"])
    subscripts = iter(expressions["subscripts"])
    for raw in expressions["nodes"]:
        ((kind, body),) = raw.items()
        if kind == "literal":
            yield Node("literal", next(iter(body.values())), ())
        elif kind == "coordinate":
            if isinstance(body, str):
                raise ValueError(f"an equation with {body} is not supported")
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
    """A tick is not stored: no scalars."""
    dimensions = value_types[type_index]["dimensions"]
    if value_types[type_index]["scalar"] == "boolean":
        return 0
    if len(dimensions) > 1:
        raise ValueError(f"an array of {len(dimensions)} dimensions is not supported")
    return dimensions[0] if dimensions else None


_DECLARATION = re.compile(rb'(?:"(?:[^"\\]|\\.)*"|[^";])*')
_STRING = re.compile(rb'"(?:[^"\\]|\\.)*"')
_TUNABLE = re.compile(rb"\bannotation\s*\([^;]*\bEvaluate\s*=\s*false\b")


def _is_tunable(text: bytes, start: int) -> bool:
    """Whether a declaration has the annotation, which the compiler leaves out of its document."""
    declaration = _DECLARATION.match(text, start)
    return declaration is not None and bool(_TUNABLE.search(_STRING.sub(b"", declaration[0])))


def _variables(storage: Json, source_map: Json) -> Iterator[Variable]:
    files = {source: (path, text.encode()) for source, path, text in source_map["files"]}
    offset = 0
    for raw in storage["variables"]:
        attributes = raw["attributes"]
        span = raw["declaration"]["span"]
        path, text = files[span["source"]]
        scalar = storage["value_types"][raw["value_type"]]["scalar"]
        if scalar == "string":
            raise ValueError(f"{raw['name']}: a variable that is text is not supported")
        type_name = text[span["start"] : span["end"]].split()[0].decode()
        variable = Variable(
            name=raw["name"],
            role=raw["role"],
            scalar=scalar,
            size=_size(raw["value_type"], storage["value_types"]),
            causality=attributes["causality"],
            settable=attributes["is_tunable"],
            tunable=_is_tunable(text, span["start"]),
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
