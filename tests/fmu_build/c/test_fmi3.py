"""FMI 3.0: sound by FMPy's rules, and the same numbers as FMI 2.0."""

import xml.etree.ElementTree as ET
import zipfile
from collections.abc import Iterator, Mapping
from pathlib import Path

import fmpy
import fmpy.validation
import numpy as np
import pytest

from fmu_build.binaries.platforms import join_universal
from fmu_build.bundle import SOURCES, build_fmu
from tests.fmu_build.importer import Importer

VECTORS = (
    "resonator.massDefects.vibrationForce",
    "resonator.material.splitPerAcceleration",
    "pickOff.gainPerAcceleration",
    "pickOff.gainPerAccelerationSquared",
    "pickOff.vibrationVariance",
    "drive.rotationPerAcceleration",
)
WAVES = ("cos2", "sin2", "cos4", "sin4", "cos8", "sin8")
MAPS = {"biasMap": ("mean", *WAVES), "scaleFactorMap": WAVES}
ARRAYS = {name: [f"{name}[{e}]" for e in (1, 2, 3)] for name in VECTORS} | {
    f"controller.{name}.coefficients": [f"controller.{name}.{wave}" for wave in waves]
    for name, waves in MAPS.items()
}
"""Scalars of FMI 2 in the arrays of FMI 3."""


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


def test_same_scalars_but_time(fmu_path: Path, fmi3_path: Path) -> None:
    """An array is that of its elements, in the order of FMI 2's value references."""
    two, three = (fmpy.read_model_description(str(p)) for p in (fmu_path, fmi3_path))
    described = [
        {
            (v.valueReference + e, v.causality, v.variability, v.unit, v.min, v.max, start)
            for v in d.modelVariables
            if v.name not in ("driveOn", "valid")
            for e, start in enumerate((v.start or "none").split())
        }
        for d in (two, three)
    ]
    assert {causality for _, causality, *_ in described[1] - described[0]} == {"independent"}
    assert described[0] <= described[1]
    names = [{v.name for v in d.modelVariables} for d in (two, three)]
    assert names[1] - names[0] == {"time", *ARRAYS}
    by_reference = {v.valueReference: v.name for v in two.modelVariables}
    for variable in three.modelVariables:
        if variable.dimensions:
            (size,) = variable.shape
            begin = variable.valueReference
            elements = [by_reference[begin + e] for e in range(size)]
            assert elements == ARRAYS[variable.name]


@pytest.fixture
def gyro(extracted: dict[int, Path]) -> Iterator[Importer]:
    importer = Importer(extracted[3])
    yield importer
    importer.free()


def _draw(size: int) -> list[float]:
    return list(np.random.default_rng(size).uniform(1e-7, 1e-6, size))


def test_arrays_have_the_effect_of_their_elements(fmu_path: Path, fmi3_path: Path) -> None:
    """To the last bit, and in this order alone."""
    values = {name: _draw(len(elements)) for name, elements in ARRAYS.items()}
    scalars = {
        "angularRate": 0.2,
        "startAngle": 0.3,
        "vibration": 1.0,
        "phaseOffset": 1e-3,
        "resonator.massDefects.first": 1e-3,
        "resonator.massDefects.second": 1e-3,
        "resonator.massDefects.third": 1e-4,
        **{f"acceleration{axis}": 5.0 + place for place, axis in enumerate("XYZ")},
    }

    def run(path: Path, given: Mapping[str, object]) -> np.ndarray:
        outputs = ["gyroAngle", "patternAngle", "amplitudeForce", "quadratureForce"]
        return fmpy.simulate_fmu(
            str(path),
            stop_time=0.5,
            output_interval=0.1,
            start_values=scalars | dict(given),
            output=outputs,
        )

    each = {
        n: v
        for name, elements in ARRAYS.items()
        for n, v in zip(elements, values[name], strict=True)
    }
    expected = run(fmu_path, each)
    assert np.array_equal(run(fmi3_path, values), expected)
    for name in ARRAYS:
        turned = values | {name: values[name][::-1]}
        assert not np.array_equal(run(fmi3_path, turned), expected), name


def test_an_array_is_set_whole(gyro: Importer) -> None:
    """Number of values, each range, and the phase; what is refused changes no byte."""
    name = "controller.biasMap.coefficients"
    (reference,) = gyro.references([f"{name}[1]"])
    slave, values = gyro.slave, _draw(7)
    gyro.begin({})
    slave.setFloat64([reference], values)
    assert gyro.get(f"{name}[{e}]" for e in range(1, 8)) == values
    before = gyro.save()
    for count in (1, 6, 8):
        given = [1e-6] * count
        said = f"{count} values were given, expected 7, with those from {ARRAYS[name][0]} to "
        said += ARRAYS[name][-1]
        assert gyro.refused(lambda v=given: slave.setFloat64([reference], v)) == said
        assert gyro.refused(lambda n=count: slave.getFloat64([reference], n)) == said
    said = gyro.refused(lambda: slave.setFloat64([reference], [*values[:6], 2.0]))
    assert said == "controller.biasMap.sin8 = 2 is outside its range from -1 to 1"
    said = gyro.refused(lambda: slave.setFloat64([reference + 1], [0.0]))
    assert said == f"no real variable has the value reference {reference + 1}"
    (fixed,) = gyro.references(["pickOff.gainPerAcceleration[1]"])
    said = gyro.refused(lambda: slave.setFloat64([fixed], [0.0] * 3))
    assert said == "pickOff.gainPerAcceleration[1] can't be set after initialization"
    assert gyro.save() == before


def test_an_array_has_a_derivative_by_each_element(gyro: Importer) -> None:
    """The steady gain mismatch is the scalar product of these two."""
    gains, variances = "pickOff.gainPerAccelerationSquared", "pickOff.vibrationVariance"
    gyro.enter()
    gyro.set({f"{gains}[{e}]": e * 1e-6 for e in (1, 2, 3)})
    unknowns = gyro.references(["pickOff.steadyMismatch", "patternAngle"])
    knowns = gyro.references(["startAngle", f"{variances}[1]"])
    by_all = gyro.slave.getDirectionalDerivative(unknowns, knowns, [0.5, 1.0, 2.0, 4.0])
    assert by_all == pytest.approx([17e-6, 0.5], rel=1e-9)
    adjoint = gyro.slave.getAdjointDerivative(unknowns, knowns, [2.0, 3.0], 4)
    assert adjoint == pytest.approx([3.0, 2e-6, 4e-6, 6e-6], rel=1e-9)
    said = gyro.refused(lambda: gyro.slave.getDirectionalDerivative(unknowns, knowns, [1.0, 1.0]))
    assert said.startswith("2 values were given, expected 4, with those from")
    said = gyro.refused(lambda: gyro.slave.getAdjointDerivative(unknowns, knowns, [1.0, 1.0]))
    assert said.endswith(f" from {variances}[1] to {variances}[3]")


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
