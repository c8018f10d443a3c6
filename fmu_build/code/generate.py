"""The model's C source behind the seam `model.h`: equations, no FMI."""

import re
from collections.abc import Iterable
from functools import partial
from itertools import groupby

from fmu_build.code.accesses import can_replace
from fmu_build.code.emit import Emitter, name_function
from fmu_build.code.functions import write_alternatives, write_function
from fmu_build.equations.case_angle import ANGLE, RATE
from fmu_build.equations.dae import Dae
from fmu_build.equations.sorting import Assignment, Schedule, sort_equations


def generate_source(dae: Dae, integrator: str = "runge_kutta_4") -> str:
    """C source of a model: the functions that `model.h` declares. The integrator is the header
    `c/INTEGRATOR.h` and the function in it that makes a step."""
    plan = sort_equations(dae)
    dae = plan.dae
    derivatives = _derivatives(dae, plan)
    motion = _stores(dae, plan.motion)
    stores = _stores(dae, plan.outputs)
    outputs = ["model_held(v);", *_states(dae, stores), *stores]
    parts = [
        f"/* {dae.model}: generated from its Modelica source. */",
        '#include "arithmetic.h"',
        '#include "model.h"',
        _inputs(dae),
        *_functions(dae, "\n".join(derivatives)),
        *_procedure("void model_parameters(real *v)", _stores(dae, plan.parameters)),
        *_procedure("void model_defaults(real *v)", _defaults(dae)),
        *_procedure("static inline void move(real *v)", [*_states(dae, motion), *motion]),
        *_procedure("void model_start(real *v)", [*_stores(dae, plan.starts), "move(v);"]),
        *_procedure("void model_held(real *v)", _stores(dae, plan.held)),
        *derivatives,
        *_step(dae, integrator),
        *_procedure("void model_tick(real *v, long long index)", _tick(dae, plan)),
        *_procedure("int model_is_finite(const real *v)", _finite(dae, plan)),
        *_procedure("void model_outputs(real *v)", outputs),
    ]
    return "\n".join(parts) + "\n"


def generate_header(dae: Dae) -> str:
    """The model's constants, included by `model.h`."""
    period = f"{dae.sample_period.numerator}.0 / {dae.sample_period.denominator}.0"
    if dae.settable_period is not None:
        period = f"(v)[{dae.settable_period.offset}]"
    offsets = {v.name: v.offset for v in dae.variables}
    lines = [
        f"#define MODEL_VARIABLES {dae.scalar_count}",
        f"#define MODEL_INPUTS {len(_scalars(dae, 'input'))}",
        f"#define MODEL_PERIOD(v) ({period})",
        f"#define MODEL_ANGLE {offsets.get(ANGLE, dae.scalar_count)}",
        f"#define MODEL_RATE {offsets.get(RATE, 0)}",
    ]
    return "\n".join([*lines, ""])


def _inputs(dae: Dae) -> str:
    offsets = "".join(f"{offset}, " for offset in _scalars(dae, "input"))
    return f"const unsigned model_inputs[MODEL_INPUTS + 1] = {{{offsets}0}};"


def _functions(dae: Dae, derivatives: str) -> list[str]:
    """Functions that derivatives call are inlined, so that everything stays in registers."""
    lines: list[str] = []
    for function in dae.functions:
        inner = f" {name_function(function)}(" in derivatives
        lines += write_function(dae, function, "INLINE" if inner else "static inline")
    return lines


def _procedure(declaration: str, lines: Iterable[str]) -> list[str]:
    return [f"{declaration} {{", *(f"  {line}" for line in lines), "}"]


def _defaults(dae: Dae) -> list[str]:
    lines = []
    for variable in dae.variables:
        if variable.role not in ("parameter", "input"):
            continue
        node = variable.start if variable.role == "input" else variable.binding
        for element in range(variable.count):
            value = dae.constant(node, element)
            if value is not None:
                lines.append(f"v[{variable.offset + element}] = {value!r};")
            elif variable.role == "input":
                raise ValueError(f"{variable.name} has no constant start value")
    return lines


def _stores(dae: Dae, assignments: Iterable[Assignment]) -> list[str]:
    """Assignments to the variables' own storage."""
    emitter = Emitter(dae)
    lines = []
    for assignment in assignments:
        expression, target = assignment.expression, assignment.target[1]
        is_conditional = dae.nodes[expression].kind == "conditional"
        if is_conditional and emitter.size(expression) is not None:
            lines += write_alternatives(dae, expression, partial(_branch, dae, target))
        else:
            lines += _write_store(emitter, expression, target)
    return lines


def _write_store(emitter: Emitter, expression: int, target: int) -> list[str]:
    emitter.target = target
    variable = emitter.dae.variables[target]
    if _is_in_place(emitter.dae, expression, target):
        emitter.call_onto(expression, f"(v + {variable.offset})")
        lines = emitter.statements.copy()
        emitter.statements.clear()
        return lines
    is_scalar = emitter.size(expression) is None
    lines = []
    for element in range(variable.count):
        text = emitter.scalar(expression, None if is_scalar else element)
        lines += emitter.statements
        emitter.statements.clear()
        lines.append(f"v[{variable.offset + element}] = {text};")
    return lines


def _is_in_place(dae: Dae, expression: int, target: int) -> bool:
    """Whether an expression is a call of a function that can write its result over the target's
    `pre` value, which it reads."""
    node = dae.nodes[expression]
    if node.kind != "call":
        return False
    function = dae.functions[node.value]
    arguments = [dae.nodes[argument] for argument in node.args]
    given = [i for i, n in enumerate(arguments) if n.kind == "pre" and n.value == target]
    return bool(given) and all(can_replace(dae, function, ordinal) for ordinal in given)


def _branch(dae: Dae, target: int, expression: int) -> list[str]:
    """One of several values of a vector; its `pre` value is in its storage already."""
    node = dae.nodes[expression]
    is_there = node.kind == "pre" and node.value == target
    return (
        [] if is_there else [f"  {line}" for line in _write_store(Emitter(dae), expression, target)]
    )


def _scalars(dae: Dae, role: str) -> list[int]:
    return [v.offset + e for v in dae.variables if v.role == role for e in range(v.count)]


def _states(dae: Dae, lines: Iterable[str]) -> list[str]:
    """C variables of the states that the lines read."""
    used = set(re.findall(r"\bx\d+\b", "\n".join(lines)))
    return [f"const real x{i} = v[{i}];" for i in _scalars(dae, "state") if f"x{i}" in used]


def _derivatives(dae: Dae, plan: Schedule) -> list[str]:
    """Derivatives from states, and from the states that `v` holds: there the motion is known."""
    arguments = "(const real *v, const real *x, real *dx)"
    known = {a.target for a in plan.motion}
    unknown = [a for a in plan.derivatives if a.target not in known]
    lines = [
        f"#define STATES {len(_scalars(dae, 'state'))}",
        *_procedure(f"INLINE void derivatives{arguments}", _derive(dae, plan.derivatives)),
    ]
    if len(unknown) == len(plan.derivatives):
        return [*lines, "#define first_derivatives derivatives"]
    first = _procedure(f"INLINE void first_derivatives{arguments}", _derive(dae, unknown))
    return [*lines, *first]


def _derive(dae: Dae, assignments: Iterable[Assignment]) -> list[str]:
    """Derivatives from states passed by value: everything stays in registers."""
    states = _scalars(dae, "state")
    between = [a.target[1] for a in assignments if a.target[0] == "variable"]
    emitter = Emitter(dae, registers=between)
    lines = [f"const real x{i} = x[{n}];" for n, i in enumerate(states)]
    for assignment in assignments:
        kind, index = assignment.target
        for element in range(dae.variables[index].count):
            text = emitter.scalar(assignment.expression, element)
            lines += emitter.statements
            emitter.statements.clear()
            if kind == "variable":
                lines.append(f"const real {emitter.reference(kind, index, element)} = {text};")
            else:
                position = states.index(dae.variables[index].offset + element)
                lines.append(f"dx[{position}] = {text};")
    return lines


def _step(dae: Dae, integrator: str) -> list[str]:
    """One step of the integrator with inputs and commands held."""
    states = _scalars(dae, "state")
    load = [f"x[{n}] = v[{i}];" for n, i in enumerate(states)]
    store = [f"v[{i}] = x[{n}];" for n, i in enumerate(states)]
    lines = ["real x[STATES];", *load, f"{integrator}(v, x, h);", *store, "move(v);"]
    step = _procedure("void model_step(real *v, double h)", lines)
    return [f'#include "{integrator}.h"', *step]


def _finite(dae: Dae, plan: Schedule) -> list[str]:
    """The states, the samples that act on them until the next step, and the outputs sampled."""
    acting = "\n".join([*_stores(dae, plan.held), *_derivatives(dae, plan)])
    used = {int(i) for i in re.findall(r"\bv\[(\d+)\]", acting)}
    sampled = (dae.variables[a.target[1]] for a in plan.tick)
    outputs = {v.offset for v in sampled if v.causality == "output" and "." not in v.name}
    samples = sorted(used & set(_scalars(dae, "discrete_real")) | outputs)
    terms = [f"0.0 * v[{i}]" for i in (*_scalars(dae, "state"), *samples)]
    # several sums side by side: one long sum would wait for itself
    sums = [" + ".join(terms[first::8]) for first in range(min(8, len(terms)))]
    return [f"return m_is_finite(({') + ('.join(sums)}));"]


def _tick(dae: Dae, plan: Schedule) -> list[str]:
    """One sample; `pre` values are read before anything is written."""
    stores = []
    for every, assignments in groupby(plan.tick, key=lambda a: a.every):
        block = _stores(dae, assignments)
        stores += block if every == 1 else [f"if (index % {every} == 0) {{", *block, "}"]
    names = Emitter(dae)
    used = set(re.findall(r"\bp\d+\b", "\n".join(stores)))
    before = [
        f"const real {name} = v[{variable.offset + element}];"
        for index, variable in enumerate(dae.variables)
        for element in range(variable.count)
        if (name := names.reference("pre", index, element)) in used
    ]
    return ["(void)index;", *_states(dae, stores), *before, *stores]
