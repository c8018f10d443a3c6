"""The elements of vectors that a function reads and writes, in the order of its C."""

from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

from fmu_build.equations.dae import Dae, Function, Json, Node


class Access(NamedTuple):
    """One reading or writing of a vector's element. The ordinal is the vector's number among the
    function's inputs, or among its other values."""

    is_write: bool
    is_input: bool
    ordinal: int
    element: int


def list_statements(dae: Dae, function: Function) -> list[Json]:
    """The statements of a function that have an effect."""
    statements = _without_refills(dae, function.statements)
    return [
        statement
        for position, statement in enumerate(statements, 1)
        if not (
            _is_fill(dae, statement)
            and _is_overwritten(dae, function, statement, statements[position:])
        )
    ]


def _without_refills(dae: Dae, statements: Iterable[Json]) -> list[Json]:
    """Leave out initial values that the next statements overwrite with initial values again."""
    result: list[Json] = []
    run: dict[int, Json] = {}
    for statement in statements:
        if _is_fill(dae, statement):
            run[statement["assignment"]["target"]] = statement
        else:
            result += [*run.values(), statement]
            run.clear()
    return [*result, *run.values()]


def _is_fill(dae: Dae, statement: Json) -> bool:
    if "assignment" not in statement:
        return False
    node = dae.nodes[statement["assignment"]["rhs"]]
    if node.kind == "comprehension":
        node = dae.nodes[node.args[0]]
    return node.kind == "literal"


def _is_overwritten(dae: Dae, function: Function, fill: Json, later: Iterable[Json]) -> bool:
    """Whether later statements overwrite every element of a filled vector before they read it."""
    target = fill["assignment"]["target"]
    size, is_output = function.values[target].size, target == 0
    if size is None:
        return False
    written: set[int] = set()
    for access in trace_accesses(dae, function, later):
        if access.is_input or access.ordinal != target or access.element in written:
            continue
        if not access.is_write:
            return False
        written.add(access.element)
        if len(written) == size:
            return True
    return not is_output


def can_replace(dae: Dae, function: Function, ordinal: int) -> bool:
    """Whether the result can overwrite an input: both are vectors of one size, and no element of
    the input is read after the same element of the result was written."""
    if (
        function.inputs[ordinal].size is None
        or function.inputs[ordinal].size != function.values[0].size
    ):
        return False
    written = set()
    for access in trace_accesses(dae, function, list_statements(dae, function)):
        if access.is_write and access.ordinal == 0:
            written.add(access.element)
        elif access.is_input and access.ordinal == ordinal and access.element in written:
            return False
    return True


def trace_accesses(dae: Dae, function: Function, statements: Iterable[Json]) -> Iterator[Access]:
    """All accesses to vectors; loops are run through."""
    return _Tracer(dae, function).run(statements, {})


class _Tracer:
    def __init__(self, dae: Dae, function: Function) -> None:
        self.dae = dae
        self.function = function

    def run(self, statements: Iterable[Json], indices: Mapping[int, int]) -> Iterator[Access]:
        for statement in statements:
            ((kind, body),) = statement.items()
            if kind == "assignment":
                yield from self._assign(body["target"], body["rhs"], indices)
            elif kind == "for":
                for index in self._range(body["domain"]):
                    yield from self.run(body["statements"], {**indices, body["domain"]: index})

    def _assign(self, target: int, expression: int, indices: Mapping[int, int]) -> Iterator[Access]:
        node, size = self.dae.nodes[expression], self.function.values[target].size
        if size is None:
            yield from self._read(expression, indices)
        elif node.kind == "array_update" and self.dae.nodes[node.args[0]].kind == "function_value":
            yield from self._read(node.args[2], indices)
            yield Access(True, False, target, self._evaluate(node.args[1], indices) - 1)
        elif node.kind == "comprehension":
            for element, index in enumerate(self._range(node.value)):
                yield from self._read(node.args[0], {**indices, node.value: index})
                yield Access(True, False, target, element)
        else:
            for element in range(size):
                yield from self._read(expression, indices)
                yield Access(True, False, target, element)

    def _read(self, expression: int, indices: Mapping[int, int]) -> Iterator[Access]:
        node = self.dae.nodes[expression]
        if node.kind == "index" and (vector := self._find_vector(self.dae.nodes[node.args[0]])):
            yield Access(False, vector[0], vector[1], self._evaluate(node.args[1], indices) - 1)
        elif vector := self._find_vector(node):
            is_input, ordinal, size = vector
            yield from (Access(False, is_input, ordinal, element) for element in range(size))
        else:
            for argument in node.args:
                yield from self._read(argument, indices)

    def _find_vector(self, node: Node) -> tuple[bool, int, int] | None:
        """Whether a node is an input, which one, and its size; None if it is no vector."""
        if node.kind == "argument":
            size = self.function.inputs[node.value["ordinal"]].size
            return size and (True, node.value["ordinal"], size)
        if node.kind == "function_value":
            size = self.function.values[node.value["value"]].size
            return size and (False, node.value["value"], size)
        return None

    def _range(self, domain: int) -> range:
        d = self.dae.domains[domain]
        return range(d.lower, d.upper + 1, d.step)

    def _evaluate(self, subscript: int, indices: Mapping[int, int]) -> int:
        node = self.dae.nodes[subscript]
        if node.kind == "literal":
            return int(node.value)
        if node.kind == "binder":
            return indices[node.value["domain"]]
        left, right = (self._evaluate(each, indices) for each in node.args)
        return {"add": left + right, "subtract": left - right, "multiply": left * right}[node.kind]
