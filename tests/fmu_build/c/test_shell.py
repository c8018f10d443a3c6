"""The FMI shell: errors that explain themselves, state that restores, steps that don't matter."""

import ctypes
from collections.abc import Iterator

import pytest
from fmpy.fmi2 import FMU2Slave, fmi2CallbackFunctions, fmi2CallbackLoggerTYPE

from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroError, GyroFmu
from tests.driving import advance

FMI2_DISCARD = 2
LAST_SUCCESSFUL_TIME, TERMINATED = 2, 3


@pytest.mark.parametrize(
    ("name", "value", "message"),
    [
        (
            "resonator.material.decayTime",
            -3.0,
            r"material\.decayTime = -3 is outside its range from 1 to 100000",
        ),
        ("resonator.material.frequencySplit", float("nan"), r"frequencySplit = nan is outside"),
        ("resonator.material.ownCos", 1.0, r"material\.ownCos can't be set at all"),
        ("noSuchThing", 1.0, "no variable noSuchThing"),
    ],
)
def test_refused_value_is_named_with_its_range(
    fmu: GyroFmu, name: str, value: float, message: str
) -> None:
    with pytest.raises(GyroError, match=message):
        fmu.power_on({name: value}, seed=0, start_angle=0.0)


def test_refused_seed_is_named_with_its_range(fmu: GyroFmu) -> None:
    with pytest.raises(GyroError, match=r"seed = -1 is outside its range from 0 to 2147483647$"):
        fmu.power_on({}, seed=-1, start_angle=0.0)


def test_parameter_is_refused_after_initialization(fmu: GyroFmu) -> None:
    with (
        fmu.power_on({}, seed=0, start_angle=0.0) as gyro,
        pytest.raises(GyroError, match="decayTime can't be set after initialization"),
    ):
        gyro.command("resonator.material.decayTime", 100.0)


def test_input_that_makes_no_sense_stops_the_drive(fmu: GyroFmu) -> None:
    with (
        fmu.power_on({}, seed=0, start_angle=0.0) as gyro,
        pytest.raises(GyroError, match=r"angularRate = 1000 is outside its range"),
    ):
        advance(gyro, 1000.0, 0.01)


@pytest.mark.parametrize("step", [0.002, 0.01, 0.1, 1.0])
def test_communication_step_does_not_matter(fmu: GyroFmu, step: float) -> None:
    def run(communication_step: float) -> list[float]:
        with fmu.power_on(TYPICAL.fmu_parameters(), seed=7, start_angle=0.3) as gyro:
            for _ in range(round(2.0 / communication_step)):
                advance(gyro, 0.05, communication_step)
            return [gyro.read(name) for name in ("gyroAngle", "amplitude", "quadratureForce")]

    assert run(step) == run(0.001)


def _silent() -> fmi2CallbackFunctions:
    callbacks = fmi2CallbackFunctions()
    callbacks.logger = fmi2CallbackLoggerTYPE(lambda *args: None)
    return callbacks


@pytest.fixture
def slave(fmu: GyroFmu) -> Iterator[FMU2Slave]:
    instance = FMU2Slave(
        guid=fmu.description.guid,
        unzipDirectory=str(fmu.folder),
        modelIdentifier="HRG",
        instanceName="saved",
    )
    instance.instantiate(callbacks=_silent())
    instance.setupExperiment(startTime=0.0)
    instance.enterInitializationMode()
    instance.setInteger([fmu.references["seed"]], [11])
    instance.setReal([fmu.references["noise.angleRandomWalk"]], [3e-8])
    instance.exitInitializationMode()
    yield instance
    instance.freeInstance()


def test_saved_state_restores_bit_for_bit(fmu: GyroFmu, slave: FMU2Slave) -> None:
    every = [r for n, r in fmu.references.items() if fmu.kinds[n] == "Real"]
    slave.doStep(0.0, 0.5)
    state = slave.getFMUState()
    saved = slave.serializeFMUState(state)
    slave.doStep(0.5, 0.25)
    expected = slave.getReal(every)
    slave.setFMUState(slave.deSerializeFMUstate(saved))
    slave.doStep(0.5, 0.25)
    assert slave.getReal(every) == expected
    slave.freeFMUState(state)


def test_reset_is_a_fresh_start(fmu: GyroFmu, slave: FMU2Slave) -> None:
    """After other parameters, other noise and some time: the same as an instance never used."""

    def run(instance: FMU2Slave) -> list[float]:
        instance.setupExperiment(startTime=0.0)
        instance.enterInitializationMode()
        instance.setReal([fmu.references["noise.pickOff"]], [1e-6])
        instance.exitInitializationMode()
        instance.doStep(0.0, 0.5)
        return list(instance.getReal([fmu.references["gyroAngle"]]))

    slave.doStep(0.0, 0.5)
    slave.reset()
    again = run(slave)
    fresh = FMU2Slave(
        guid=fmu.description.guid,
        unzipDirectory=str(fmu.folder),
        modelIdentifier="HRG",
        instanceName="fresh",
    )
    fresh.instantiate()
    assert run(fresh) == again
    fresh.freeInstance()


def test_steps_that_are_no_multiple_of_a_tick(fmu: GyroFmu) -> None:
    """0.4 s in steps of 0.7 ms and what is left: the ticks stay where they are."""

    def run(steps: list[float]) -> float:
        with fmu.power_on(TYPICAL.fmu_parameters(), seed=7, start_angle=0.3) as gyro:
            for step in steps:
                angle = advance(gyro, 0.5, step)
        return angle

    uneven = [0.0007] * 571 + [0.4 - 0.0007 * 571]
    assert run(uneven) == pytest.approx(run([0.4]), rel=1e-12)


def test_another_models_token_is_refused(fmu: GyroFmu) -> None:
    instance = FMU2Slave(
        guid="another",
        unzipDirectory=str(fmu.folder),
        modelIdentifier="HRG",
        instanceName="wrong",
    )
    with pytest.raises(Exception, match="instantiate"):
        instance.instantiate(callbacks=_silent())


def test_stop_time_is_kept(fmu: GyroFmu) -> None:
    instance = FMU2Slave(
        guid=fmu.description.guid,
        unzipDirectory=str(fmu.folder),
        modelIdentifier="HRG",
        instanceName="stopped",
    )
    instance.instantiate(callbacks=_silent())
    instance.setupExperiment(startTime=2.0, stopTime=3.0)
    instance.enterInitializationMode()
    instance.exitInitializationMode()
    instance.doStep(2.0, 0.75)
    with pytest.raises(Exception, match="fmi2DoStep"):
        instance.doStep(2.75, 0.5)
    instance.freeInstance()


def test_state_that_is_no_number_is_an_error(fmu: GyroFmu) -> None:
    """Feedthrough times a loop's gain above 1: each legal alone, unstable together."""
    wild = {"pickOff.feedthrough": 0.01, "controller.amplitudeLoop.naturalFrequency": 500.0}
    with (
        fmu.power_on(wild, seed=1, start_angle=0.0) as gyro,
        pytest.raises(GyroError, match="no longer finite"),
    ):
        advance(gyro, 0.0, 100.0)


def test_step_from_the_wrong_time_is_refused(slave: FMU2Slave) -> None:
    slave.doStep(0.0, 0.5)
    with pytest.raises(Exception, match="fmi2DoStep"):
        slave.doStep(0.1, 0.5)


def test_status_functions_tell_what_there_is(slave: FMU2Slave) -> None:
    """The last time reached, and that the gyro never asks to end; all else is discarded."""
    slave.doStep(0.0, 0.5)
    kinds = {"Status": ctypes.c_int, "Integer": ctypes.c_int, "Boolean": ctypes.c_int}
    kinds |= {"Real": ctypes.c_double, "String": ctypes.c_char_p}
    answers = {}
    for kind, value_type in kinds.items():
        function = getattr(slave.dll, f"fmi2Get{kind.replace('Status', '')}Status")
        function.argtypes = [ctypes.c_void_p, ctypes.c_int, ctypes.c_void_p]
        for what in range(4):
            value = value_type()
            if function(slave.component, what, ctypes.byref(value)) != FMI2_DISCARD:
                answers[kind, what] = value.value
    assert answers == {("Real", LAST_SUCCESSFUL_TIME): 0.5, ("Boolean", TERMINATED): 0}
