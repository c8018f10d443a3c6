"""Device files: what they say, what they refuse, and that they come back as they went."""

import dataclasses
import math
import re
from pathlib import Path

import numpy as np
import pytest

from pyhrg.common.errors import HrgError
from pyhrg.common.site import Site
from pyhrg.common.toml_table import Key
from pyhrg.common.units import DEG, DEG_PER_H
from pyhrg.device import device_file
from pyhrg.device.declarations import read_declarations
from pyhrg.device.device import FMU_NAMES, AngleMap, Device
from pyhrg.device.keys import KEYS, SITE_KEYS
from pyhrg.device.parameters.loops_and_bench import LoopAndBenchParameters
from pyhrg.device.ready_devices import TABLE2, TYPICAL
from pyhrg.fmu import GyroError, GyroFmu

NOMINAL = {
    "coriolis_factor": 0.277,
    "decay_time_s": 450.0,
    "frequency_Hz": 7000.0,
    "damping_anisotropy_per_s": 1e-06,
    "damping_axis_deg": 20.0,
    "frequency_split_Hz": 0.0005,
    "stiffness_axis_deg": 65.0,
    "angle_random_walk_deg_sqrt_h": 0.0003,
    "angle_white_noise_arcsec": 0.036,
    "frequency_temperature_coefficient_per_K": 8.5e-05,
    "decay_time_temperature_coefficient_per_K": -0.003,
    "thermal_lag_s": 600.0,
    "control_period_s": 0.001,
    "amplitude": 1.0,
    "amplitude_loop_rad_s": 6.0,
    "quadrature_loop_rad_s": 6.0,
    "phase_loop_rad_s": 200.0,
    "reference_temperature_degC": 25.0,
}
"""As a campaign states it."""


def read(folder: Path, text: str) -> Device:
    path = folder / "device.toml"
    path.write_text(text, encoding="utf-8")
    return device_file.read(path)


def test_an_empty_file_is_an_ideal_gyro(tmp_path: Path) -> None:
    assert read(tmp_path, "") == Device()


def test_an_ideal_gyro_is_the_fmu_as_it_is(fmu: GyroFmu) -> None:
    """Every default of a device is the FMU's own: to the 15 digits that its description shows."""
    assert Device().fmu_parameters() == {}
    starts = {v.name: float(v.start) for v in fmu.description.modelVariables if v.name in FMU_NAMES}
    stated = Device().fmu_values()
    assert starts.keys() == FMU_NAMES
    for name in stated:
        assert stated[name] == pytest.approx(starts[name], rel=1e-14), name


@pytest.mark.parametrize("key", KEYS, ids=[key.name for key in KEYS])
def test_the_fmu_takes_what_the_file_allows(fmu: GyroFmu, key: Key) -> None:
    """Both ends of each range are within the FMU's own, and powered on without complaint."""
    limits = {v.name: (v.min, v.max) for v in fmu.description.modelVariables}
    for end in (key.low, key.high):
        device = dataclasses.replace(Device(), **{key.field: key.to_si(end)})
        for name, value in device.fmu_parameters().items():
            low, high = limits[name]
            assert low is None or float(low) <= value
            assert high is None or value <= float(high)


@pytest.mark.parametrize("key", KEYS, ids=[key.name for key in KEYS])
def test_out_of_range_names_file_key_found_and_expected(tmp_path: Path, key: Key) -> None:
    for wrong in (key.low - 1e-3 * (1 + abs(key.low)), key.high + 1e-3 * (1 + abs(key.high))):
        with pytest.raises(
            HrgError, match=rf"device\.toml: {key.name}: found .*, expected {key.low:g}"
        ):
            read(tmp_path, f"{key.name} = {wrong!r}")


@pytest.mark.parametrize("key", KEYS, ids=[key.name for key in KEYS])
def test_every_key_is_read_in_its_unit_and_reaches_something(tmp_path: Path, key: Key) -> None:
    value = key.low + 0.37 * (key.high - key.low)
    device = read(tmp_path, f"{key.name} = {value!r}")
    assert getattr(device, key.field) == pytest.approx(value * key.factor + key.offset)
    names = list(read_declarations(LoopAndBenchParameters))
    if key.field not in names[names.index("misalignment") :] and key.low != key.high:
        assert device.fmu_parameters()


def test_a_campaigns_nominal_is_a_device() -> None:
    device = device_file.from_table(NOMINAL, "campaign.json: nominal")
    assert device.damping_axis == 20 * DEG
    assert device.decay_time_per_kelvin == -0.003
    assert device.reference_temperature == 298.15


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("pickof_cubic = 1e-4", "pickof_cubic: found an unknown key, expected pickoff_cubic"),
        ("damping_axis_rad = 1", "damping_axis_rad: found an unknown key, expected damping_axis_"),
        ("zzz = 1", "zzz: found an unknown key, expected amplitude or .* or another"),
        ("decay_time_s = '450'", "decay_time_s: found '450', expected a number"),
        ("decay_time_s = true", "decay_time_s: found True, expected a number"),
        ("decay_time_s = nan", "decay_time_s: found nan, expected a finite number"),
        ("decay_time_s = -inf", "decay_time_s: found -inf, expected a finite number"),
        (f"decay_time_s = 1{'0' * 400}", "decay_time_s: found 1.*, expected a finite number"),
        ("decay_time_s = [450]", r"decay_time_s: found \[450\], expected a number"),
        ("decay_time_s = 450\ndecay_time_s = 450", "found what is no TOML: .*overwrite a value"),
        ("decay_time_s 450", "found what is no TOML: .*line 1"),
        ("name = 3", "name: found 3, expected text"),
        ("control_period_s = 2e-3", "control_period_s: found 0.002, expected 0.001, the only"),
        ("decay_time_per_K = 0.001\ndecay_time_temperature_coefficient_per_K = 0.001",
         "decay_time_temperature_coefficient_per_K: .* decay_time_per_K, which says the same"),
        ("decay_time_s = 1000\ndamping_anisotropy_per_s = 3e-3",
         "damping_anisotropy_per_s: found 0.003, expected at most 2/decay_time_s, 0.002"),
        ("bias_map = 3", "bias_map: found 3, expected a table"),
        ("[bias_map]\ncos3 = 1", r"bias_map\.cos3: found an unknown key, expected bias_map\.cos"),
        ("[bias_map]\ncos4 = 'x'", r"bias_map\.cos4: found 'x', expected a number"),
        ("[site]\nlatitude_deg = 91", r"site\.latitude_deg: found 91.*, expected -90 to 90"),
        ("[site]\ngravity = 9.8", r"site\.gravity: .* expected site\.gravity_m_s2"),
        ("[turn_on_scatter]\n'drive.gainMismatch' = -1e-6", r"turn_on_scatter\.drive.*above 0"),
        ("[turn_on_scatter]\n'drive.gain' = 1e-6",
         r"turn_on_scatter\.drive\.gain: found an unknown key, expected turn_on_scatter\.drive"),
        ("[turn_on_scatter]\nstartAngle = 0.1", r"turn_on_scatter\.startAngle: found an unknown"),
        ("[specification]\nbias_stability_deg_per_h = 0", r"specification\.bias_.*above 0"),
        ("[model]\n'pickOff.gainMismatch' = 1e-4", "model: found 'pickOff.gainMismatch', expec"),
        ("[model]\nseed = 1", "model: found 'seed', expected"),
        ("[model]\n'drive.authority' = 'x'", r"model\.drive\.authority: found 'x', expected a nu"),
        ("[model]\ndrive.authority = 1", r"model\.drive: found \{'authority': 1\}, expected a nu"),
    ],
)  # fmt: skip
def test_bad_files_are_refused(tmp_path: Path, text: str, message: str) -> None:
    with pytest.raises(HrgError, match=rf"device\.toml: (?s:{message})"):
        read(tmp_path, text)


def test_unreadable_files_are_refused(tmp_path: Path) -> None:
    with pytest.raises(HrgError, match=re.escape("none.toml: can't be read: No such file")):
        device_file.read(tmp_path / "none.toml")
    (tmp_path / "latin.toml").write_bytes(b'name = "\xe9"')
    with pytest.raises(HrgError, match=r"latin\.toml: found what is no text in utf-8"):
        device_file.read(tmp_path / "latin.toml")


def test_model_names_are_checked_against_the_fmu(tmp_path: Path, fmu: GyroFmu) -> None:
    path = tmp_path / "device.toml"
    path.write_text("[model]\n'drive.autority' = 0.1\n")
    unknown = device_file.read(path).fmu_parameters()
    with pytest.raises(GyroError, match=r"no variable drive\.autority"):
        fmu.power_on(unknown, seed=0, start_angle=0.0)
    with pytest.raises(GyroError, match=r"forceToRebalance: 0\.5 is no integer"):
        fmu.power_on({"controller.forceToRebalance": 0.5}, seed=0, start_angle=0.0)
    assert fmu.references.keys() >= FMU_NAMES


def test_tables_of_a_device(tmp_path: Path) -> None:
    device = read(
        tmp_path,
        'name = "no. 7"\n[bias_map]\nmean = 0.02\nsin4 = -0.1\n[site]\nlatitude_deg = -30\n'
        "[specification]\nbias_stability_deg_per_h = 0.01\n[model]\n'drive.authority' = 1\n"
        "[turn_on_scatter]\n'drive.gainMismatch' = 9e-6\n'drive.authority' = 0.01\n",
    )
    assert device == Device(
        name="no. 7",
        bias_map=AngleMap(mean=0.02 * DEG_PER_H, sin4=-0.1 * DEG_PER_H),
        site=Site(latitude=-30 * DEG),
        specification={"bias_stability_deg_per_h": 0.01},
        model={"drive.authority": 1.0},
        turn_on_scatter={"drive.gainMismatch": 9e-6, "drive.authority": 0.01},
    )
    written = tmp_path / "written.toml"
    device_file.write(device, written)
    assert device_file.read(written) == device


def test_what_was_read_is_written_to_the_same_bits(tmp_path: Path) -> None:
    """200 devices with every key at random, of 3 to 17 digits; the typical one with its numbers."""
    generator = np.random.default_rng(20)
    path = tmp_path / "device.toml"
    keys = {key.field: key for key in reversed(KEYS)}.values()
    for _ in range(200):
        share, digits = (
            generator.uniform(0.01, 0.99, len(keys)),
            generator.integers(3, 18, len(keys)),
        )
        text = [
            f"{k.name} = {k.low + s * (k.high - k.low):.{d}g}"
            for k, s, d in zip(keys, share, digits, strict=True)
            if k.name not in ("damping_anisotropy_per_s", "control_period_s")
        ]
        device = read(tmp_path, "\n".join(text))
        device_file.write(device, path)
        assert device_file.read(path) == device
    for known in (TABLE2, TYPICAL):
        device_file.write(known, path)
        assert device_file.read(path) == known
    assert "damping_axis_deg = 85.0\n" in path.read_text()
    assert "decay_time_s" not in path.read_text()


def test_any_device_comes_back_within_one_last_place(tmp_path: Path) -> None:
    generator = np.random.default_rng(21)
    path = tmp_path / "device.toml"
    for _ in range(200):
        device = TYPICAL.another(generator)
        device_file.write(device, path)
        again = device_file.read(path)
        for field in dataclasses.fields(Device):
            value = getattr(device, field.name)
            if isinstance(value, float):
                assert abs(getattr(again, field.name) - value) <= math.ulp(value)


def test_names_are_any_text(tmp_path: Path) -> None:
    device = Device(name='HRG "№ 7"\n\\ 半球\x7f')
    device_file.write(device, tmp_path / "device.toml")
    assert device_file.read(tmp_path / "device.toml") == device


def test_every_key_is_in_the_docs() -> None:
    text = (Path(__file__).parents[3] / "docs" / "devices.md").read_text()
    for key in (*KEYS, *SITE_KEYS):
        assert f"| `{key.name}` | {key.low:g} to {key.high:g} |" in text, key.name
