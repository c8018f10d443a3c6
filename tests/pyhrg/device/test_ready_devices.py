"""Devices of a kind."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pyhrg.common.errors import HrgError
from pyhrg.common.units import DEG_PER_H
from pyhrg.device import device_file
from pyhrg.device.ready_devices import TYPICAL, load_device
from pyhrg.theory import closed_forms as theory


def test_the_benched_gyro_is_typical_of_its_kind() -> None:
    """Its map's amplitude is the kind's rms (4000 devices), its stability the paper's 0.1 deg/h."""
    generator = np.random.default_rng(3)
    kind = [abs(theory.static_bias_phasor(TYPICAL.another(generator))) for _ in range(4000)]
    rms = np.sqrt(np.mean(np.square(kind)))
    assert abs(theory.static_bias_phasor(TYPICAL)) == pytest.approx(rms, rel=0.02)
    assert theory.circumferential_bias_stability(TYPICAL) / DEG_PER_H == pytest.approx(
        0.1, rel=0.05
    )


def test_another_keeps_magnitudes() -> None:
    other = TYPICAL.another(np.random.default_rng(1))
    assert other != TYPICAL
    assert other.damping_anisotropy == TYPICAL.damping_anisotropy
    for kind in ("pickoff", "drive"):
        vector = [
            getattr(other, f"{kind}_{part}") for part in ("gain_mismatch", "nonorthogonality")
        ]
        original = [
            getattr(TYPICAL, f"{kind}_{part}") for part in ("gain_mismatch", "nonorthogonality")
        ]
        assert np.hypot(*vector) == pytest.approx(np.hypot(*original))


def test_what_scatters_from_power_on_to_power_on() -> None:
    """2000 power-ons: each about its own value, independent; standard deviation within 3.5 sigma
    (5.5 %); what doesn't scatter stays to the bit."""
    names = ("drive.gainMismatch", "drive.authority")
    device = replace(
        TYPICAL, model={names[1]: 1.0}, turn_on_scatter=dict(zip(names, (9e-6, 0.01), strict=True))
    )
    generator = np.random.default_rng(5)
    drawn = [device.draw_turn_on(generator) for _ in range(2000)]
    values = np.array([[parameters[name] for name in names] for parameters in drawn])
    assert np.std(values, axis=0, ddof=1) == pytest.approx((9e-6, 0.01), rel=0.055)
    reach = 3.5 * np.array([9e-6, 0.01]) / np.sqrt(2000)
    assert np.all(np.abs(values.mean(axis=0) - (TYPICAL.drive_gain_mismatch, 1.0)) < reach)
    assert abs(np.corrcoef(values.T)[0, 1]) < 3.5 / np.sqrt(2000)
    assert {**drawn[0], **dict.fromkeys(names, 0.0)} == {
        **device.fmu_parameters(),
        **dict.fromkeys(names, 0.0),
    }


def test_without_scatter_a_power_on_is_the_device() -> None:
    assert TYPICAL.draw_turn_on(np.random.default_rng(1)) == TYPICAL.fmu_parameters()


def test_a_device_is_loaded_by_name_or_file(tmp_path: Path) -> None:
    assert load_device("typical") == TYPICAL
    device_file.write(TYPICAL, tmp_path / "mine.toml")
    assert load_device(tmp_path / "mine.toml") == TYPICAL
    with pytest.raises(HrgError, match=r"nothing: found no such file .* expected a file or table2"):
        load_device("nothing")
    with pytest.raises(HrgError, match=r"Table2: .* expected a file or table2$"):
        load_device("Table2")
