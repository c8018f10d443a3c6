"""Each key of a device file on the FMU: the sign and size that the campaigns' catalogue defines.

Closed forms are the catalogue's definitions to first order, at rest with the loops closed: th the
pattern angle, c4 and s4 of four of it, ' from th_tau, '' from th_w, k and tau as by default. Each
is to hold within 1 % of its size at three angles, and its size is far above that of a gyro without
the effect; where a test says otherwise it says why.
"""

import math
from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np
import pytest

from pyhrg.common.units import ARCSEC, DEG, DEG_PER_H, DEG_PER_SQRT_H
from pyhrg.device import device_file
from pyhrg.device.declarations import read_declarations
from pyhrg.device.device import Device
from pyhrg.fmu import Gyro, GyroFmu
from tests.driving import advance, drive

K, TAU, HOLD = 0.277, 450.0, 5e-4
ANGLES = np.array([7.0, 31.0, 64.0]) * DEG
WARM = {"caseTemperature": 298.15 + 10.0}
"""10 K above the reference."""
SPLIT = {"frequency_split_Hz": 1e-3, "stiffness_axis_deg": 50.0}
DW, SPLIT_AXIS = 2 * math.pi * 1e-3, 50 * DEG
COS4 = np.cos(4 * ANGLES)
SIN4 = np.sin(4 * ANGLES)
SIN_SPLIT = np.sin(4 * (ANGLES - SPLIT_AXIS))
COS_SPLIT = np.cos(4 * (ANGLES - SPLIT_AXIS))
ONE = np.ones(3)
MOUNTING = "misalignment"

Expected = tuple[str, np.ndarray]
"""A channel, and its closed form at each angle."""


def gyro(fmu: GyroFmu, keys: Mapping[str, float], angle: float) -> Gyro:
    device = device_file.from_table(keys, "test")
    return fmu.power_on(device.fmu_parameters(), seed=0, start_angle=angle)


def settled(
    fmu: GyroFmu, keys: Mapping[str, float], inputs: Mapping[str, float], channel: str
) -> np.ndarray:
    """Mean output rate (`bias`) or another output at each angle, after the loops' transient."""
    values = []
    for angle in ANGLES:
        with gyro(fmu, keys, angle) as running:
            for name, value in inputs.items():
                running.command(name, value)
            before = advance(running, 0.0, 20.0)
            bias = (advance(running, 0.0, 20.0) - before) / 20.0
            values.append(bias if channel == "bias" else running.read(channel))
    return np.array(values)


def holds(measured: np.ndarray, expected: np.ndarray, tolerance: float = 0.01) -> bool:
    return bool(np.max(np.abs(measured - expected)) < tolerance * np.max(np.abs(expected)))


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
        ({"coriolis_factor_error_ppm": 20.0}, 20e-6),
        ({"coriolis_factor_error_ppm": -20.0, "coriolis_factor": 0.3}, -20e-6),
    ],
)
def test_scale_factor(fmu: GyroFmu, keys: Mapping[str, float], error: float) -> None:
    """Beside the hold's own -(Ts/2)/tau, to 5e-8, in both directions."""
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


WARMED: dict[str, tuple[Mapping[str, float], str, np.ndarray]] = {
    "D (1 + c dT)": (
        {"damping_anisotropy_per_s": 1e-6, "damping_anisotropy_per_K": 0.05},
        "bias",
        -0.5 * 1e-6 / (4 * K) * SIN4,
    ),
    "tau (1 + c dT)": ({"decay_time_per_K": -1e-4}, "amplitudeForce", 1e-3 / TAU * ONE),
    "phase with split": (
        {**SPLIT, "phase_rad_per_K": 1e-4},
        "bias",
        -DW * 1e-3 / (4 * K) * SIN_SPLIT,
    ),
    "pick-off gain": ({"pickoff_gain_per_K": 1e-5}, "bias", 1e-4 / (4 * K * TAU) * SIN4),
    "frequency": (
        {"frequency_temperature_coefficient_per_K": 8.5e-5, "frequency_Hz": 5000.0},
        "frequencyOffset",
        2 * math.pi * 5000 * 8.5e-4 * ONE,
    ),
}


@pytest.mark.parametrize(("keys", "channel", "change"), WARMED.values(), ids=WARMED.keys())
def test_temperature(
    fmu: GyroFmu, keys: Mapping[str, float], channel: str, change: np.ndarray
) -> None:
    """What 10 K change, once the resonator has followed the case."""
    lagging = {**keys, "thermal_lag_s": 1.0}
    warm = settled(fmu, lagging, WARM, channel)
    assert holds(warm - settled(fmu, lagging, {}, channel), change)


def test_reference_temperature_and_lag(fmu: GyroFmu) -> None:
    """Nothing happens at it; after one lag at 10 K above it, 1 - 1/e of the change has come."""
    keys = {
        "reference_temperature_degC": 40.0,
        "frequency_temperature_coefficient_per_K": 8.5e-5,
        "thermal_lag_s": 30.0,
    }
    with gyro(fmu, keys, 0.1) as running:
        advance(running, 0.0, 20.0)
        assert abs(running.read("frequencyOffset")) < 1e-6
        running.command("caseTemperature", 313.15 + 10.0)
        advance(running, 0.0, 30.0)
        assert running.read("frequencyOffset") == pytest.approx(
            2 * math.pi * 7000 * 8.5e-4 * (1 - math.exp(-1)), rel=1e-3
        )


def test_temperature_rate_bias(fmu: GyroFmu) -> None:
    """0.5 deg/h per K/min at 3 K/min: 1.5 deg/h, the case warming in steps of 10 ms."""
    with gyro(fmu, {"bias_deg_h_per_K_min": 0.5}, 0.1) as running:
        advance(running, 0.0, 10.0)
        before = running.read("gyroAngle")
        for step in range(1, 1001):
            running.command("caseTemperature", 298.15 + 3 / 60 * 0.01 * step)
            advance(running, 0.0, 0.01)
        bias = (running.read("gyroAngle") - before) / 10.0
    assert bias == pytest.approx(1.5 * DEG_PER_H, rel=0.01)


@pytest.mark.parametrize("loop", ["amplitude_loop_rad_s", "quadrature_loop_rad_s"])
def test_loops_are_critically_damped_at_their_frequency(fmu_path: Path, loop: str) -> None:
    """In HRG; the loops of HRGSlow are at rest. A step of the set point of 1e-3 leaves
    (1 - w t) exp(-w t) of it as error (PI, critically damped: the zero overshoots once, at
    t = 1/w it crosses), to 2 % of the step."""
    w = 3.0
    keys = {loop: w} | ({"residual_quadrature": 1e-3} if loop.startswith("quad") else {})
    output = "quadrature" if loop.startswith("quad") else "amplitude"
    aim = 1e-3 if loop.startswith("quad") else 1.0 + 1e-3
    with gyro(GyroFmu(fmu_path), keys, 0.1) as running:
        if output == "amplitude":
            running.command("amplitudeSetpoint", aim)
        for _ in range(20):
            advance(running, 0.0, 0.1)
            t = running.time
            error = aim - running.read(output)
            assert error == pytest.approx(1e-3 * (1 - w * t) * math.exp(-w * t), abs=2e-5)


def test_quantum(fmu: GyroFmu) -> None:
    """Every output is a multiple of it, and within half of it of the same gyro without it."""
    q = 0.5 * ARCSEC
    rates = np.full(500, 1e-4)
    with gyro(fmu, {"quantum_arcsec": 0.5}, 0.1) as rounded, gyro(fmu, {}, 0.1) as plain:
        steps, smooth = drive(rounded, rates, 0.01) / q, drive(plain, rates, 0.01) / q
    assert np.max(np.abs(steps - np.round(steps))) < 1e-6
    assert np.max(np.abs(steps - smooth)) <= 0.5 + 1e-6
    assert np.ptp(steps) > 100


def deviation_of_means(running: Gyro) -> float:
    advance(running, 0.0, 5.0)
    return float(np.std(np.diff(drive(running, np.zeros(401), 1.0)), ddof=1))


def deviation_of_angles(running: Gyro) -> float:
    advance(running, 0.0, 1.0)
    return float(np.std(drive(running, np.zeros(400), 0.1), ddof=1))


@pytest.mark.parametrize(
    ("keys", "measure", "expected"),
    [
        ({"angle_random_walk_deg_sqrt_h": 1e-3}, deviation_of_means, 1e-3 * DEG_PER_SQRT_H),
        ({"angle_white_noise_arcsec": 0.2}, deviation_of_angles, 0.2 * ARCSEC),
    ],
)
def test_white_noises(
    fmu: GyroFmu, keys: Mapping[str, float], measure: Callable[[Gyro], float], expected: float
) -> None:
    """Of 400 values, input-referred, within 3.5 sigma (12 %)."""
    with gyro(fmu, keys, 0.2) as running:
        assert measure(running) == pytest.approx(expected, rel=3.5 / math.sqrt(2 * 400))


def test_slow_noises_are_the_coefficients_of_ieee_952() -> None:
    """K deg/h/sqrt(h), B deg/h in SI; what the FMU makes of them is tested in `test_noise`."""
    keys = {"rate_random_walk_deg_h_sqrt_h": 0.02, "bias_instability_deg_h": 0.003}
    assert device_file.from_table(keys, "test").fmu_parameters() == pytest.approx(
        {
            "noise.rateRandomWalk": 0.02 * DEG / 3600 / 60,
            "noise.biasInstability": 0.003 * DEG / 3600,
        },
        abs=0.0,
    )


def test_every_effect_has_its_test_here() -> None:
    """Each key whose parameter a diagnosis may name is put to the FMU above, but for misalignment,
    which the FMU does not have."""
    text = Path(__file__).read_text(encoding="utf-8")
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
