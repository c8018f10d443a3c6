"""Rules on variables."""

import re
from collections import defaultdict
from math import prod

from fmu_build.check.archive import Fmu, Variable
from fmu_build.check.rules.rule import Findings, rule

NUMBERS = ("Real", "Integer", "Enumeration", "Float", "Int", "UInt")

PLAIN = r"[A-Za-z_]\w*"
QUOTED = r"'(?:[\w!#$%&()*+,\-./:;<>=?@\[\]^{}|~ ]|\\['\"?\\abfnrtv])+'"
PART = rf"(?:{PLAIN}|{QUOTED})(?:\[\d+(?:,\d+)*\])?"
PATH = rf"{PART}(?:\.{PART})*"
STRUCTURED = re.compile(rf"{PATH}|der\({PATH}(?:,\d+)?\)", re.ASCII)
FLAT = re.compile(r"[^\r\n\t]+")


def is_number(variable: Variable) -> bool:
    """Whether start, min and max are numbers."""
    return variable.kind.startswith(NUMBERS)


@rule("variable names keep the naming convention")
def names(fmu: Fmu) -> Findings:
    """FMI 2.0.4, 2.2.9; FMI 3.0.2, "Variable Naming Conventions". FMPy's parser of names takes
    seconds for a gyro."""
    convention = fmu.description.get("variableNamingConvention", "flat")
    allowed = STRUCTURED if convention == "structured" else FLAT
    for variable in fmu.variables:
        if not allowed.fullmatch(variable.name):
            yield f"{variable.name!r} is no {convention} name"


@rule("value references are shared by aliases only")
def references(fmu: Fmu) -> Findings:
    """FMI 3.0.2, 2.4.7: unique over all types. FMI 2.0.4, 2.2.7: aliases are of one type and
    unit, and at most one of them can be set."""
    shared = defaultdict(list)
    for variable in fmu.variables:
        if "alias" not in variable.given:
            shared[variable.reference].append(variable)
    for reference, variables in shared.items():
        names = ", ".join(v.name for v in variables)
        kinds = {v.kind for v in variables}
        if len(variables) > 1 and (fmu.major == 3 or len(kinds) > 1):
            listed = ", ".join(sorted(kinds))
            yield f"{names} ({listed}) share the value reference {reference}"
        elif len({fmu.attribute(v, "unit") for v in variables}) > 1:
            yield f"{names} share the value reference {reference} and differ in unit"
        elif sum("start" in v.given for v in variables) > 1:
            yield f"{names} share the value reference {reference}, and more than one has a start"


@rule("start values lie between min and max")
def starts_within_limits(fmu: Fmu) -> Findings:
    """FMI 2.0.4, 2.2.7; limits may be those of the declared type."""
    for variable in filter(is_number, fmu.variables):
        low, high = (fmu.attribute(variable, key) for key in ("min", "max"))
        for text in variable.given.get("start", "").split():
            if low is not None and float(text) < float(low):
                yield f"{variable.name} starts at {text}, below its min {low}"
            if high is not None and float(text) > float(high):
                yield f"{variable.name} starts at {text}, above its max {high}"


@rule("an array has a start value for each element, or one for all")
def starts_of_arrays(fmu: Fmu) -> Findings:
    """FMI 3.0.2, 2.4.7; a scalar has one."""
    for variable in filter(is_number, fmu.variables):
        sizes = variable.given.get("dimensions", "").split()
        starts = len(variable.given.get("start", "0").split())
        if not all(text.isdigit() and int(text) > 0 for text in sizes):
            yield f"{variable.name} has the dimensions {', '.join(sizes)}"
        elif starts not in (1, prod(map(int, sizes))):
            shape = " x ".join(sizes) or "1"
            yield f"{variable.name} has {starts} start values for {shape} elements"


@rule("min lies below max")
def limits_in_order(fmu: Fmu) -> Findings:
    """FMI 2.0.4, 2.2.3."""
    for variable in filter(is_number, fmu.variables):
        low, high = (fmu.attribute(variable, key) for key in ("min", "max"))
        if low is not None and high is not None and float(low) > float(high):
            yield f"{variable.name} has the min {low} above the max {high}"


@rule("nominal values are above zero")
def nominals(fmu: Fmu) -> Findings:
    """FMI 2.0.4, 2.2.3."""
    for variable in filter(is_number, fmu.variables):
        nominal = fmu.attribute(variable, "nominal")
        if nominal is not None and not float(nominal) > 0:
            yield f"{variable.name} has the nominal value {nominal}"
