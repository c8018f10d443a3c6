"""Rules on the capabilities that an FMU declares."""

import math

from fmu_build.check.archive import Fmu
from fmu_build.check.rules.rule import Findings, rule

STATE_FLAGS = {
    2: ("canSerializeFMUstate", "canGetAndSetFMUstate"),
    3: ("canSerializeFMUState", "canGetAndSetFMUState"),
}


def is_true(text: str | None) -> bool:
    """A boolean of XML Schema."""
    return text in ("true", "1")


@rule("the FMU offers an interface")
def offers_an_interface(fmu: Fmu) -> Findings:
    """FMI 2.0.4, 2.2.1."""
    if not fmu.interfaces:
        yield "neither model exchange nor co-simulation nor scheduled execution is offered"


@rule("states that are serialized can be got and set")
def serialization(fmu: Fmu) -> Findings:
    """FMI 2.0.4, 3.3.1; FMI 3.0.2, 2.4.5."""
    serialize, get_and_set = STATE_FLAGS[fmu.major]
    for interface in fmu.interfaces:
        if is_true(interface.get(serialize)) and not is_true(interface.get(get_and_set)):
            yield f"{interface.tag} has {serialize} without {get_and_set}"


@rule("the default experiment can be run")
def default_experiment(fmu: Fmu) -> Findings:
    """FMI 2.0.4, 2.2.5: stop after start, a step above zero, no longer than the experiment."""
    element = fmu.description.find("DefaultExperiment")
    given = {} if element is None else element.attrib
    start = float(given.get("startTime", 0))
    stop = float(given.get("stopTime", math.inf))
    if not stop > start:
        yield f"stopTime {stop!r} is not after startTime {start!r}"
    for name in ("stepSize", "tolerance"):
        if name in given and not 0 < float(given[name]) < math.inf:
            yield f"{name} is {given[name]}, expected a number above 0"


@rule("a fixed internal step is above zero")
def internal_step(fmu: Fmu) -> Findings:
    """FMI 3.0.2, 4.4."""
    for interface in fmu.interfaces:
        text = interface.get("fixedInternalStepSize")
        if text is not None and not float(text) > 0:
            yield f"fixedInternalStepSize is {text}, expected a number above 0"
