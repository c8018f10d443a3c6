"""Rules on a system: its description, and that it fits the FMUs in it."""

import tempfile
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path

from fmu_build.check.archive import Fmu, Variable
from fmu_build.check.system.archive import STRUCTURE, Component, Connector, System, list_values
from pyhrg.common.reading.archives import open_archive

Rule = Callable[[System], Iterator[str]]

SCHEMA = "1.0"
"""Version of SSP that FMPy has the schema of."""
TYPES = {
    "Real": ("Real", "Float32", "Float64"),
    "Integer": (
        "Integer",
        "Int8",
        "Int16",
        "Int32",
        "Int64",
        "UInt8",
        "UInt16",
        "UInt32",
        "UInt64",
    ),
    **{name: (name,) for name in ("Boolean", "String", "Enumeration", "Binary")},
}
"""Kinds of variables of an FMU for the types of SSP 1.0; those of 2.0 are the kinds of FMI 3.0."""
SETTABLE = ("parameter", "structuralParameter", "input")


def check_schema(system: System) -> Iterator[str]:
    """SSP 1.0.1, by FMPy; a system that declares another version is not held to it."""
    from fmpy.ssp.ssd import read_ssd, read_ssv

    if system.structure.get("version") != SCHEMA:
        return
    with open_archive(system.path) as archive, tempfile.TemporaryDirectory() as folder:
        try:
            read_ssd(str(system.path))
        except Exception as error:  # FMPy raises what its readers raise
            yield f"{STRUCTURE}: {error}"
        for name in sorted(e.filename for e in archive.entries if e.filename.endswith(".ssv")):
            copy = Path(folder) / "values.ssv"
            copy.write_bytes(archive.read(name))
            try:
                read_ssv(str(copy))
            except Exception as error:
                yield f"{name}: {error}"


def check_sources(system: System) -> Iterator[str]:
    """SSP 1.0.1, 5.3.3."""
    for name, count in Counter(c.name for c in system.components).items():
        if count > 1:
            yield f"{count} components are called {name}"
    for component in system.components:
        if component.source not in system.fmus:
            yield f"{component.name}: there is no {component.source} in the archive"


def check_connectors(system: System) -> Iterator[str]:
    """SSP 1.0.1, 5.3.1: each is a variable of the FMU, of that kind, type and unit."""
    for component, fmu in _list_fmus(system):
        variables = _find_variables(fmu)
        for connector in system.connectors[component.name].values():
            name, variable = f"{component.name}.{connector.name}", variables.get(connector.name)
            if variable is None:
                yield f"{name}: its FMU has no such variable"
                continue
            unit = fmu.attribute(variable, "unit") or "1"
            if connector.kind not in (variable.causality, "inout"):
                yield f"{name}: found kind {connector.kind}, the variable is {variable.causality}"
            if connector.type and not _is_of_type(variable, connector.type):
                yield f"{name}: found type {connector.type}, the variable is {variable.kind}"
            if connector.unit and connector.unit != unit:
                yield f"{name}: found unit {connector.unit}, the variable is in {unit}"


def check_connections(system: System) -> Iterator[str]:
    """SSP 1.0.1, 5.3.2: each leads from a source to a sink, and no sink has two sources."""
    sinks: Counter[str] = Counter()
    for connection in system.connections:
        ends = [_find_end(system, connection.attrib, end) for end in ("start", "end")]
        for name, connector, _ in ends:
            if connector is None:
                yield f"{name} is connected and is no connector"
        (start, source, source_within), (end, sink, sink_within) = ends
        sinks[end] += 1
        if source and not _gives(source, source_within):
            yield f"{start} is of kind {source.kind} and gives nothing to {end}"
        if sink and not _gives(sink, not sink_within):
            yield f"{end} is of kind {sink.kind} and takes nothing from {start}"
    for name, count in sinks.items():
        if count > 1:
            yield f"{name} has {count} sources"


def check_values(system: System) -> Iterator[str]:
    """SSP 1.0.1, 6: parameters can be set, have the type of their value and take it."""
    for component, fmu in _list_fmus(system):
        variables = _find_variables(fmu)
        for place, parameters in component.values.items():
            for name, kind, value in list_values(parameters):
                trouble = _find_trouble(fmu, variables.get(name), kind, value)
                if trouble:
                    yield f"{place}: {name} for {component.name}: {trouble}"


RULES: dict[str, Rule] = {
    f"the description and the parameter sets are those of SSP {SCHEMA} (FMPy)": check_schema,
    "every component has a name of its own and its FMU": check_sources,
    "connectors are variables of their FMU, of that kind, type and unit": check_connectors,
    "connections lead from an output to one input": check_connections,
    "parameter sets name what can be set, with values in range": check_values,
}
"""All rules by what they ask."""


def _list_fmus(system: System) -> Iterator[tuple[Component, Fmu]]:
    for component in system.components:
        if component.source in system.fmus:
            yield component, system.fmus[component.source]


def _find_variables(fmu: Fmu) -> dict[str, Variable]:
    return {variable.name: variable for variable in fmu.variables}


def _is_of_type(variable: Variable, kind: str) -> bool:
    return variable.kind in TYPES.get(kind, (kind,))


def _find_end(
    system: System, given: dict[str, str], end: str
) -> tuple[str, Connector | None, bool]:
    """Name and connector of a connection's end, and whether it is one of an element within."""
    element, name = given.get(f"{end}Element"), given.get(f"{end}Connector", "")
    connector = system.connectors.get(element, {}).get(name)
    return f"{element}.{name}" if element else name, connector, element is not None


def _gives(connector: Connector, within: bool) -> bool:
    """Whether a connection may begin there: outputs of elements, inputs of the system."""
    kinds = ("output", "calculatedParameter") if within else ("input", "parameter")
    return connector.kind in (*kinds, "inout")


def _find_trouble(fmu: Fmu, variable: Variable | None, kind: str, value: str) -> str:
    """Why a variable can't be set to a value; empty where it can."""
    if variable is None:
        return "its FMU has no such variable"
    if variable.causality not in SETTABLE and variable.given.get("initial") != "exact":
        return f"it is of causality {variable.causality} and can't be set"
    if not _is_of_type(variable, kind):
        return f"a value of type {kind}, the variable is {variable.kind}"
    if kind in ("Real", "Integer", "Float64"):
        low, high = (fmu.attribute(variable, limit) for limit in ("min", "max"))
        if low is not None and float(value) < float(low):
            return f"{value} is below its min {low}"
        if high is not None and float(value) > float(high):
            return f"{value} is above its max {high}"
    return ""
