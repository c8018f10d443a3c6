"""The parameter sets inside the FMU are the ready devices."""

import re
import tempfile
import zipfile

import fmpy
import numpy as np
import pytest
from fmpy.ssp.ssd import read_ssv

from fmu_build import build_fmu
from fmu_build.archive.parameter_sets import join_arrays
from fmu_build.bundle import list_arrays
from fmu_build.roots import ROOTS
from pyhrg.device.parameter_set import format_parameter_set, format_values
from pyhrg.device.ready_devices import READY, load_device
from pyhrg.fmu import GyroFmu
from tests.agreement.parameter_sets import FOLDER


def _read(archive: zipfile.ZipFile, name: str) -> dict[str, float | str]:
    """A set of an FMU, read by FMPy, which holds it to the schema of SSP 1.0; a set of SSP 2.0 to
    none. An array is the text of its values, as FMPy takes it."""
    text = archive.read(f"resources/{name}.ssv")
    with tempfile.NamedTemporaryFile(suffix=".ssv") as file:
        file.write(text)
        file.flush()
        read = read_ssv(file.name, validate=b'version="2.0"' not in text).parameters
    return {p.name: p.value if " " in p.value else float(p.value) for p in read}


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


def test_a_set_with_a_map_is_of_arrays_in_fmi_3() -> None:
    """Of SSP 2.0, and no other set is. It makes the same device, to the last bit."""
    angles = {}
    for fmi, newer in ((2, set()), (3, {"table2"})):
        path = build_fmu(fmi=fmi)
        with zipfile.ZipFile(path) as archive:
            texts = {name: archive.read(f"resources/{name}.ssv").decode() for name in READY}
            values = _read(archive, "table2")
        assert texts == {name: format_parameter_set(load_device(name), fmi) for name in READY}
        assert {name for name, text in texts.items() if 'version="2.0"' in text} == newer
        run = fmpy.simulate_fmu(str(path), stop_time=2.0, output_interval=0.5, start_values=values)
        angles[fmi] = run["gyroAngle"]
    assert '<ssc:Dimension size="7" />' in texts["table2"]
    assert np.array_equal(angles[2], angles[3])
    assert np.any(angles[2] != 0.0)


def test_an_axis_of_a_vector_keeps_the_others() -> None:
    values = {"pickOff.gainPerAcceleration[2]": 1e-5, "startAngle": 0.5}
    text = join_arrays(format_values(values), list_arrays())
    assert '<ssv:Real value="0.0 1e-05 0.0" />' in text
    assert "[2]" not in text
    assert text.index("pickOff") < text.index("startAngle")


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
        "controller.timeDivision",
    ]
