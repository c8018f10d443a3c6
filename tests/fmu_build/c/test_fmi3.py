"""FMI 3.0: sound by FMPy's rules, and the same numbers as FMI 2.0."""

import xml.etree.ElementTree as ET
import zipfile
from pathlib import Path

import fmpy
import fmpy.validation
import numpy as np
import pytest

from fmu_build.binaries.platforms import join_universal
from fmu_build.bundle import SOURCES, build_fmu
from tests.fmu_build.importer import Importer


@pytest.fixture(scope="module")
def fmi3_path() -> Path:
    return build_fmu(fmi=3)


def test_fmpy_finds_nothing(fmi3_path: Path) -> None:
    assert fmpy.validation.validate_fmu(str(fmi3_path)) == []


def test_both_standards_give_the_same_bits(fmu_path: Path, fmi3_path: Path) -> None:
    def run(path: Path) -> np.ndarray:
        return fmpy.simulate_fmu(
            str(path),
            stop_time=2.0,
            output_interval=0.1,
            start_values={
                "seed": 5,
                "startAngle": 0.4,
                "angularRate": 0.2,
                "noise.angleRandomWalk": 1e-6,
                "resonator.material.dampingAnisotropy": 1e-6,
            },
            output=["gyroAngle", "amplitudeForce", "valid"],
        )

    two, three = run(fmu_path), run(fmi3_path)
    assert all(np.array_equal(two[name], three[name]) for name in two.dtype.names)


def test_switches_are_boolean(fmi3_path: Path, tmp_path: Path) -> None:
    """What is 1 or 0 is true or false here, read and set by calls of its own alone."""
    with zipfile.ZipFile(fmi3_path) as archive:
        archive.extractall(tmp_path)
    gyro = Importer(tmp_path)
    switches = {n: v for n, v in gyro.variables.items() if v.type == "Boolean"}
    assert {n: (v.variability, v.start) for n, v in switches.items()} == {
        "driveOn": ("discrete", "true"),
        "valid": ("discrete", None),
    }
    slave, (drive, valid) = gyro.slave, gyro.references(["driveOn", "valid"])
    gyro.begin({"driveOn": False, "startAmplitude": 0.5})
    assert slave.getBoolean([drive, valid]) == [False, False]
    for step in range(3):
        slave.doStep(step * 0.1, 0.1)
    (growth,) = gyro.get(["amplitudeForce"])
    assert growth == 0.0
    slave.setBoolean([drive], [True])
    for step in range(3, 100):
        slave.doStep(step * 0.1, 0.1)
    assert slave.getBoolean([drive, valid]) == [True, True]
    said = gyro.refused(lambda: slave.getFloat64([valid]))
    assert said == f"no real variable has the value reference {valid}"
    said = gyro.refused(lambda: slave.setBoolean([valid], [True]))
    assert said == "valid can't be set at all"
    gyro.free()


def test_same_variables_but_time(fmu_path: Path, fmi3_path: Path) -> None:
    two, three = (fmpy.read_model_description(str(p)) for p in (fmu_path, fmi3_path))
    described = [
        {
            (v.name, v.valueReference, v.causality, v.unit, v.start)
            for v in d.modelVariables
            if v.name not in ("driveOn", "valid")
        }
        for d in (two, three)
    ]
    assert {name for name, *_ in described[1] - described[0]} == {"time"}
    assert described[0] <= described[1]


@pytest.mark.parametrize(
    ("model", "step"), [("HRG", 1e-3), ("HRGCarrier", 5e-6), ("HRGSlow", None)]
)
def test_fixed_internal_step_is_told_where_it_is_fixed(model: str, step: float | None) -> None:
    """It is the base clock; that of `HRGSlow` is a parameter."""
    with zipfile.ZipFile(build_fmu(model, fmi=3)) as archive:
        root = ET.fromstring(archive.read("modelDescription.xml"))
    (interface,) = root.findall("CoSimulation")
    assert interface.get("fixedInternalStepSize") == (None if step is None else repr(step))


def test_sources_are_packed_with_their_build_description(fmi3_path: Path) -> None:
    with zipfile.ZipFile(fmi3_path) as archive:
        names = set(archive.namelist())
        text = archive.read("sources/buildDescription.xml").decode()
    listed = {line.split('"')[1] for line in text.splitlines() if "<SourceFile " in line}
    assert listed == {*SOURCES, "fmi3.c"}
    assert {f"sources/{name}" for name in listed} <= names


def test_universal_binary_holds_both() -> None:
    """Header of a fat Mach-O: magic, count, then kind, offset and length of each part."""
    parts = [
        b"\xcf\xfa\xed\xfe" + kind + b"\0" * 8 + b"x" * 100 for kind in (b"\7\0\0\1", b"\x0c\0\0\1")
    ]
    fat = join_universal(parts)
    assert fat[:8] == b"\xca\xfe\xba\xbe\0\0\0\2"
    for index, part in enumerate(parts):
        entry = fat[8 + 20 * index : 28 + 20 * index]
        offset, length = int.from_bytes(entry[8:12]), int.from_bytes(entry[12:16])
        assert fat[offset : offset + length] == part
        assert offset % (1 << 14) == 0
