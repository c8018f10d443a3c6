"""The short run that every importer makes, alike to the last bit."""

import math
from dataclasses import dataclass

from fmu_build.check.archive import Fmu, Variable
from fmu_build.check.rules.capabilities import is_true

STEPS = 25

NUDGE = 1e-3
"""Inputs are moved off their start values by this much, so that something happens."""

FLOAT = ("Real", "Float64")


@dataclass(frozen=True)
class Experiment:
    """Start at `start`, `STEPS` communication steps of `step`, all else as the FMU has it.

    inputs: values of inputs, set before initialization and held.
    outputs: names and value references of what is recorded.
    """

    path: str
    identifier: str
    fmi: int
    start: float
    step: float
    steps: int
    inputs: dict[str, float]
    outputs: dict[str, int]
    references: dict[str, int]


def plan_experiment(fmu: Fmu) -> Experiment | None:
    """The run for an FMU; None where it offers no co-simulation."""
    interface = fmu.description.find("CoSimulation")
    if interface is None:
        return None
    scalars = (v for v in fmu.variables if not v.given.keys() & {"alias", "dimensions"})
    floats = [v for v in scalars if v.kind in FLOAT]
    inputs = [v for v in floats if v.causality == "input"]
    variable_step = is_true(interface.get("canHandleVariableCommunicationStepSize"))
    return Experiment(
        path=str(fmu.path.resolve()),
        identifier=interface.get("modelIdentifier", ""),
        fmi=fmu.major,
        start=_start(fmu),
        step=_step(fmu, variable_step),
        steps=STEPS,
        inputs={v.name: _nudged(fmu, v) for v in inputs},
        outputs={v.name: int(v.reference) for v in floats if v.causality == "output"},
        references={v.name: int(v.reference) for v in inputs},
    )


def _default(fmu: Fmu, name: str, otherwise: float) -> float:
    element = fmu.description.find("DefaultExperiment")
    return float((element.attrib if element is not None else {}).get(name, otherwise))


def _start(fmu: Fmu) -> float:
    return _default(fmu, "startTime", 0.0)


def _step(fmu: Fmu, variable: bool) -> float:
    """The default step, or a hundredth of the experiment. Where the FMU takes any step it is
    rounded down to a power of two, so that importers that add up steps get the same times."""
    span = _default(fmu, "stopTime", _start(fmu) + 1.0) - _start(fmu)
    step = _default(fmu, "stepSize", span / 100)
    return float(2.0 ** math.floor(math.log2(step))) if variable else step


def _nudged(fmu: Fmu, variable: Variable) -> float:
    """The start value and a little more, or less at the upper limit."""
    start = float((variable.given.get("start") or "0").split()[0])
    high = float(fmu.attribute(variable, "max") or math.inf)
    low = float(fmu.attribute(variable, "min") or -math.inf)
    for value in (start + NUDGE * max(1.0, abs(start)), start - NUDGE * max(1.0, abs(start))):
        if low <= value <= high:
            return value
    return start
