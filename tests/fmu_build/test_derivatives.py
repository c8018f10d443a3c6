"""Directional derivatives and declared dependencies: against closed forms and each other."""

from collections.abc import Iterator
from pathlib import Path

import fmpy
import numpy as np
import pytest

from fmu_build.dependencies import Graph
from tests.fmu_build.importer import Importer
from tests.fmu_build.modelica import SAMPLED, translated

PARAMETERS = {
    "startAngle": 0.3,
    "resonator.material.dampingAnisotropy": 2e-6,
    "resonator.material.dampingAxis": 0.4,
    "controller.readout.clockError": 1e-5,
    "noise.pickOff": 1e-12,
}

MOVE = 1e-4
"""Relative. The difference errs by its square times the curvature over the slope, and by rounding
in what the equations subtract, which is up to 1e-10 of their result: 1e-6 each."""


@pytest.fixture
def gyro(folder: Path) -> Iterator[Importer]:
    importer = Importer(folder)
    importer.enter()
    importer.set(PARAMETERS)
    yield importer
    importer.free()


def _names(importer: Importer, *causalities: str, whole: bool = False) -> list[str]:
    kinds = ("Integer", "Int32") if whole else ("Real", "Float64")
    return [
        n for n, v in importer.variables.items() if v.causality in causalities and v.type in kinds
    ]


def test_closed_forms(gyro: Importer) -> None:
    """Start angle to pattern angle, and decay time T to growth rate 1/T."""
    (pattern,) = gyro.derivative(["patternAngle"], ["startAngle"], [1.0])
    assert pattern == pytest.approx(1.0, rel=1e-11)
    decay = "resonator.material.decayTime"
    (time,) = gyro.get([decay])
    (growth,) = gyro.derivative(["amplitudeForce"], [decay], [2.0])
    assert growth == pytest.approx(-2.0 / time**2, rel=1e-9)


def test_seeds_add_up_and_the_adjoint_is_the_transpose(gyro: Importer) -> None:
    knowns = ["startAngle", "resonator.material.frequency", "controller.readout.clockError"]
    unknowns = ["patternAngle", "frequencyOffset", "amplitudeForce"]
    columns = np.transpose([gyro.derivative(unknowns, [k], [1.0]) for k in knowns])
    seed = np.array([1.0, -2.0, 0.5])
    assert np.array_equal(gyro.derivative(unknowns, knowns, seed), columns @ seed)
    if gyro.fmi == 3:
        references = gyro.references(unknowns), gyro.references(knowns)
        adjoint = gyro.slave.getAdjointDerivative(*references, list(seed))
        assert list(adjoint) == pytest.approx(list(columns.T @ seed), rel=1e-15)


def test_sampled_outputs_do_not_follow_inputs_between_ticks(gyro: Importer) -> None:
    gyro.slave.exitInitializationMode()
    gyro.slave.doStep(0.0, 0.1)
    before = gyro.save()
    outputs, inputs = _names(gyro, "output"), _names(gyro, "input")
    for name in inputs:
        assert gyro.derivative(outputs, [name], [1.0]) == [0.0] * len(outputs)
    assert gyro.save() == before
    assert "can't" not in gyro.refused(
        lambda: gyro.derivative(["gyroAngle"], ["startAngle"], [1.0])
    )
    assert "is set, not computed" in gyro.refused(
        lambda: gyro.derivative(["angularRate"], ["angularRate"], [1.0])
    )


def _declared(importer: Importer) -> dict[str, set[str]]:
    return {
        unknown.variable.name: {d.name for d in unknown.dependencies}
        for unknown in importer.description.initialUnknowns
    }


def _generic(importer: Importer, name: str) -> float:
    """A value inside its range, at which nothing vanishes."""
    variable = importer.variables[name]
    (value,) = importer.get([name])
    low, high = float(variable.min or -1.0), float(variable.max or 1.0)
    value = value or 0.3 * min(high, 1.0) + 0.1 * max(low, -1.0)
    return 0.9 * value if value == high else value


def test_unknowns_move_with_what_is_declared(gyro: Importer) -> None:
    """Each known is moved by hand, by a little, at generic values of all: what moves with it is
    declared to, what is declared to moves, and moves as its derivative says."""
    declared = _declared(gyro)
    knowns = _names(gyro, "parameter", "input")
    unknowns = [n for n in _names(gyro, "output", "calculatedParameter") if n in declared]
    gyro.set({name: _generic(gyro, name) for name in knowns})
    base = np.array(gyro.get(unknowns))
    for known in knowns:
        (value,) = gyro.get([known])
        ends = []
        for end in (value * (1 - MOVE), value * (1 + MOVE)):
            gyro.set({known: end})
            ends.append(np.array(gyro.get(unknowns)))
        slope = (ends[1] - ends[0]) / (2 * MOVE * value)
        gyro.set({known: value})
        moving = {u for u, s in zip(unknowns, slope, strict=True) if s != 0.0}
        assert moving == {u for u in unknowns if known in declared[u]}, known
        derivative = np.array(gyro.derivative(unknowns, [known], [1.0]))
        rounding = 1e-15 / MOVE * np.abs(base / value)
        assert np.all(np.abs(derivative - slope) <= 1e-5 * np.abs(slope) + rounding), known
    assert np.array_equal(gyro.get(unknowns), base)


def test_singular_derivative_is_an_error(gyro: Importer) -> None:
    """A noise density enters by its root, which has no slope at zero."""
    gyro.set({"noise.pickOff": 0.0})
    unknown = next(n for n, d in _declared(gyro).items() if "noise.pickOff" in d)
    text = gyro.refused(lambda: gyro.derivative([unknown], ["noise.pickOff"], [1.0]))
    assert "does not exist" in text


def test_dependencies_of_a_small_model(tmp_path: Path) -> None:
    """Output y = 2 x + n: no input reaches it between ticks; its start follows from b = 3 a."""
    dae = translated(tmp_path / "P", SAMPLED)
    offsets = {v.name: v.offset for v in dae.variables}
    index = [v.name for v in dae.variables].index("y")
    found = Graph(dae).of(index)
    assert found.stepping == ()
    assert found.initial == (offsets["a"],)


def test_dependencies_are_read_by_importers(folder: Path) -> None:
    description = fmpy.read_model_description(str(folder))
    assert all(unknown.dependencies == [] for unknown in description.outputs)
    assert len(description.outputs) == 9
