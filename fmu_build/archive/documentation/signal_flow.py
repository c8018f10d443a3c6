"""The model's signal flow as a figure: which component reads what from which, by its equations."""

from collections.abc import Mapping
from html import escape

from fmu_build.equations.dae import Dae, Variable
from fmu_build.equations.scalars import find_causality
from fmu_build.equations.sorting import find_references, sort_equations

Edges = Mapping[tuple[str, str], frozenset[str]]
"""Names of the variables that go from one component to another."""

INPUTS, OUTPUTS = "inputs", "outputs"

BOX_WIDTH, BOX_HEIGHT, GAP, RISE = 104, 44, 46, 30


def find_signal_flow(dae: Dae) -> Edges:
    """Signals between the model's top-level components, its inputs and its outputs."""
    plan = sort_equations(dae)
    edges: dict[tuple[str, str], set[str]] = {}
    for assignment in {*plan.held, *plan.motion, *plan.derivatives, *plan.outputs, *plan.tick}:
        target = _place(plan.dae, plan.dae.variables[assignment.target[1]])
        for _, index in find_references(plan.dae, assignment.expression):
            source = _place(plan.dae, plan.dae.variables[index])
            if target and source and target != source:
                name = plan.dae.variables[index].name.split(".")[-1]
                edges.setdefault((source, target), set()).add(name)
    return {pair: frozenset(names) for pair, names in edges.items()}


def draw_signal_flow(dae: Dae) -> str:
    """Boxes in a row in the order of declaration; arcs above lead forward, arcs below back."""
    edges = find_signal_flow(dae)
    used = {name for pair in edges for name in pair}
    declared = dict.fromkeys(_place(dae, variable) for variable in dae.variables)
    inner = [name for name in declared if name in used - {INPUTS, OUTPUTS}]
    boxes = [name for name in (INPUTS, *inner, OUTPUTS) if name in used]
    place = {name: position for position, name in enumerate(boxes)}
    reach = [place[target] - place[source] for source, target in edges]
    middle = max(reach, default=0) * RISE * 0.75 + BOX_HEIGHT
    height = middle + max(-r for r in [*reach, 0]) * RISE * 0.75 + BOX_HEIGHT
    width = len(boxes) * (BOX_WIDTH + GAP)
    parts = [
        f'<svg class="flow" xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height:g}" '
        'role="img" aria-label="Signal flow between the components">',
        '<defs><marker id="tip" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" '
        'markerHeight="7" orient="auto"><path d="M0,0 L8,4 L0,8 z"/></marker></defs>',
    ]
    for (source, target), names in sorted(edges.items()):
        parts.append(_arc(place[source], place[target], names, middle))
    for position, name in enumerate(boxes):
        parts.append(_box(position, name, middle))
    return "\n".join([*parts, "</svg>"])


def _place(dae: Dae, variable: Variable) -> str:
    """Component that a variable belongs to; none for parameters and the model's own locals."""
    if variable.role == "parameter":
        return ""
    if "." in variable.name:
        return variable.name.split(".")[0]
    places = {"input": INPUTS, "output": OUTPUTS}
    return places.get(find_causality(dae, variable), "")


def _box(position: int, name: str, middle: float) -> str:
    x = GAP / 2 + position * (BOX_WIDTH + GAP)
    kind = "end" if name in (INPUTS, OUTPUTS) else "part"
    return (
        f'<g class="{kind}"><rect x="{x:g}" y="{middle - BOX_HEIGHT / 2:g}" width="{BOX_WIDTH}" '
        f'height="{BOX_HEIGHT}" rx="6"/><text x="{x + BOX_WIDTH / 2:g}" y="{middle + 5:g}">'
        f"{escape(name)}</text></g>"
    )


def _arc(source: int, target: int, names: frozenset[str], middle: float) -> str:
    """Leaves a box's right third, enters another's left third (mirrored on the way back)."""
    forward = target > source
    side = -1 if forward else 1
    reach = abs(target - source)
    start, end = (0.7, 0.3) if forward else (0.3, 0.7)
    x0, x1 = (
        GAP / 2 + place * (BOX_WIDTH + GAP) + share * BOX_WIDTH
        for place, share in ((source, start), (target, end))
    )
    edge = middle + side * BOX_HEIGHT / 2
    apex = edge + side * reach * RISE * 0.75
    control = edge + side * reach * RISE
    listed = ", ".join(sorted(names))
    label = listed if len(names) <= 2 else f"{len(names)} signals"
    return (
        f'<g class="arc"><title>{escape(listed)}</title><path d="M{x0:g},{edge:g} '
        f'C{x0:g},{control:g} {x1:g},{control:g} {x1:g},{edge:g}" marker-end="url(#tip)"/>'
        f'<text x="{(x0 + x1) / 2:g}" y="{apex - 3 if forward else apex + 11:g}">'
        f"{escape(label)}</text></g>"
    )
