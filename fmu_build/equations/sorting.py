"""Flat equations to assignments in an order that can be executed."""

from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass, replace
from functools import lru_cache

from fmu_build.equations.dae import Dae

Target = tuple[str, int]
"""What an equation defines: ("variable" or "derivative", index of the variable)."""


CURRENT = ("variable", "derivative")
"""Kinds of nodes that read a variable's current value."""


@dataclass(frozen=True)
class Assignment:
    """`target := expression`, a whole scalar or vector at a time, at every so many-th tick."""

    target: Target
    expression: int
    every: int = 1


@dataclass(frozen=True)
class Schedule:
    """The model's assignments, each list in executable order.

    Attributes:
        dae: the model with every alias replaced by what it stands for.
        parameters: dependent parameters, once.
        starts: start values of states and sampled variables, once parameters are known; outputs
            that are another name of a sampled variable.
        held: variables that derivatives or samples need and that depend on no state; they change
            only at a sample or when an input is set.
        motion: variables that derivatives or samples need and that depend on states alone; they
            change only with a step.
        derivatives: what else than the held variables the derivatives need, and the derivatives.
        outputs: all other continuous variables, aliases among them.
        tick: sampled variables, and the continuous variables that they need; held variables, at the
            period of the most frequent sample that changes them; outputs that are another name of a
            sampled variable.
    """

    dae: Dae
    parameters: tuple[Assignment, ...]
    starts: tuple[Assignment, ...]
    held: tuple[Assignment, ...]
    motion: tuple[Assignment, ...]
    derivatives: tuple[Assignment, ...]
    outputs: tuple[Assignment, ...]
    tick: tuple[Assignment, ...]


@lru_cache(maxsize=1)
def sort_equations(dae: Dae) -> Schedule:
    """Order the model's equations."""
    continuous = _assign(dae, dae.continuous)
    sampled = {}
    for sample in dae.sampled:
        target = _explicit_target(dae, sample.equation)
        sampled[target] = Assignment(target, _sides(dae, sample.equation)[1], sample.every)
    dae = _without_aliases(dae, continuous)
    state_free = _state_free(dae, continuous)
    derivatives = [t for t in continuous if t[0] == "derivative"]
    needed = _closure(dae, continuous, derivatives)
    sampling = _sampling(dae, continuous | sampled, sampled)
    used = {*needed, *sampling}
    held = {t: continuous[t] for t in continuous if t in state_free and t in used}
    motion = _motion(dae, {t: continuous[t] for t in continuous if t in used and t not in held})
    readings = _readings(dae, continuous, sampled)
    own = {t: a for t, a in sampling.items() if t not in held and t not in motion}
    # what the next step begins with comes first: it need not wait for the rest of the sample
    changing = _changing(dae, held, sampled)
    tick = {t: a for t, a in changing.items() if t in needed} | own | changing | readings
    done = held | motion | readings
    rest = {t: a for t, a in continuous.items() if t not in done and t[0] == "variable"}
    return Schedule(
        dae=dae,
        parameters=_order(dae, _parameters(dae)),
        starts=(*_starts(dae), *readings.values()),
        held=_order(dae, held),
        motion=_order(dae, motion),
        derivatives=_order(dae, {t: continuous[t] for t in needed if t not in state_free}),
        outputs=_order(dae, rest),
        tick=_order(dae, tick),
    )


def _without_aliases(dae: Dae, continuous: dict[Target, Assignment]) -> Dae:
    """Read the source where a variable is only another name for it."""
    source: dict[int, int] = {}
    for (kind, index), assignment in continuous.items():
        node = dae.nodes[assignment.expression]
        if kind == node.kind == "variable":
            source[index] = node.value

    def root(index: int) -> int:
        visited = {index}
        while index in source and source[index] not in visited:
            index = source[index]
            visited.add(index)
        return index

    nodes = (
        replace(n, value=root(n.value)) if n.kind == "variable" and n.value in source else n
        for n in dae.nodes
    )
    return replace(dae, nodes=tuple(nodes))


def find_references(
    dae: Dae, expression: int, kinds: Collection[str] = CURRENT
) -> Iterator[Target]:
    """Variables that an expression reads by nodes of these kinds."""
    pending = [expression]
    while pending:
        node = dae.nodes[pending.pop()]
        if node.kind in kinds:
            yield (node.kind, node.value)
        pending.extend(node.args)


def _sides(dae: Dae, residual: int) -> tuple[int, int]:
    node = dae.nodes[residual]
    if node.kind != "subtract":
        raise ValueError(f"an equation is not of the form left = right: {node.kind}")
    return node.args[0], node.args[1]


def _changing(
    dae: Dae, held: dict[Target, Assignment], sampled: dict[Target, Assignment]
) -> dict[Target, Assignment]:
    """Held variables that samples change, with the period of the most frequent of those samples."""
    result = {}
    for target, assignment in held.items():
        sources = trace_references(dae, held, [target])
        periods = [sampled[t].every for t in sources if t in sampled]
        if periods:
            result[target] = replace(assignment, every=min(periods))
    return result


def _readings(
    dae: Dae, continuous: dict[Target, Assignment], sampled: dict[Target, Assignment]
) -> dict[Target, Assignment]:
    """Outputs of the model that are other names of sampled variables."""
    result = {}
    for target, assignment in continuous.items():
        node = dae.nodes[assignment.expression]
        source = sampled.get((node.kind, node.value))
        if source and dae.variables[target[1]].causality == "output":
            result[target] = replace(assignment, every=source.every)
    return result


def _explicit_target(dae: Dae, residual: int) -> Target:
    node = dae.nodes[_sides(dae, residual)[0]]
    if node.kind not in ("variable", "derivative"):
        raise ValueError(f"an equation's left side is no variable: {node.kind}")
    return (node.kind, node.value)


def _sampling(
    dae: Dae, assignments: dict[Target, Assignment], sampled: dict[Target, Assignment]
) -> dict[Target, Assignment]:
    """Sampled variables, and what they need as often as the most frequent of them."""
    result: dict[Target, Assignment] = {}
    for every in sorted({a.every for a in sampled.values()}):
        roots = [t for t, a in sampled.items() if a.every == every]
        for target in _closure(dae, assignments, roots):
            own = sampled[target].every if target in sampled else every
            result.setdefault(target, replace(assignments[target], every=own))
    return result


def _assign(dae: Dae, equations: Iterable[int]) -> dict[Target, Assignment]:
    """Match each continuous equation with the variable that it defines."""
    candidates: list[dict[Target, int]] = []
    for residual in equations:
        left, right = _sides(dae, residual)
        options = {}
        for side, other in ((left, right), (right, left)):
            node = dae.nodes[side]
            if node.kind == "derivative" or (
                node.kind == "variable"
                and dae.variables[node.value].role in ("algebraic", "output")
            ):
                options[(node.kind, node.value)] = other
        candidates.append(options)
    owner: dict[Target, int] = {}

    def find(equation: int, seen: set[Target]) -> bool:
        for target in candidates[equation]:
            if target not in seen:
                seen.add(target)
                if target not in owner or find(owner[target], seen):
                    owner[target] = equation
                    return True
        return False

    for equation in range(len(candidates)):
        if not find(equation, set()):
            raise ValueError(f"equation {equation} defines no variable of its own")
    return {
        target: Assignment(target, candidates[equation][target])
        for target, equation in owner.items()
    }


def _motion(dae: Dae, candidates: dict[Target, Assignment]) -> dict[Target, Assignment]:
    """Variables that depend on states and on nothing else that can change."""
    states = {("variable", i) for i, v in enumerate(dae.variables) if v.role == "state"}
    return {
        t: a
        for t, a in candidates.items()
        if t[0] == "variable"
        and trace_references(dae, candidates, [t]) - candidates.keys() <= states
    }


def _state_free(dae: Dae, continuous: dict[Target, Assignment]) -> set[Target]:
    """Continuous variables that depend on parameters, inputs and sampled variables alone."""
    states = {("variable", i) for i, v in enumerate(dae.variables) if v.role == "state"}
    states |= {t for t in continuous if t[0] == "derivative"}
    return {t for t in continuous if not states & trace_references(dae, continuous, [t])}


def trace_references(
    dae: Dae,
    assignments: dict[Target, Assignment],
    roots: Iterable[Target],
    kinds: Collection[str] = CURRENT,
) -> set[Target]:
    """The roots and all that they depend on by nodes of these kinds."""
    seen: set[Target] = set()
    pending = list(roots)
    while pending:
        target = pending.pop()
        if target not in seen:
            seen.add(target)
            if target in assignments:
                pending.extend(find_references(dae, assignments[target].expression, kinds))
    return seen


def _closure(
    dae: Dae, assignments: dict[Target, Assignment], roots: Iterable[Target]
) -> list[Target]:
    """The roots and all assigned variables that they depend on, in the order of declaration."""
    needed = trace_references(dae, assignments, roots)
    return [t for t in assignments if t in needed]


def _parameters(dae: Dae) -> dict[Target, Assignment]:
    return {
        ("variable", i): Assignment(("variable", i), v.binding)
        for i, v in enumerate(dae.variables)
        if v.role == "parameter"
        and v.binding is not None
        and not dae.is_constant(v.binding, v.count)
    }


def _starts(dae: Dae) -> Iterator[Assignment]:
    for i, variable in enumerate(dae.variables):
        if variable.role in ("state", "discrete_real"):
            if variable.start is None:
                raise ValueError(f"{variable.name} has no start value")
            yield Assignment(("variable", i), variable.start)


def _order(dae: Dae, assignments: dict[Target, Assignment]) -> tuple[Assignment, ...]:
    """Topological order."""
    ordered: list[Assignment] = []
    done: set[Target] = set()
    path: list[Target] = []

    def visit(target: Target) -> None:
        if target in done or target not in assignments:
            return
        if target in path:
            names = [dae.variables[t[1]].name for t in path[path.index(target) :]]
            raise ValueError(f"algebraic loop: {' -> '.join(names)}")
        path.append(target)
        for reference in find_references(dae, assignments[target].expression):
            visit(reference)
        path.pop()
        done.add(target)
        ordered.append(assignments[target])

    for target in assignments:
        visit(target)
    return tuple(ordered)
