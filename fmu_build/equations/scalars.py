"""Scalar variables of a model as both FMI standards describe them."""

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import groupby

from fmu_build.equations.dae import Dae, Variable
from fmu_build.equations.dependencies import trace_dependencies
from fmu_build.equations.modelica import RealType, find_type, read_types
from fmu_build.equations.sorting import find_references
from pyhrg.common.errors import HrgError

SWITCHES = ("Units.Switch", "Inputs.Switch", "Outputs.Switch")
"""The library's type of a real variable that is 1 or 0, and its connectors: a Boolean in FMI 3."""


MAP = re.compile(r"((?:.*\.)?controller\.(?:biasMap|scaleFactorMap))\.\w+")
"""Names of the coefficients of a calibrated map, which FMI 3 has as one array."""


@dataclass(frozen=True)
class Scalar:
    """One scalar variable, or an array of FMI 3.

    Attributes:
        array: name of the array that it is an element of in FMI 3; empty where it is in none.
        elements: names of its scalars.
        kind: "real", "integer" or "switch", a real variable that is 1 or 0.
        attributes: description, quantity, unit, displayUnit, min, max, nominal and start: those
            that apply.
    """

    name: str
    reference: int
    variable: int
    causality: str
    variability: str
    kind: str
    declared: RealType | None
    attributes: dict[str, str]
    elements: tuple[str, ...]
    array: str = ""

    @property
    def count(self) -> int:
        """Number of its scalars."""
        return len(self.elements)


@lru_cache(maxsize=2)
def list_variables(dae: Dae, fmi: int) -> tuple[Scalar, ...]:
    """All variables of a model in a version of the standard, in the order of their value
    references. In FMI 3, parameters that are vectors, and each map, are arrays."""
    listed = list_scalars(dae)
    return listed if fmi == 2 else tuple(_join_arrays(listed))


@lru_cache(maxsize=1)
def list_scalars(dae: Dae) -> tuple[Scalar, ...]:
    """All scalars of a model, in the order of their value references."""
    return tuple(_scalars(dae))


def _scalars(dae: Dae) -> Iterator[Scalar]:
    types = read_types(variable.file for variable in dae.variables)
    tunable = _list_tunable(dae)
    for index, variable in enumerate(dae.variables):
        causality = find_causality(dae, variable)
        declared = _find_declared_type(variable, types)
        variability = "discrete" if variable.role == "discrete_real" else "continuous"
        if variable.role == "parameter":
            variability = "tunable" if index in tunable else "fixed"
        texts = {"description": variable.description, "unit": variable.unit}
        if declared is not None:
            texts |= {"quantity": declared.quantity, "displayUnit": declared.display_unit}
        texts = {name: text for name, text in texts.items() if text}
        for element in range(variable.count):
            name = variable.element_name(element)
            yield Scalar(
                name=name,
                reference=variable.offset + element,
                variable=index,
                causality=causality,
                variability=variability,
                kind=find_kind(variable),
                declared=declared,
                attributes=texts | _numbers(dae, variable, element, causality),
                elements=(name,),
                array=_find_array(variable) if causality == "parameter" else "",
            )


def _join_arrays(listed: Iterable[Scalar]) -> Iterator[Scalar]:
    """Arrays in place of their elements, where these are alike but for start and meaning."""
    for name, group in groupby(listed, lambda scalar: scalar.array or scalar.name):
        first, *others = members = list(group)
        if not first.array or any(_common(other) != _common(first) for other in others):
            yield from members
            continue
        texts = {m.name.rpartition(".")[2]: m.attributes.get("description", "") for m in members}
        alike = len(set(texts.values())) == 1
        meaning = "; ".join(f"{key}: {text}" for key, text in texts.items())
        attributes = first.attributes | {
            "description": next(iter(texts.values())) if alike else meaning,
            "start": " ".join(member.attributes["start"] for member in members),
        }
        elements = tuple(member.name for member in members)
        yield replace(first, name=name, elements=elements, attributes=attributes)


def _common(scalar: Scalar) -> object:
    attributes = {k: v for k, v in scalar.attributes.items() if k not in ("start", "description")}
    return attributes, scalar.kind, scalar.variability, scalar.declared


def _find_array(variable: Variable) -> str:
    if variable.size is not None:
        return variable.name
    element = MAP.fullmatch(variable.name)
    return f"{element[1]}.coefficients" if element else ""


def find_causality(dae: Dae, variable: Variable) -> str:
    """Causality in the sense of FMI."""
    if variable.role == "parameter":
        settable = variable.settable and dae.is_constant(variable.binding, variable.count)
        return "parameter" if settable else "calculatedParameter"
    return variable.causality if "." not in variable.name else "local"


def find_kind(variable: Variable) -> str:
    """Kind of a variable's scalars."""
    if variable.scalar == "integer":
        return "integer"
    return "switch" if variable.type_name.endswith(SWITCHES) else "real"


def is_tunable(dae: Dae, variable: Variable) -> bool:
    """Whether a parameter can be set while the simulation runs."""
    return find_causality(dae, variable) == "parameter" and variable.tunable


def _list_tunable(dae: Dae) -> set[int]:
    """Indices of the parameters that can be set then, and of those computed from them.

    Raises:
        HrgError: a start value is made of one, which would do nothing in a run.
    """
    own = {i for i, v in enumerate(dae.variables) if is_tunable(dae, v)}
    offsets = {dae.variables[i].offset for i in own}
    calculated = {
        i for i, v in enumerate(dae.variables) if find_causality(dae, v) == "calculatedParameter"
    }
    depends = trace_dependencies(dae, calculated)
    tunable = own | {i for i in calculated if offsets & set(depends[i].initial)}
    targets = {("variable", i) for i in tunable}
    for variable in (v for v in dae.variables if v.role != "parameter"):
        if variable.start is not None and targets & set(find_references(dae, variable.start)):
            raise HrgError(
                f"{dae.model}: {variable.name}: its start value is made of a parameter with "
                "annotation(Evaluate = false); expected one that is fixed"
            )
    return tunable


def _find_declared_type(variable: Variable, types: Mapping[str, RealType]) -> RealType | None:
    """The library's type of a variable, unless its declaration gives it another unit."""
    declared = find_type(variable.type_name, types)
    return declared if declared and declared.unit == variable.unit else None


def _numbers(dae: Dae, variable: Variable, element: int, causality: str) -> dict[str, str]:
    whole = variable.scalar == "integer"
    nodes = {"min": variable.minimum, "max": variable.maximum, "nominal": variable.nominal}
    if causality == "parameter":
        nodes["start"] = variable.binding
    elif causality == "input":
        nodes["start"] = variable.start
    values = {name: dae.constant(node, element) for name, node in nodes.items()}
    if "start" in nodes and values["start"] is None:
        values["start"] = 0.0
    return {
        name: str(int(value)) if whole else repr(value)
        for name, value in values.items()
        if value is not None
    }
