"""IMUs as TOML files."""

from pathlib import Path

import numpy as np
import pytest

from ins_eval.imu import specification
from ins_eval.imu.gyros import FmuGyros
from ins_eval.imu.imu import Imu
from ins_eval.imu.sensor_error_model import TYPICAL_ACCELEROMETERS
from ins_eval.imu.stated_gyros import StatedGyros
from pyhrg.common.errors import HrgError
from pyhrg.common.units import ARCSEC, DEG, DEG_PER_H, MICRO_G, PPM
from pyhrg.device.ready_devices import TYPICAL


def read(folder: Path, text: str) -> Imu:
    path = folder / "unit.toml"
    path.write_text(text)
    return specification.read_imu(path)


def test_an_empty_file_is_an_ideal_unit_at_100_hz(tmp_path: Path) -> None:
    unit = read(tmp_path, "")
    assert unit.gyros == StatedGyros()
    assert (unit.interval, unit.name, unit.mounting_deviation) == (0.01, "unit", 0.0)


def test_every_number_is_taken_in_its_unit(tmp_path: Path) -> None:
    unit = read(
        tmp_path,
        """
        name = "mine"
        rate_hz = 400
        [gyros]
        kind = "simple"
        bias_deg_h = [1, 2, 3]
        bias_sigma_deg_h = 4
        scale_factor_sigma_ppm = 5
        quantum_arcsec = 6
        [gyros.mounting]
        axes = [[0, 2, 0], [0, 0, 1], [1, 0, 0]]
        error_sigma_arcsec = 7
        [accelerometers]
        misalignment_arcsec = [1, 2, 3, 4, 5, 6]
        bias_sigma_micro_g = 8
        velocity_random_walk_m_s_sqrt_h = 60
        """,
    )
    assert isinstance(unit.gyros, StatedGyros)
    assert unit.gyros.error_model.bias.value == pytest.approx(np.array([1, 2, 3]) * DEG_PER_H)
    assert unit.gyros.error_model.bias.deviation == pytest.approx(4 * DEG_PER_H)
    assert unit.gyros.error_model.scale_factor.deviation == pytest.approx(5 * PPM)
    assert unit.gyros.error_model.quantization_step == pytest.approx(6 * ARCSEC)
    np.testing.assert_array_equal(unit.mounting.axes, [[0, 1, 0], [0, 0, 1], [1, 0, 0]])
    assert unit.mounting_deviation == pytest.approx(7 * ARCSEC)
    assert unit.accelerometers.misalignment.value == pytest.approx(np.arange(1, 7) * ARCSEC)
    assert unit.accelerometers.bias.deviation == pytest.approx(8 * MICRO_G)
    assert unit.accelerometers.random_walk == pytest.approx(1.0)
    assert (unit.name, unit.interval) == ("mine", 1 / 400)


def test_gyros_may_differ_from_their_device(tmp_path: Path) -> None:
    (tmp_path / "own.toml").write_text("decay_time_s = 300")
    unit = read(
        tmp_path,
        """
        [gyros]
        device = "own.toml"
        own_axes = false
        [gyros.second]
        power_on_angle_deg = 11.0
        [gyros.third.bias_map]
        mean = 2.0
        """,
    )
    assert isinstance(unit.gyros, FmuGyros)
    devices = unit.gyros.devices(np.random.default_rng(1))
    assert [device.decay_time for device in devices] == [300.0] * 3
    assert [device.power_on_angle / DEG for device in devices] == pytest.approx([0, 11, 0])
    assert [device.bias_map.mean / DEG_PER_H for device in devices] == pytest.approx([0, 0, 2])


def test_ready_units_are_there() -> None:
    assert specification.list_imus() == ["ideal", "simple", "typical-hrg"]
    unit = specification.load_imu("typical-hrg")
    assert isinstance(unit.gyros, FmuGyros)
    assert (unit.gyros.device, unit.name) == (TYPICAL, "typical-hrg")
    assert unit.accelerometers.random_walk == pytest.approx(TYPICAL_ACCELEROMETERS.random_walk)
    assert unit.accelerometers.bias.deviation == TYPICAL_ACCELEROMETERS.bias.deviation


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("rate_hz = 5", r"unit\.toml: rate_hz: found 5, expected 10 to 2000"),
        ("rate_hz = true", "rate_hz: found True, expected a number"),
        ("rate_hz = nan", "rate_hz: found nan, expected a finite number"),
        ("rate = 100", "rate: found an unknown key, expected rate_hz"),
        ("name = 1", "name: found 1, expected text"),
        ("gyros = 1", "gyros: found 1, expected a table"),
        ("gyros.kind = 'good'", "gyros.kind: found 'good', expected ideal or simple"),
        ("gyros.bias_deg_h = [1, 2, 3]", r"gyros\.bias_deg_h: found an unknown key, expected"),
        (
            "gyros.device = 'none'",
            r"gyros.device: found 'none', expected table2, typical, .*, or a file in /",
        ),
        ("gyros.devise = 'typical'", r"gyros.devise: found .* expected gyros.device$"),
        (f"gyros.device = '{'n' * 5000}'", r"nn', expected table2"),
        ("gyros.device = 'typical'\ngyros.calibrated = 1", "calibrated: found 1, expected true or"),
        ("gyros.device = 'typical'\ngyros.first.decay_time = 1", "gyros.first: decay_time: found"),
        ("gyros.device = 'typical'\ngyros.forth = 1", r"gyros.forth: found an unknown key"),
        (
            "gyros.mounting.axes = [[1, 0, 0], [0, 1, 0], [1, 1, 0]]",
            "gyros.mounting.axes: .* plane",
        ),
        ("gyros.mounting.axes = [[1, 0, 0], [0, 1]]", "gyros.mounting.axes: .*three input axes"),
        ("gyros.mounting.axes = 'xyz'", "gyros.mounting.axes: found 'xyz', expected three"),
        ("accelerometers.bias_micro_g = 5", r"bias_micro_g: found 5, expected 3 numbers in brack"),
        ("accelerometers.bias_micro_g = [5, 'x', 1]", r"bias_micro_g\[1\]: found 'x', expected a"),
        ("accelerometers.quantum_m_s = -1", "accelerometers.quantum_m_s: found -1, expected 0 to"),
        ("rate_hz = ", "found what is no TOML"),
    ],
)
def test_what_is_wrong_is_named(tmp_path: Path, text: str, message: str) -> None:
    with pytest.raises(HrgError, match=message):
        read(tmp_path, text)


def test_a_name_that_is_neither_is_refused() -> None:
    with pytest.raises(HrgError, match=r"best: found no such file .* expected a file or ideal"):
        specification.load_imu("best")
