"""Each key of a device file on the FMU: the sign and size that the campaigns' catalogue defines.

Closed forms are the catalogue's definitions to first order, at rest with the loops closed: th the
pattern angle, c4 and s4 of four of it, ' from th_tau, '' from th_w, k and tau as by default. Each
is to hold within 1 % of its size at three angles, and its size is far above that of a gyro without
the effect; where a test says otherwise it says why.
"""

import math
from collections.abc import Mapping
from pathlib import Path

import numpy as np
import pytest

from pyhrg.common.units import DEG, DEG_PER_H
from pyhrg.device import device_file
from pyhrg.device.declarations import read_declarations
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.theory.closed_forms import time_division_bias
from tests.agreement.device_keys import (
    ANGLES,
    DW,
    ONE,
    SIN4,
    SIN_SPLIT,
    SPLIT,
    SPLIT_AXIS,
    TAU,
    K,
    gyro,
    holds,
    settled,
)
from tests.driving import advance

HOLD = 5e-4
COS4 = np.cos(4 * ANGLES)
COS_SPLIT = np.cos(4 * (ANGLES - SPLIT_AXIS))
MOUNTING = "misalignment"

Expected = tuple[str, np.ndarray]
"""A channel, and its closed form at each angle."""


AT_REST: dict[str, tuple[Mapping[str, float], Mapping[str, float], Expected]] = {
    "damping anisotropy: -(D/4k) s4'": (
        {"damping_anisotropy_per_s": 1e-6, "damping_axis_deg": 20.0},
        {},
        ("bias", -1e-6 / (4 * K) * np.sin(4 * (ANGLES - 20 * DEG))),
    ),
    "split in the quadrature force: +(dw/2) s4''": (
        SPLIT,
        {},
        ("quadratureForce", DW / 2 * SIN_SPLIT),
    ),
    "split in the frequency: -(dw/2) c4''": (SPLIT, {}, ("frequencyOffset", -DW / 2 * COS_SPLIT)),
    "pick-off gain": ({"pickoff_gain_mismatch": 1e-4}, {}, ("bias", 1e-4 / (4 * K * TAU) * SIN4)),
    "pick-off non-orthogonality": (
        {"pickoff_nonorthogonality": 1e-4},
        {},
        ("bias", -1e-4 / (4 * K * TAU) * (1 + COS4)),
    ),
    "drive gain": ({"drive_gain_mismatch": 1e-4}, {}, ("bias", 1e-4 / (4 * K * TAU) * SIN4)),
    "drive non-orthogonality": (
        {"drive_nonorthogonality": 1e-4},
        {},
        ("bias", -1e-4 / (4 * K * TAU) * (1 + COS4)),
    ),
    "frame rotation: -e/(2k tau)": (
        {"drive_frame_rotation_rad": 1e-4},
        {},
        ("bias", -1e-4 / (2 * K * TAU) * ONE),
    ),
    "parametric drive: as much less of what forces misaim": (
        {"drive_frame_rotation_rad": 1e-4, "parametric_share": 0.75},
        {},
        ("bias", -1e-4 / 4 / (2 * K * TAU) * ONE),
    ),
    "anisotropy of parametric drive: (n/2k tau) sin 4(th - th_n)": (
        {"parametric_share": 1.0, "pump_anisotropy": 1e-4, "pump_axis_deg": 20.0},
        {},
        ("bias", 1e-4 / (2 * K * TAU) * np.sin(4 * (ANGLES - 20 * DEG))),
    ),
    "mode reversal: the sweeps' share of what they cross": (
        {
            "damping_anisotropy_per_s": 1e-6,
            "damping_axis_deg": 20.0,
            "sweep_angle_deg": 45.0,
            "sweep_time_s": 5.0,
            "sweep_rest_s": 5.0,
            "model": {"controller.forceToRebalance": 1.0},
        },
        {},
        ("bias", -1e-6 / (4 * K * math.pi) * np.cos(4 * (ANGLES - 20 * DEG))),
    ),
    "phase error with split: -(dw p/4k) s4''": (
        {**SPLIT, "phase_error_rad": 1e-3},
        {},
        ("bias", -DW * 1e-3 / (4 * K) * SIN_SPLIT),
    ),
    "residual quadrature is its set point": (
        {"residual_quadrature": 1e-3},
        {},
        ("quadrature", 1e-3 * ONE),
    ),
    "residual quadrature with split: -(dw/2k) q0 c4''": (
        {**SPLIT, "residual_quadrature": 1e-3},
        {},
        ("bias", -DW / (2 * K) * 1e-3 * COS_SPLIT),
    ),
    "Duffing": ({"duffing_Hz": 0.01}, {}, ("frequencyOffset", 2 * math.pi * 0.01 * ONE)),
    "Duffing at half the amplitude: a quarter": (
        {"duffing_Hz": 0.01, "amplitude": 0.5},
        {},
        ("frequencyOffset", 2 * math.pi * 0.01 / 4 * ONE),
    ),
    "electrostatic cubic: (delta/4) s8": (
        {"electrostatic_cubic_Hz": 1e-3},
        {},
        ("quadratureForce", 2 * math.pi * 1e-3 / 4 * np.sin(8 * ANGLES)),
    ),
    "the amplitude is held": ({"amplitude": 0.5}, {}, ("amplitude", 0.5 * ONE)),
    "feedthrough with split: (c dw^2/8k) s8''": (
        {**SPLIT, "feedthrough_s": 1e-3},
        {},
        ("bias", 1e-3 * DW**2 / (8 * K) * np.sin(8 * (ANGLES - SPLIT_AXIS))),
    ),
    "time division with split: -(dw^2 Ts/16k) s8'', and no feedthrough": (
        {**SPLIT, "time_division": 1, "feedthrough_s": 1e-3},
        {},
        (
            "bias",
            time_division_bias(
                Device(frequency_split=DW, stiffness_axis=SPLIT_AXIS, time_division=1), ANGLES
            ),
        ),
    ),
    "decay time": ({"decay_time_s": 300.0}, {}, ("amplitudeForce", ONE / 300)),
    "virtual rotation gain: -e V": (
        {"virtual_rotation_gain_ppm": 1000.0},
        {"virtualRotation": 0.02},
        ("bias", -1e-3 * 0.02 * ONE),
    ),
    "bias over g, f = 2 g along the input axis": (
        {"bias_deg_h_per_g": 0.5},
        {"accelerationZ": 2 * 9.80665},
        ("bias", 2 * 0.5 * DEG_PER_H * ONE),
    ),
    "the same of another gyro": (
        {"bias_deg_h_per_g": 0.5, "decay_time_s": 900.0, "coriolis_factor": 0.3},
        {"accelerationZ": 2 * 9.80665},
        ("bias", 2 * 0.5 * DEG_PER_H * ONE),
    ),
    "pick-off gain over g, f = 2 g along x": (
        {"pickoff_gain_per_g": 1e-4},
        {"accelerationX": 2 * 9.80665},
        ("bias", 2e-4 / (4 * K * TAU) * SIN4),
    ),
    "bias map: taken out": (
        {
            "bias_map": {
                "mean": 0.3,
                "cos2": 0.2,
                "sin2": -0.4,
                "cos4": 0.5,
                "sin4": 0.6,
                "cos8": -0.7,
                "sin8": 0.8,
            }
        },
        {},
        (
            "bias",
            -DEG_PER_H
            * (
                0.3
                + 0.2 * np.cos(2 * ANGLES)
                - 0.4 * np.sin(2 * ANGLES)
                + 0.5 * COS4
                + 0.6 * SIN4
                - 0.7 * np.cos(8 * ANGLES)
                + 0.8 * np.sin(8 * ANGLES)
            ),
        ),
    ),
}


@pytest.mark.parametrize(("keys", "inputs", "expected"), AT_REST.values(), ids=AT_REST.keys())
def test_at_rest(
    fmu: GyroFmu, keys: Mapping[str, float], inputs: Mapping[str, float], expected: Expected
) -> None:
    channel, closed_form = expected
    assert holds(settled(fmu, keys, inputs, channel), closed_form)


def test_damping_anisotropy_in_the_amplitude_force(fmu: GyroFmu) -> None:
    """1/tau + (D/2) c4'."""
    keys = {"damping_anisotropy_per_s": 1e-5, "damping_axis_deg": 20.0}
    force = settled(fmu, keys, {}, "amplitudeForce") - 1 / TAU
    assert holds(force, 0.5e-5 * np.cos(4 * (ANGLES - 20 * DEG)))


AT_POWER_ON: dict[str, tuple[Mapping[str, float], Expected]] = {
    "pick-off gain": ({"pickoff_gain_mismatch": 1e-4}, ("gyroAngle", 1e-4 / (4 * K) * SIN4)),
    "pick-off non-orthogonality": (
        {"pickoff_nonorthogonality": 1e-4},
        ("gyroAngle", -1e-4 / (4 * K) * (1 + COS4)),
    ),
    "x0 turns the modal angle by -x0 sin 2th": (
        {"demodulation_offset": 1e-4},
        ("gyroAngle", 1e-4 * np.sin(2 * ANGLES) / (2 * K)),
    ),
    "y0 turns the modal angle by y0 cos 2th": (
        {"demodulation_offset_y": 1e-4},
        ("gyroAngle", -1e-4 * np.cos(2 * ANGLES) / (2 * K)),
    ),
    "x (1 + 3/4 b x^2) turns it by -(3/16) b sin 8th": (
        {"pickoff_cubic": 1e-3},
        ("gyroAngle", 3e-3 / (32 * K) * np.sin(8 * ANGLES)),
    ),
    "x by +p/2, y by -p/2 shows quadrature (p/2) s4": (
        {"differential_phase_rad": 1e-3},
        ("quadrature", 0.5e-3 * SIN4),
    ),
}


@pytest.mark.parametrize(("keys", "expected"), AT_POWER_ON.values(), ids=AT_POWER_ON.keys())
def test_at_power_on(fmu: GyroFmu, keys: Mapping[str, float], expected: Expected) -> None:
    """What the pick-offs misread of a pattern whose angle is known."""
    channel, closed_form = expected
    values = []
    for angle in ANGLES:
        with gyro(fmu, keys, angle) as running:
            values.append(running.read(channel))
    assert holds(np.array(values), closed_form)


@pytest.mark.parametrize(
    ("keys", "error"),
    [
        ({}, 0.0),
        ({"loop_delay_s": 3e-3}, -3e-3 / TAU),
        ({"filter_delay_s": 3e-3}, -3e-3 * (1 / TAU + 1 / 50)),
        ({"coriolis_factor_error_ppm": 20.0}, 20e-6),
        ({"coriolis_factor_error_ppm": -20.0, "coriolis_factor": 0.3}, -20e-6),
    ],
)
def test_scale_factor(fmu: GyroFmu, keys: Mapping[str, float], error: float) -> None:
    """Beside the hold's own -(Ts/2)/tau, to 5e-8, in both directions; the angle that a filter is
    late by counts over the 50 s."""
    for rate in (0.5, -0.5):
        with gyro(fmu, keys, 0.1) as running:
            measured = advance(running, rate, 50.0) / (50 * rate) - 1
        assert measured + HOLD / TAU == pytest.approx(error, abs=5e-8)


@pytest.mark.parametrize("rate", [1.0, -1.0])
def test_sampling_skew(fmu: GyroFmu, rate: float) -> None:
    """W (ts/2)(1 + c4) of angle, odd in the rate, to 1 %."""
    skew = 1e-4
    with gyro(fmu, {"sampling_skew_s": skew}, 0.1) as running, gyro(fmu, {}, 0.1) as plain:
        error = advance(running, rate, 2.0) - advance(plain, rate, 2.0)
        expected = rate * skew / 2 * (1 + math.cos(4 * plain.read("patternAngle")))
    assert error == pytest.approx(expected, abs=0.01 * skew)


def test_every_effect_has_its_test_here() -> None:
    """Each key whose parameter a diagnosis may name is put to the FMU here or by one of the files
    named after devices beside, but for misalignment, which the FMU does not have."""
    files = sorted(Path(__file__).parent.glob("*device*.py"))
    text = "".join(file.read_text(encoding="utf-8") for file in files)
    declared = read_declarations(Device)
    keys = {d.keys[0] for name, d in declared.items() if (d.effect or d.noise) and name != MOUNTING}
    assert {key for key in keys if f'"{key}"' not in text} == set()


def test_an_ideal_gyro_shows_none_of_it(fmu: GyroFmu) -> None:
    """Negative control of the tests at rest: below 1e-4 deg/h in rate, 1e-9 in the forces."""
    assert Device() == device_file.from_table({}, "test")
    assert np.max(np.abs(settled(fmu, {}, {}, "bias"))) < 1e-4 * DEG_PER_H
    assert np.max(np.abs(settled(fmu, {}, {}, "quadratureForce"))) < 1e-9
    assert np.max(np.abs(settled(fmu, {}, {}, "frequencyOffset"))) < 1e-9
    assert np.max(np.abs(settled(fmu, {}, {}, "amplitudeForce") - 1 / TAU)) < 1e-9
