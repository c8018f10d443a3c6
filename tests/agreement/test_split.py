"""The gyro in two FMUs, resonator and electronics, is the gyro in one; so is one whose electronics
are replaced by their like."""

from collections.abc import Iterator
from pathlib import Path
from zipfile import ZipFile

import pytest

from fmu_build import build_fmu
from tests.fmu_build.importer import Importer

PERIOD = 1e-3
FORCE, READING = ([f"{name}[{i}]" for i in (1, 2, 3, 4)] for name in ("force", "reading"))
COMMANDS = [*FORCE, "pump", "reference", "commandedRate", "isHeld"]
OUTPUTS = ["gyroAngle", "gyroRate", "amplitude", "quadrature", "quadratureForce", "valid"]
SHARED = {
    "seed": 7,
    "startAngle": 0.4,
    "noise.angleRandomWalk": 3e-6,
    "noise.pickOff": 1e-7,
    "noise.rateRandomWalk": 1e-7,
    "noise.virtualRotation": 1e-4,
}
PLANT = {
    "resonator.material.dampingAnisotropy": 1e-5,
    "resonator.material.frequencySplit": 0.05,
    "ring.eccentricity": 0.02,
    "pickOff.gainMismatch": 1e-3,
    "pickOff.samplingSkew": 1e-5,
    "pickOff.feedthrough": 1e-4,
    "drive.nonOrthogonality": 2e-3,
}
ELECTRONICS = {
    "controller.synthesis.loopDelay": 1e-4,
    "controller.readout.clockError": 1e-6,
    "controller.demodulation.filterDelay": 3e-4,
    "controller.timeDivision": 1,
    "controller.parametricShare": 0.5,
}
AUTHORITY = 0.05


@pytest.fixture
def gyros(tmp_path: Path) -> Iterator[list[Importer]]:
    """The gyro, its plant, its electronics."""
    opened = []
    for model in ("HRG", "HRGPlant", "HRGElectronics"):
        with ZipFile(build_fmu(model)) as archive:
            archive.extractall(tmp_path / model)
        opened.append(Importer(tmp_path / model))
    yield opened
    for each in opened:
        each.free()


def hand_on(start: Importer, end: Importer, names: list[str]) -> None:
    end.set(dict(zip(names, start.get(names), strict=True)))


def test_resonator_and_electronics_are_the_gyro(gyros: list[Importer]) -> None:
    """To the last bit, with noise, errors and drives at their limit, if the electronics are stepped
    after the resonator."""
    whole, plant, electronics = gyros
    whole.begin(SHARED | PLANT | ELECTRONICS | {"drive.authority": AUTHORITY})
    plant.begin(SHARED | PLANT | {"drive.authority": AUTHORITY})
    electronics.enter()
    electronics.set(SHARED | ELECTRONICS | {"authority": AUTHORITY})
    hand_on(plant, electronics, READING)
    electronics.slave.exitInitializationMode()
    for k in range(1500):
        motion = {"angularRate": 0.3 if k > 300 else 0.0, "accelerationX": 9.8}
        command = {"virtualRotation": 0.2 if k > 700 else 0.0}
        whole.set(motion | command)
        plant.set(motion)
        electronics.set(command)
        hand_on(electronics, plant, COMMANDS)
        whole.slave.doStep(k * PERIOD, PERIOD)
        plant.slave.doStep(k * PERIOD, PERIOD)
        hand_on(plant, electronics, READING)
        electronics.slave.doStep(k * PERIOD, PERIOD)
        assert electronics.get(OUTPUTS) == whole.get(OUTPUTS), k
    assert abs(whole.get(["gyroAngle"])[0] - 0.3 * 1.2) < 0.01
    assert whole.get(["valid"]) == [0.0]


def test_both_have_the_gyros_parameters(gyros: list[Importer]) -> None:
    whole, *halves = (
        {n for n, v in each.variables.items() if v.causality == "parameter"} for each in gyros
    )
    assert whole <= set.union(*halves)
    assert set.union(*halves) - whole <= {"authority", "startForce", "bryanFactor", "frequency"}


OWN = """model Own "The gyro with electronics of one's own"
  extends HRG.Gyroscopes.HRGEnvelope(
    redeclare HRG.Examples.BaseClasses.ThreeLoops controller(
      quadratureLoop(naturalFrequency = {})));
end Own;
"""


def record_own(folder: Path, frequency: float) -> list[list[float]]:
    """Outputs of a gyro whose electronics are put in, quadrature loop at a natural frequency."""
    file = folder / "Own.mo"
    file.write_text(OWN.format(frequency))
    return record_turn(build_fmu(class_file=file), folder / f"own-{frequency}")


def record_turn(fmu: Path, folder: Path) -> list[list[float]]:
    """Outputs every 10 ms of 2 s in which the case begins to turn."""
    with ZipFile(fmu) as archive:
        archive.extractall(folder)
    gyro = Importer(folder)
    unread = {"noise.rateRandomWalk", "noise.virtualRotation"}
    gyro.begin({name: value for name, value in (SHARED | PLANT).items() if name not in unread})
    outputs = []
    for k in range(200):
        gyro.set({"angularRate": 0.3 if k > 30 else 0.0})
        gyro.slave.doStep(k * 10 * PERIOD, 10 * PERIOD)
        outputs.append(gyro.get(OUTPUTS[:-1]))
    gyro.free()
    return outputs


def test_electronics_are_replaced_by_one_redeclaration(tmp_path: Path) -> None:
    """Three loops of the same parts and constants as the gyro's own give its bits; with another
    constant they don't."""
    usual = record_turn(build_fmu("HRG"), tmp_path / "HRG")
    assert record_own(tmp_path, 6.0) == usual
    assert record_own(tmp_path, 2.0) != usual
