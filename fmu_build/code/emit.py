"""Expressions of the flat model as C."""

import math
from collections.abc import Collection

from fmu_build.equations.dae import Dae, Function, Node

_BINARY = {
    "add": "+",
    "subtract": "-",
    "multiply": "*",
    "divide": "/",
    "less": "<",
    "less_equal": "<=",
    "greater": ">",
    "greater_equal": ">=",
    "and": "&&",
    "or": "||",
}
_BUILTIN = {
    "floor": "m_floor",
    "integer": "m_floor",
    "abs": "fabs",
    "sqrt": "sqrt",
    "sin": "m_sin",
    "cos": "m_cos",
    "atan2": "m_atan2",
    "log": "m_log",
    "exp": "m_exp",
}


class Emitter:
    """C text of expressions; vector-valued calls become statements of their own, collected here."""

    def __init__(self, dae: Dae, registers: Collection[int] = ()) -> None:
        """Variables listed in `registers` have C variables of their own, like states."""
        self.dae = dae
        self._registers = registers
        self.statements: list[str] = []
        self._calls: dict[int, str] = {}
        self.target: int | None = None
        """Variable being assigned: the only one whose storage still holds its `pre` value."""

    def size(self, node: int) -> int | None:
        """Length of a vector expression, None for a scalar."""
        n = self.dae.nodes[node]
        if n.kind in ("variable", "pre", "derivative"):
            return self.dae.variables[n.value].size
        if n.kind == "argument":
            return self.dae.functions[n.value["function"]].inputs[n.value["ordinal"]].size
        if n.kind == "function_value":
            return self.dae.functions[n.value["function"]].values[n.value["value"]].size
        if n.kind == "call":
            return self.dae.functions[n.value].values[0].size
        if n.kind == "array":
            return len(n.args)
        if n.kind == "comprehension":
            domain = self.dae.domains[n.value]
            return len(range(domain.lower, domain.upper + 1, domain.step))
        if n.kind in ("literal", "index", "binder", "builtin"):
            return None
        sizes = {self.size(a) for a in n.args} - {None}
        if len(sizes) > 1:
            raise ValueError(f"vectors of different lengths in one expression: {sizes}")
        return next(iter(sizes), None)

    def scalar(self, node: int, element: int | None = None) -> str:
        """C expression of one scalar: of the expression itself, or of one element of a vector."""
        n = self.dae.nodes[node]
        element = None if self.size(node) is None else element
        if n.kind in _BINARY:
            left, right = (self.scalar(a, element) for a in n.args)
            return f"({left} {_BINARY[n.kind]} {right})"
        if n.kind == "negate":
            return f"(-{self.scalar(n.args[0], element)})"
        if n.kind == "power":
            if self.dae.constant(n.args[1]) != 2:
                raise ValueError("only squares are supported as powers")
            return f"m_square({self.scalar(n.args[0], element)})"
        if n.kind == "literal":
            if not math.isfinite(n.value):
                raise ValueError(f"a literal is not finite: {n.value}")
            return repr(float(n.value))
        if n.kind in ("variable", "pre", "derivative", "argument", "function_value"):
            return self._reference(n, element)
        if n.kind == "binder":
            return f"(double)i{n.value['domain']}"
        if n.kind == "builtin":
            if n.value == "no_event":
                return self.scalar(n.args[0])
            if n.value not in _BUILTIN:
                raise ValueError(f"builtin {n.value} is not supported")
            return f"{_BUILTIN[n.value]}({', '.join(self.scalar(a) for a in n.args)})"
        if n.kind == "array":
            assert element is not None
            return self.scalar(n.args[element])
        if n.kind == "index":
            return self._emit_index(n)
        if n.kind == "conditional":
            return self._conditional(n, element)
        if n.kind == "call":
            return self._call(node, n, element)
        raise ValueError(f"an expression of kind {n.kind} is not supported")

    def elements(self, node: int) -> list[str]:
        """C expressions of all scalars of an expression."""
        size = self.size(node)
        return [self.scalar(node)] if size is None else [self.scalar(node, e) for e in range(size)]

    def _reference(self, n: Node, element: int | None) -> str:
        if n.kind == "argument":
            name = f"a_{self.dae.functions[n.value['function']].inputs[n.value['ordinal']].name}"
        elif n.kind == "function_value":
            name = f"l_{self.dae.functions[n.value['function']].values[n.value['value']].name}"
        else:
            return self.reference(n.kind, n.value, element or 0)
        return name if element is None else f"{name}[{element}]"

    def reference(self, kind: str, variable: int, element: int) -> str:
        """C name of one scalar of the model."""
        position = self.dae.variables[variable].offset + element
        if kind == "derivative":
            return f"d{position}"
        if kind == "pre":
            return f"p{position}"
        own = self.dae.variables[variable].role == "state" or variable in self._registers
        return f"x{position}" if own else f"v[{position}]"

    def _emit_index(self, n: Node) -> str:
        base, pick = n.args
        position = self.dae.constant(pick)
        if position is not None:
            return self.scalar(base, int(position) - 1)
        b = self.dae.nodes[base]
        if b.kind not in ("argument", "function_value"):
            raise ValueError("a computed subscript outside a function is not supported")
        return f"{self._reference(b, None)}[{self.subscript(pick)} - 1]"

    def subscript(self, node: int) -> str:
        """C integer expression of a subscript, which counts from 1."""
        n = self.dae.nodes[node]
        if n.kind == "literal":
            return str(int(n.value))
        if n.kind == "binder":
            return f"i{n.value['domain']}"
        if n.kind in ("add", "subtract", "multiply"):
            left, right = (self.subscript(a) for a in n.args)
            return f"({left} {_BINARY[n.kind]} {right})"
        raise ValueError(f"a subscript that is a {n.kind} is not supported")

    def _conditional(self, n: Node, element: int | None) -> str:
        *pairs, fallback = n.args
        before = len(self.statements)
        text = self.scalar(fallback, element)
        for condition, branch in zip(reversed(pairs[::2]), reversed(pairs[1::2]), strict=True):
            text = f"({self.scalar(condition)} ? {self.scalar(branch, element)} : {text})"
        if len(self.statements) != before:
            raise ValueError("a vector-valued call within a conditional is not supported")
        return text

    def _call(self, node: int, n: Node, element: int | None) -> str:
        function = self.dae.functions[n.value]
        if function.values[0].size is None:
            return f"{name_function(function)}({', '.join(self._arguments(n))})"
        if node not in self._calls:
            result = f"r{node}"
            self.statements.append(f"double {result}[{function.values[0].size}];")
            arguments = ", ".join([*self._arguments(n), result])
            self.statements.append(f"{name_function(function)}({arguments});")
            self._calls[node] = result
        assert element is not None
        return f"{self._calls[node]}[{element}]"

    def _arguments(self, n: Node) -> list[str]:
        result = []
        for parameter, argument in zip(self.dae.functions[n.value].inputs, n.args, strict=True):
            if parameter.size is None:
                result.append(self.scalar(argument))
            else:
                result.append(self._vector_argument(argument))
        return result

    def _vector_argument(self, argument: int) -> str:
        n = self.dae.nodes[argument]
        if n.kind in ("argument", "function_value"):
            return self._reference(n, None)
        if n.kind == "variable" or (n.kind == "pre" and n.value == self.target):
            variable = self.dae.variables[n.value]
            if variable.role != "state" and n.value not in self._registers:
                return f"&v[{variable.offset}]"
        return f"(const double[]){{{', '.join(self.elements(argument))}}}"


def name_function(function: Function) -> str:
    """C name of a Modelica function."""
    return "f_" + function.name.replace(".", "_")
