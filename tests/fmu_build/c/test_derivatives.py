"""Directional derivatives and declared dependencies: against closed forms and each other."""

from collections.abc import Iterator
from pathlib import Path

import fmpy
import numpy as np
import pytest

from fmu_build.equations.dependencies import trace_dependencies
from tests.fmu_build.importer import Importer, list_elements
from tests.fmu_build.modelica import COUNTING, SAMPLED, translated

PARAMETERS = {
    "startAngle": 0.3,
    "resonator.material.dampingAnisotropy": 2e-6,
    "resonator.material.dampingAxis": 0.4,
    "controller.readout.clockError": 1e-5,
    "noise.pickOff": 1e-6,
    "resonator.environment.startTemperature": -10.0,
    "resonator.environment.thermalLag": 2.0,
    "resonator.environment.selfHeating": 5.0,
    "resonator.material.bryanFactorPerKelvin": 9e-4,
    "pickOff.vibrationVariance[1]": 1e-3,
    "pickOff.vibrationVariance[2]": 1e-3,
    "pickOff.vibrationVariance[3]": 1e-3,
    "pickOff.samplingSkew": 9e-4,
    "biasVoltage": 0.9,
    "controller.sweep.restTime": 1e-3,
}
"""`bryanFactorPerKelvin` and `samplingSkew` are near their limits, since what they add is small
beside what it is added to; a vibration that changes gains by more than themselves makes rounding
larger than `MOVE` allows for; at a bias voltage of 1 what follows it vanishes; a longer rest
keeps the sweep from moving anything at once."""

MOVE = 3e-4
"""Relative. The difference errs by its square times the curvature over the slope, and by rounding
in what the equations subtract, which is up to 1e-10 of their result: 1e-6 at most."""


CONVERTER = {
    "controller.readout.quantum": 1e-3,
    "pickOff.resolution": 1e-3,
    "pickOff.fullScale": 1.0,
    "pickOff.converterResolution": 1e-3,
    "pickOff.converterRange": 1.0,
}
"""Zero turns them off: else readings or outputs are steps or clipped, and move with nothing."""

RESTING = {
    "caseTemperature",
    "resonator.environment.referenceTemperature",
    "resonator.environment.thermalLag",
    "resonator.environment.selfHeating",
    "pickOff.feedthrough",
    "pickOff.gainPerGradient",
    "pickOff.gainAgeing",
    "controller.demodulation.filterDelay",
    "controller.startUp.firstTime",
    "controller.startUp.fullTime",
    "noise.angleRandomWalk",
    "noise.rateRandomWalk",
    "noise.biasInstability",
    "noise.virtualRotation",
    "flicker.dampingAnisotropy",
    "flicker.gainMismatch",
    "flicker.phaseError",
}
"""At the start time the resonator has not begun to follow the case; the filter has nothing to hold
on to; forces, the ramp, the age and the difference of the temperatures of case and resonator are
zero, and the others are multiplied by them; noise that has moved nothing yet only decides whether
any is drawn."""

STILL = {"valid", "gyroRate", "noise.isMade", "flicker.isMade"}
"""Outputs that jump at thresholds, or are zero until a second sample."""


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
    """Start angle to pattern angle; decay time T to growth rate 1/T, and amplitude to it by a
    proportional-integral loop with a double pole w, after its first sample: -2 w - w^2 h."""
    gyro.set({"noise.pickOff": 0.0})
    (pattern,) = gyro.derivative(["patternAngle"], ["startAngle"], [1.0])
    assert pattern == pytest.approx(1.0, rel=1e-11)
    decay, pole = "resonator.material.decayTime", "controller.amplitudeLoop.naturalFrequency"
    time, w, h = gyro.get([decay, pole, "samplePeriod"])
    (growth,) = gyro.derivative(["amplitudeForce"], [decay], [2.0])
    assert growth == pytest.approx(-2.0 / time**2, rel=1e-9)
    (loop,) = gyro.derivative(["amplitudeForce"], ["startAmplitude"], [1.0])
    assert loop == pytest.approx(-2 * w - w**2 * h, rel=1e-9)


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
        unknown.variable.name: {n for d in unknown.dependencies for n in list_elements(d)}
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
    knowns = [n for n in _names(gyro, "parameter", "input") if n not in CONVERTER]
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
        expected = {u for u in unknowns if known in declared[u]}
        assert moving <= expected, known
        if known not in RESTING:
            assert moving >= expected - STILL, known
        derivative = np.array(gyro.derivative(unknowns, [known], [1.0]))
        rounding = 1e-15 / MOVE * np.abs(base / value)
        assert np.all(np.abs(derivative - slope) <= 1e-5 * np.abs(slope) + rounding), known
    assert np.array_equal(gyro.get(unknowns), base)


def _moved(gyro: Importer, known: str, value: float, to: float) -> set[str]:
    """Outputs that move with a known."""
    outputs = _names(gyro, "output")
    before = gyro.get(outputs)
    gyro.set({known: to})
    moved = {n for n, a, b in zip(outputs, before, gyro.get(outputs), strict=True) if a != b}
    gyro.set({known: value})
    return moved


@pytest.mark.parametrize("coarse", [False, True])
def test_nothing_moves_undeclared(model_folder: Path, coarse: bool) -> None:
    """On every model, with converters off and on: each known is halved, the seed changed."""
    gyro = Importer(model_folder)
    gyro.enter()
    declared = _declared(gyro)
    knowns = {n: _generic(gyro, n) for n in _names(gyro, "parameter", "input")}
    knowns |= {n: CONVERTER[n] * coarse for n in CONVERTER.keys() & knowns.keys()}
    gyro.set(knowns | {"seed": 4})
    moved = {n: _moved(gyro, n, x, 0.5 * x) for n, x in knowns.items()}
    moved |= {"seed": _moved(gyro, "seed", 4, 5)}
    for known, outputs in moved.items():
        assert outputs <= {n for n in outputs if known in declared[n]}, known
    assert moved["startAngle"]
    assert moved["seed"]
    gyro.free()


def test_derivative_that_is_not_finite_is_an_error(gyro: Importer) -> None:
    seed = [float("inf")]
    text = gyro.refused(lambda: gyro.derivative(["patternAngle"], ["startAngle"], seed))
    assert "does not exist" in text


def test_dependencies_of_a_small_model(tmp_path: Path) -> None:
    """Output y = 2 x + n: no input reaches it between ticks; x starts from b = 3 a."""
    dae = translated(tmp_path / "P", SAMPLED)
    offsets = {v.name: v.offset for v in dae.variables}
    index = [v.name for v in dae.variables].index("y")
    found = trace_dependencies(dae, [index])[index]
    assert found.stepping == ()
    assert found.initial == (offsets["a"],)


def test_dependencies_lead_through_the_first_tick(tmp_path: Path) -> None:
    """n = pre(n) + u from n = c: y = n depends on c and u, though only at the tick."""
    dae = translated(tmp_path / "P", COUNTING)
    offsets = {v.name: v.offset for v in dae.variables}
    index = [v.name for v in dae.variables].index("y")
    found = trace_dependencies(dae, [index])[index]
    assert found.stepping == ()
    assert set(found.initial) == {offsets["c"], offsets["u"]}


def test_dependencies_are_read_by_importers(folder: Path) -> None:
    description = fmpy.read_model_description(str(folder))
    assert all(unknown.dependencies == [] for unknown in description.outputs)
    assert len(description.outputs) == 9
