"""Rules on the model structure: outputs, initial unknowns and what they depend on."""

import xml.etree.ElementTree as ET
from itertools import pairwise

from fmu_build.check.archive import Fmu, Variable
from fmu_build.check.rules.rule import Findings, rule

PATHS = {
    2: ("ModelStructure/Outputs/Unknown", "ModelStructure/InitialUnknowns/Unknown"),
    3: ("ModelStructure/Output", "ModelStructure/InitialUnknown"),
}


def key(fmu: Fmu) -> str:
    """Attribute that an unknown is named by."""
    return "index" if fmu.major == 2 else "valueReference"


def known_variables(fmu: Fmu) -> dict[str, Variable]:
    """Variables by what unknowns call them: their number from 1, or their value reference."""
    if fmu.major == 2:
        return {str(number): v for number, v in enumerate(fmu.variables, 1)}
    return {v.reference: v for v in fmu.variables if "alias" not in v.given}


def unknowns(fmu: Fmu, position: int) -> list[ET.Element]:
    """Listed outputs (0) or initial unknowns (1)."""
    return fmu.description.findall(PATHS[fmu.major][position])


@rule("every output is listed once in the model structure")
def list_of_outputs(fmu: Fmu) -> Findings:
    """FMI 2.0.4, 2.2.8; FMI 3.0.2, 2.4.8."""
    by_key = known_variables(fmu)
    expected = {k for k, v in by_key.items() if v.causality == "output"}
    listed = [e.get(key(fmu), "") for e in unknowns(fmu, 0)]
    for name in sorted(expected - set(listed)):
        yield f"the output {by_key[name].name} is not listed"
    for name in sorted(set(listed) - expected):
        yield f"{key(fmu)} {name} is listed as an output and is none"
    for name in sorted({n for n in listed if listed.count(n) > 1}):
        yield f"{key(fmu)} {name} is listed more than once"


@rule("initial unknowns are listed in ascending order")
def initial_unknowns_order(fmu: Fmu) -> Findings:
    """FMI 2.0.4, 2.2.8; FMI 3.0 sets no order."""
    if fmu.major == 2:
        numbers = [int(e.get("index", 0)) for e in unknowns(fmu, 1)]
        for before, after in pairwise(numbers):
            if after <= before:
                yield f"index {after} follows index {before}"


@rule("initial unknowns are all that is calculated, and nothing else")
def initial_unknowns_complete(fmu: Fmu) -> Findings:
    """FMI 2.0.4, 2.2.8: outputs and calculated parameters; states and derivatives may be there."""
    by_key = known_variables(fmu)
    free = [
        v
        for v in by_key.values()
        if v.given.get("initial", "calculated") != "exact"
        and v.given.get("variability") != "constant"
    ]
    expected = {id(v) for v in free if v.causality in ("output", "calculatedParameter")}
    if fmu.major == 3:
        expected -= {id(v) for v in by_key.values() if v.kind == "Clock" or "clocks" in v.given}
    listed = {id(by_key[k]) for e in unknowns(fmu, 1) if (k := e.get(key(fmu), "")) in by_key}
    for variable in by_key.values():
        if id(variable) in expected - listed:
            yield f"{variable.name} is calculated at initialization and is not listed"
        if id(variable) in listed and variable.causality in ("parameter", "input", "independent"):
            yield f"{variable.name} is listed and is a known: {variable.causality}"


@rule("dependencies name variables, and as many kinds as there are dependencies")
def dependencies(fmu: Fmu) -> Findings:
    """FMI 2.0.4, 2.2.8; FMI 3.0.2, 2.4.8."""
    by_key = known_variables(fmu)
    for element in [*unknowns(fmu, 0), *unknowns(fmu, 1)]:
        own = element.get(key(fmu), "")
        where = f"the unknown {by_key[own].name if own in by_key else own}"
        named = element.get("dependencies", "").split()
        for name in named:
            if name not in by_key:
                yield f"{where} depends on {key(fmu)} {name}, which no variable has"
            elif name == own:
                yield f"{where} depends on itself"
        kinds = element.get("dependenciesKind")
        if kinds is not None and len(kinds.split()) != len(named):
            yield f"{where} has {len(named)} dependencies and {len(kinds.split())} kinds"
