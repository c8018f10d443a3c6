"""What the description says an output depends on is all that moves it."""

import fmpy
import pytest
from fmpy.fmi2 import FMU2Slave

from fmu_build.bundle import built_fmu

PATH = str(built_fmu())
DESCRIPTION = fmpy.read_model_description(PATH)
KNOWNS = [v for v in DESCRIPTION.modelVariables if v.causality in ("parameter", "input")]
OUTPUTS = [v for v in DESCRIPTION.modelVariables if v.causality == "output"]


@pytest.fixture
def slave() -> FMU2Slave:
    fmu = FMU2Slave(
        guid=DESCRIPTION.guid,
        unzipDirectory=fmpy.extract(PATH),
        modelIdentifier=DESCRIPTION.coSimulation.modelIdentifier,
    )
    fmu.instantiate()
    return fmu


def moved(slave: FMU2Slave, known: fmpy.model_description.ModelVariable) -> set[str]:
    """Outputs that change when a known does; nothing happens in between."""
    references = [v.valueReference for v in OUTPUTS]
    before = slave.getReal(references)
    if known.type == "Integer":
        value = int(known.start)
        slave.setInteger([known.valueReference], [value + 1 if value < int(known.max) else 0])
    else:
        start, top = float(known.start), float(known.max) if known.max else 1e9
        slave.setReal([known.valueReference], [start + min(1e-3, (top - start) / 2) or start / 2])
    after = slave.getReal(references)
    return {v.name for v, a, b in zip(OUTPUTS, before, after, strict=True) if a != b}


def declared(unknowns: list[fmpy.model_description.Unknown], known: str) -> set[str]:
    return {u.variable.name for u in unknowns if known in {d.name for d in u.dependencies}}


def test_at_initialization(slave: FMU2Slave) -> None:
    slave.setupExperiment()
    slave.enterInitializationMode()
    found = {known.name: moved(slave, known) for known in KNOWNS}
    claimed = {k.name: declared(DESCRIPTION.initialUnknowns, k.name) for k in KNOWNS}
    outputs = {v.name for v in OUTPUTS}
    assert any(found.values())
    for name, names in found.items():
        assert names <= claimed[name] & outputs, name


def test_at_communication_points(slave: FMU2Slave) -> None:
    slave.setupExperiment()
    slave.enterInitializationMode()
    slave.exitInitializationMode()
    slave.doStep(0.0, 0.05)
    for known in KNOWNS:
        if known.causality == "input":
            assert moved(slave, known) <= declared(DESCRIPTION.outputs, known.name), known.name
