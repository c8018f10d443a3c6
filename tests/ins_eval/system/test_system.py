"""A system flies as `ins_eval.fly` does, in other people's importers."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

import ins_eval
from fmu_build import check_fmu
from ins_eval.common.state import position_error
from pyhrg.common.errors import HrgError
from tests.ins_eval.system.masters import run_ssp

INTERVAL = 0.01
ECOS = pytest.param("ecos", marks=pytest.mark.needs("libtbb12"))
IMU = """\
[gyros]
device = "{device}"
calibrated = false
[gyros.mounting]
axes = [[1, 0.2, 0], [0, 1, 0.1], [0.3, 0, 1]]
error_sigma_arcsec = 20
[accelerometers]
bias_sigma_micro_g = 50
scale_factor_sigma_ppm = 50
misalignment_sigma_arcsec = 20
"""
QUIET = """\
name = "quiet"
damping_anisotropy_per_s = 1e-6
drive_nonorthogonality = 1e-4
power_on_angle_deg = 10.0
"""
"""A gyro without noise."""


@dataclass(frozen=True)
class System:
    """An archive, and the flight that it should fly."""

    path: Path
    flight: ins_eval.Flight


def write(folder: Path, device: str, **options: object) -> System:
    (folder / "quiet.toml").write_text(QUIET)
    (folder / "imu.toml").write_text(IMU.format(device=device))
    given = {"hours": 1 / 60, "seed": 4, **options}
    flight = ins_eval.fly("weaving", str(folder / "imu.toml"), align_s=None, **given)
    path = folder / "system.ssp"
    return System(ins_eval.write_system(path, "weaving", folder / "imu.toml", **given), flight)


@pytest.fixture(scope="module")
def noisy(tmp_path_factory: pytest.TempPathFactory) -> System:
    return write(tmp_path_factory.mktemp("noisy"), "typical")


@pytest.fixture(scope="module")
def quiet(tmp_path_factory: pytest.TempPathFactory) -> System:
    return write(tmp_path_factory.mktemp("quiet"), "quiet.toml", height="baro")


def difference(system: System, importer: str, steps: int, step: float = INTERVAL) -> np.ndarray:
    """(3,) position in an importer less that of the flight, m, at one of its rows."""
    found = run_ssp(importer, system.path, step, steps)
    rows = system.flight.dataset
    at = rows.sel(time=found["navigationTime"], method="nearest")
    assert found["navigationTime"] == pytest.approx(float(at.time), abs=1e-9)
    assert found["valid"] == 1
    flown = [np.deg2rad(at.latitude[0]), np.deg2rad(at.longitude[0]), at.height[0]]
    place = np.array([found["latitude"], found["longitude"], found["height"]])
    return np.abs(position_error(place, np.array(flown, dtype=float)))


@pytest.mark.parametrize("importer", [ECOS, "libcosimpy"])
def test_flies_as_fly_does_with_the_gyros_noise(noisy: System, importer: str) -> None:
    """Within a micrometre, the degrees' rounding included; the IMU makes an error of metres."""
    assert float(noisy.flight.dataset.radial_error[0, -1]) > 0.5
    assert np.max(difference(noisy, importer, 6001)) < 1e-6


@pytest.mark.needs("libtbb12")
def test_communication_steps_may_divide_the_interval(noisy: System) -> None:
    assert np.max(difference(noisy, "ecos", 4001, INTERVAL / 2)) < 1e-6


def test_flies_in_fmpy_too(quiet: System) -> None:
    """One step later, which no gyro without noise feels; with the height's loop."""
    assert np.max(difference(quiet, "fmpy", 2002)) < 1e-6


@pytest.mark.needs("libtbb12")
def test_a_longer_step_is_seen(noisy: System) -> None:
    assert run_ssp("ecos", noisy.path, 2 * INTERVAL, 100)["valid"] == 0


@pytest.mark.needs("libtbb12", "fmi-sim")
def test_the_system_passes_the_checks(noisy: System) -> None:
    """Each FMU in it and the whole, which importers run with equal numbers."""
    report = check_fmu(noisy.path)
    assert [check for check in report.checks if check.findings or check.skipped] == []
    assert report.checks[-1].remark == "1475 numbers of Ecos, libcosimpy"


def test_what_cannot_be_a_system_is_refused(tmp_path: Path) -> None:
    out = tmp_path / "system.ssp"
    with pytest.raises(HrgError, match="stated by their errors"):
        ins_eval.write_system(out, "car", "simple", hours=1 / 60)
    with pytest.raises(HrgError, match=r"ssp: found '3.0'"):
        ins_eval.write_system(out, ssp="3.0")
    with pytest.raises(HrgError, match="it is a folder"):
        ins_eval.write_system(tmp_path)
    assert list(tmp_path.iterdir()) == []
