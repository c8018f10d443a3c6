"""Functions of the flat model as C: their statements, and vectors that are one of several."""

from collections.abc import Callable

from fmu_build.code.accesses import list_statements
from fmu_build.code.emit import Emitter, name_function
from fmu_build.equations.dae import Dae, Function, Json


def write_signature(function: Function, linkage: str) -> str:
    """C declaration of a Modelica function; a vector result is written through a last pointer."""
    parameters = [
        f"real a_{p.name}" if p.size is None else f"const real *a_{p.name}" for p in function.inputs
    ]
    output = function.values[0]
    if output.size is not None:
        parameters.append(f"real *l_{output.name}")
    kind = "real" if output.size is None else "void"
    return f"{linkage} {kind} {name_function(function)}({', '.join(parameters)})"


def write_function(dae: Dae, function: Function, linkage: str) -> list[str]:
    """C definition of a Modelica function, line by line."""
    output, *rest = function.values
    lines = [f"{write_signature(function, linkage)} {{"]
    for local in rest if output.size is not None else function.values:
        lines.append(f"  real l_{local.name}{f'[{local.size}]' if local.size else ''};")
    for statement in list_statements(dae, function):
        lines.extend(_statement(dae, function, statement, "  ", nested=False))
    if output.size is None:
        lines.append(f"  return l_{output.name};")
    return [*lines, "}"]


def _statement(
    dae: Dae, function: Function, statement: Json, indent: str, nested: bool
) -> list[str]:
    ((kind, body),) = statement.items()
    if kind == "assignment":
        return _assignment(dae, function, body, indent, nested)
    if kind == "for":
        domain = dae.domains[body["domain"]]
        index = f"i{body['domain']}"
        lines = [
            f"{indent}for (int {index} = {domain.lower}; {index} <= {domain.upper}; "
            f"{index} += {domain.step}) {{"
        ]
        for inner in body["statements"]:
            lines.extend(_statement(dae, function, inner, indent + "  ", nested=True))
        return [*lines, f"{indent}}}"]
    raise ValueError(f"{function.name}: a statement of kind {kind} is not supported")


def _assignment(dae: Dae, function: Function, body: Json, indent: str, nested: bool) -> list[str]:
    emitter = Emitter(dae)
    target = function.values[body["target"]]
    node = dae.nodes[body["rhs"]]
    name = f"l_{target.name}"
    if node.kind == "conditional" and target.size is not None:
        lines = write_alternatives(
            dae, body["rhs"], lambda branch: _vector(dae, name, branch, "  ")
        )
        return [indent + line for line in lines]
    if node.kind == "array_update":
        base, pick, value = node.args
        if dae.nodes[base].kind != "function_value" and nested:
            raise ValueError(f"{function.name}: {target.name} is reset within a loop")
        text = f"{name}[{emitter.subscript(pick)} - 1] = {emitter.scalar(value)};"
    elif node.kind == "comprehension":
        domain, index = dae.domains[node.value], f"i{node.value}"
        if domain.step != 1:
            raise ValueError(f"{function.name}: a loop with a step other than 1 is not supported")
        text = (
            f"for (int {index} = {domain.lower}; {index} <= {domain.upper}; {index}++) "
            f"{name}[{index} - {domain.lower}] = {emitter.scalar(node.args[0])};"
        )
    elif target.size is None:
        text = f"{name} = {emitter.scalar(body['rhs'])};"
    else:
        return _vector(dae, name, body["rhs"], indent)
    return [indent + line for line in (*emitter.statements, text)]


def _vector(dae: Dae, name: str, expression: int, indent: str) -> list[str]:
    emitter = Emitter(dae)
    values = emitter.elements(expression)
    text = " ".join(f"{name}[{e}] = {value};" for e, value in enumerate(values))
    return [indent + line for line in (*emitter.statements, text)]


def write_alternatives(
    dae: Dae, conditional: int, assigned: Callable[[int], list[str]]
) -> list[str]:
    """A vector that is one of several expressions: only the one that holds is computed. `assigned`
    gives the lines that assign a branch, given its expression."""
    *pairs, fallback = dae.nodes[conditional].args
    lines: list[str] = []
    for condition, branch in zip(pairs[::2], pairs[1::2], strict=True):
        emitter = Emitter(dae)
        head = f"{'} else if' if lines else 'if'} (GO({emitter.scalar(condition)})) {{"
        if emitter.statements:
            raise ValueError("a vector-valued call within a condition is not supported")
        lines += [head, *assigned(branch)]
    return [*lines, "} else {", *assigned(fallback), "}"]
