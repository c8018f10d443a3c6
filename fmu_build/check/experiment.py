"""The short run that every importer makes, the same to the last bit, and its recording."""

import math
from collections.abc import Iterator
from dataclasses import dataclass

from fmu_build.binaries.platforms import PLATFORMS, BuildError, find_host_platform
from fmu_build.check.archive import Fmu, Variable
from fmu_build.check.rules.capabilities import is_true
from pyhrg.common.errors import HrgError

STEPS = 25

NUDGE = 1e-3
"""Inputs are moved off their start values by this much, so that something happens."""

FLOAT = ("Real", "Float64")

Trace = dict[str, list[float]]
"""Recorded outputs by name, one value a communication point after the start."""


@dataclass(frozen=True)
class Run:
    """Start at `start`, `steps` communication steps of `step`, s, all else as the file has it.

    Attributes:
        standards: what an importer must know.
        outputs: names and value references of what is recorded.
    """

    path: str
    standards: tuple[str, ...]
    start: float
    step: float
    steps: int
    outputs: dict[str, int]


@dataclass(frozen=True)
class Experiment(Run):
    """Run of an FMU.

    Attributes:
        inputs: values of inputs, set before initialization and held.
        references: value references of these inputs.
    """

    identifier: str
    inputs: dict[str, float]
    references: dict[str, int]


@dataclass(frozen=True)
class Recording:
    """Recording of an importer; `remark` says what the importer needed for it."""

    trace: Trace
    remark: str = ""


class FailedError(HrgError):
    """The importer refused the FMU, failed or crashed."""


def read_last_line(text: str) -> str:
    """What a program said last: where it failed, the reason."""
    lines = [line for line in text.splitlines() if line.strip()]
    return lines[-1] if lines else "it ended without a word"


def plan_experiment(fmu: Fmu) -> Experiment | None:
    """The run for an FMU; None where it offers no co-simulation."""
    interface = fmu.description.find("CoSimulation")
    if interface is None:
        return None
    inputs = _list_floats(fmu, "input")
    variable_step = is_true(interface.get("canHandleVariableCommunicationStepSize"))
    return Experiment(
        path=str(fmu.path.resolve()),
        identifier=interface.get("modelIdentifier", ""),
        standards=(name_standard(fmu),),
        start=_default(fmu, "startTime", 0.0),
        step=_step(fmu, variable_step),
        steps=STEPS,
        inputs={v.name: _nudge_start(fmu, v) for v in inputs},
        outputs=list_outputs(fmu),
        references={v.name: int(v.reference) for v in inputs},
    )


def name_standard(fmu: Fmu) -> str:
    """The standard of an FMU in words."""
    return f"FMI {fmu.major}.0"


def list_outputs(fmu: Fmu) -> dict[str, int]:
    """Value references of the real scalar outputs by name."""
    return {v.name: int(v.reference) for v in _list_floats(fmu, "output")}


def _list_floats(fmu: Fmu, causality: str) -> list[Variable]:
    scalars = (v for v in fmu.variables if not v.given.keys() & {"alias", "dimensions"})
    return [v for v in scalars if v.kind in FLOAT and v.causality == causality]


def find_missing_binary(fmu: Fmu, planned: Experiment) -> Iterator[str]:
    """Says so where there is none; nothing on a machine whose folder we don't know."""
    try:
        platform = PLATFORMS[find_host_platform()]
    except BuildError:
        return
    folder = (platform.fmi2_folder if fmu.major == 2 else None) or platform.name
    library = f"binaries/{folder}/{planned.identifier}{platform.suffix}"
    if library not in fmu.names:
        yield f"no binary for this machine: {library} is missing"


def _default(fmu: Fmu, name: str, otherwise: float) -> float:
    element = fmu.description.find("DefaultExperiment")
    return float((element.attrib if element is not None else {}).get(name, otherwise))


def _step(fmu: Fmu, variable: bool) -> float:
    """The default step, or a hundredth of the experiment. Where the FMU takes any step it is
    rounded down to a power of two, so that importers that add up steps get the same times; 2^-9 s
    at least, a whole number of the nanoseconds that libcosim counts."""
    start = _default(fmu, "startTime", 0.0)
    span = _default(fmu, "stopTime", start + 1.0) - start
    step = _default(fmu, "stepSize", span / 100)
    return float(2.0 ** max(-9, math.floor(math.log2(step)))) if variable else step


def _nudge_start(fmu: Fmu, variable: Variable) -> float:
    """The start value and a little more, or less at the upper limit."""
    start = float((variable.given.get("start") or "0").split()[0])
    high = float(fmu.attribute(variable, "max") or math.inf)
    low = float(fmu.attribute(variable, "min") or -math.inf)
    for value in (start + NUDGE * max(1.0, abs(start)), start - NUDGE * max(1.0, abs(start))):
        if low <= value <= high:
            return value
    return start
