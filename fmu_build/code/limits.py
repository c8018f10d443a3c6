"""The table `limits.c` of the variables' limits, by which the FMU checks calls."""

from fmu_build.equations.dae import Dae
from fmu_build.equations.scalars import find_causality, find_kind, is_tunable, list_variables
from fmu_build.equations.sorting import sort_equations

KINDS = {
    2: {"real": "REAL", "integer": "INTEGER", "switch": "REAL"},
    3: {"real": "REAL", "integer": "INTEGER", "switch": "BOOLEAN"},
}
"""Kinds of variables by the names of `c/limits.h`, in each standard."""


def generate_limits(dae: Dae, token: str, fmi: int) -> str:
    """C source of the table that `limits.h` declares, for a version of the standard; `token` is the
    model's mark."""
    lines = ['#include "limits.h"', f'const char *const model_token = "{token}";']
    lines.append("const Limits limits[] = {")
    settables = {"parameter": "SET_PARAMETER", "input": "SET_INPUT"}
    counts = {variable.reference: variable.count for variable in list_variables(dae, fmi)}
    plan = sort_equations(dae)
    on_demand = {a.target[1] for a in (*plan.held, *plan.outputs)}
    for index, variable in enumerate(dae.variables):
        settable = settables.get(find_causality(dae, variable), "SET_NEVER")
        settable = "SET_TUNABLE" if is_tunable(dae, variable) else settable
        kind = KINDS[fmi][find_kind(variable)]
        continuous = int(index in on_demand)
        for element in range(variable.count):
            low = dae.constant(variable.minimum, element)
            high = dae.constant(variable.maximum, element)
            least = "-UNLIMITED" if low is None else repr(low)
            most = "UNLIMITED" if high is None else repr(high)
            name = _quote(variable.element_name(element))
            count = counts.get(variable.offset + element, 0)
            head = f"{name}, {count}, {settable}, {kind}, {continuous}"
            lines.append(f"  {{{head}, {least}, {most}}},")
    return "\n".join([*lines, "};", ""])


def _quote(name: str) -> str:
    """A name as a C string: one in Modelica's quotes may hold any character."""
    escaped = name.replace("\\", r"\\").replace('"', r"\"")
    return f'"{escaped}"'
