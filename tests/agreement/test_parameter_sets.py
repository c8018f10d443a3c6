"""The parameter sets inside the FMU are the ready devices."""

import re
import tempfile
import zipfile

import fmpy
import numpy as np
import pytest
from fmpy.ssp.ssd import read_ssv

from fmu_build import build_fmu
from fmu_build.roots import ROOTS
from pyhrg.device.parameter_set import format_parameter_set, format_values
from pyhrg.device.ready_devices import READY, load_device
from pyhrg.fmu import GyroFmu
from tests.agreement.parameter_sets import FOLDER


def _read(archive: zipfile.ZipFile, name: str) -> dict[str, float]:
    """A set of an FMU, read by FMPy, which holds it to the standard's schema."""
    with tempfile.NamedTemporaryFile(suffix=".ssv") as file:
        file.write(archive.read(f"resources/{name}.ssv"))
        file.flush()
        return {p.name: float(p.value) for p in read_ssv(file.name).parameters}


def test_files_are_the_devices() -> None:
    """Where they are not: `python -m tests.agreement.parameter_sets`."""
    sets = {path.stem: path.read_text() for path in FOLDER.glob("*.ssv")}
    assert sets == {name: format_parameter_set(load_device(name)) for name in READY}


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("model", ROOTS)
def test_every_fmu_has_all_sets_and_their_parameters(model: str, fmi: int) -> None:
    path = build_fmu(model, fmi=fmi)
    variables = {v.name: v for v in fmpy.read_model_description(str(path)).modelVariables}
    with zipfile.ZipFile(path) as archive:
        for name in READY:
            values = _read(archive, name)
            assert len(values) > 3
            assert {variables[n].causality for n in values} == {"parameter"}


def test_a_set_makes_the_device() -> None:
    """The FMU with the set gives the bits of the FMU with the device."""
    path = build_fmu()
    with zipfile.ZipFile(path) as archive:
        values = _read(archive, "typical")
    run = fmpy.simulate_fmu(
        str(path), stop_time=2.0, output_interval=0.5, start_values=values, output=["gyroAngle"]
    )
    device = load_device("typical")
    with GyroFmu(path).power_on(
        device.fmu_parameters(), seed=0, start_angle=device.power_on_angle
    ) as gyro:
        still = np.zeros((4, 1))
        ends, _ = gyro.record({"angularRate": still}, {}, 0.5, ["gyroAngle"], [])
    assert np.array_equal(run["gyroAngle"][1:], ends[:, 0])
    assert np.any(run["gyroAngle"] != 0.0)


@pytest.mark.parametrize("model", ROOTS)
def test_a_value_has_the_type_of_its_parameter(model: str) -> None:
    """Of every parameter of every gyro: no Integer is set as a Real."""
    described = fmpy.read_model_description(str(build_fmu(model))).modelVariables
    kinds = {v.name: v.type for v in described if v.causality == "parameter"}
    text = format_values(dict.fromkeys(kinds, 1.0))
    found = re.findall(r'name="([^"]+)">\s*<ssv:(\w+) ', text)
    assert dict(found) == kinds
    assert [name for name, kind in kinds.items() if kind == "Integer"] == [
        "seed",
        "ring.electrodes",
        "controller.forceToRebalance",
    ]
