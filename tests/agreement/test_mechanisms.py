"""Every mechanism of the gyro alone, against its closed form: harmonic, channel, dependence.

Numbers are those of the catalogue of error mechanisms (`HRG.UsersGuide.Mechanisms`). c4, s4 are
cos and sin of four pattern angles; D, g, ... as in docs/conventions.md. One parameter is set at a
time, at rest or turning, and each channel is fitted by harmonics of the pattern angle.
"""

import math
from collections.abc import Mapping

import numpy as np
import pytest

from pyhrg.common.units import DEG
from pyhrg.fmu import GyroFmu
from tests.agreement.mechanisms import ANGLES, TAU, K, at_rest, close, harmonics
from tests.driving import advance, drive


def read_angle_error(fmu: GyroFmu, parameters: Mapping[str, float]) -> dict[str, complex]:
    """Harmonics of the error of the angle read, by parking the pattern at known angles.

    The gyro's angle right after power-on is the read-out's error: no time for anything to drift.
    """
    errors = []
    for angle in ANGLES:
        with fmu.power_on(parameters, seed=0, start_angle=angle) as gyro:
            errors.append(gyro.read("gyroAngle"))
    return harmonics(np.array(errors))


def test_1_damping_anisotropy(fmu: GyroFmu) -> None:
    """B = -(D/4k) s4', growth rate 1/tau + (D/2) c4', nothing else."""
    d, axis = 1e-6, 20 * DEG
    got = at_rest(
        fmu,
        {"resonator.material.dampingAnisotropy": d, "resonator.material.dampingAxis": axis},
    )
    phasor = np.exp(4j * axis)
    assert close(got["bias"]["4"], -1j * phasor * d / (4 * K), d / (4 * K))
    assert close(got["amplitudeForce"]["4"], d / 2 * phasor, d)
    assert abs(got["quadratureForce"]["4"]) < 0.01 * d
    assert abs(got["frequencyOffset"]["4"]) < 0.01 * d


@pytest.mark.parametrize(
    ("name", "value", "angle"),
    [("gainMismatch", 1e-3, 1j / (4 * K)), ("nonOrthogonality", 1e-3, -1 / (4 * K))],
)
def test_2_4_pickoff_errors_turn_the_angle_read(
    fmu: GyroFmu, name: str, value: float, angle: complex
) -> None:
    """Rate error -g W c4 and -d W s4, dth = -kW dt: angle error (g/4k) s4, -(d/4k)(1 + c4)."""
    got = read_angle_error(fmu, {f"pickOff.{name}": value})
    assert close(got["4"], angle * value, value, 0.02)


@pytest.mark.parametrize(
    ("parameter", "bias", "growth"),
    [
        ("pickOff.gainMismatch", 1j, -0.5),
        ("drive.gainMismatch", 1j, -0.5),
        ("pickOff.nonOrthogonality", -1, -0.5j),
        ("drive.nonOrthogonality", -1, -0.5j),
    ],
)
def test_2_to_5_misaimed_amplitude_force(
    fmu: GyroFmu, parameter: str, bias: complex, growth: complex
) -> None:
    """B = (g/4k tau) s4 or -(d/4k tau)(1 + c4); growth rate -(g/2) c4/tau, -(d/2) s4/tau."""
    e = 1e-3
    got = at_rest(fmu, {parameter: e})
    scale = e / (4 * K * TAU)
    assert close(got["bias"]["4"], bias * scale, scale)
    assert close(got["bias"]["0"], bias.real * scale, scale)
    assert close(got["amplitudeForce"]["4"], growth * e / TAU, e / TAU)


def test_6_frame_rotation_is_a_constant_bias(fmu: GyroFmu) -> None:
    """-(e/2k tau)."""
    e = 1e-3
    got = at_rest(fmu, {"drive.frameRotation": e})
    scale = e / (2 * K * TAU)
    assert close(got["bias"]["0"], -scale, scale)
    assert abs(got["bias"]["4"]) < 0.01 * scale


def test_7_frequency_split_and_phase_error(fmu: GyroFmu) -> None:
    """B = -(dw p/4k) s4'', quadrature force (dw/2) s4'', frequency -(dw/2) c4''."""
    dw, p, axis = 2 * math.pi * 1e-3, 1e-3, 30 * DEG
    got = at_rest(
        fmu,
        {
            "resonator.material.frequencySplit": dw,
            "resonator.material.stiffnessAxis": axis,
            "pickOff.phaseError": p,
        },
    )
    phasor = np.exp(4j * axis)
    assert close(got["bias"]["4"], -1j * phasor * dw * p / (4 * K), dw * p / (4 * K))
    assert close(got["quadratureForce"]["4"], 1j * phasor * dw / 2, dw)
    assert close(got["frequencyOffset"]["4"], -phasor * dw / 2, dw)


def test_7_commanded_phase_offset_does_the_same(fmu: GyroFmu) -> None:
    dw, p = 2 * math.pi * 1e-3, 1e-2
    got = at_rest(fmu, {"resonator.material.frequencySplit": dw}, {"phaseOffset": p})
    assert close(got["bias"]["4"], -1j * dw * p / (4 * K), dw * p / (4 * K))


def test_8_residual_quadrature(fmu: GyroFmu) -> None:
    """B = -(dw/2k)(q0/a) c4''; the quadrature force holds q0/tau against its decay."""
    dw, q0 = 2 * math.pi * 1e-3, 1e-3
    got = at_rest(
        fmu,
        {"resonator.material.frequencySplit": dw, "controller.quadratureSetpoint": q0},
    )
    scale = dw * q0 / (2 * K)
    assert close(got["bias"]["4"], -scale, scale, 0.02)
    constant = at_rest(fmu, {"controller.quadratureSetpoint": q0})
    assert close(constant["quadratureForce"]["0"], q0 / TAU, q0 / TAU)


def test_10_differential_phase_with_split_is_an_eighth_harmonic(fmu: GyroFmu) -> None:
    """8th harmonic of amplitude dw p/16k; quadrature force and frequency keep their 4th."""
    dw, p = 2 * math.pi * 1e-3, 1e-2
    got = at_rest(
        fmu,
        {"resonator.material.frequencySplit": dw, "pickOff.differentialPhase": p},
    )
    scale = dw * p / (16 * K)
    assert abs(got["bias"]["8"]) == pytest.approx(scale, rel=0.05)
    assert abs(got["bias"]["4"]) < 0.1 * scale


def test_11_feedthrough_with_split_is_an_eighth_harmonic(fmu: GyroFmu) -> None:
    """The quadrature force (dw/2) s4 read as quadrature leaves -c (dw/2) s4 of it standing, which
    drifts as in 8: B = (c dw^2/8k) s8."""
    c, dw = 1e-3, 2 * math.pi * 1e-3
    got = at_rest(fmu, {"resonator.material.frequencySplit": dw, "pickOff.feedthrough": c})
    scale = c * dw**2 / (8 * K)
    assert close(got["bias"]["8"], 1j * scale, scale, 0.02)
    assert abs(got["bias"]["4"]) < 0.05 * scale


def test_12_demodulation_offset_is_a_second_harmonic(fmu: GyroFmu) -> None:
    """O: (x0/a)/2k in angle; at rest (x0/a)/(2k tau); both 2nd harmonic."""
    x0 = 1e-4
    read = read_angle_error(fmu, {"pickOff.offset": x0})
    assert abs(read["2"]) == pytest.approx(x0 / (2 * K), rel=0.01)
    got = at_rest(fmu, {"pickOff.offset": x0})
    assert abs(got["bias"]["2"]) == pytest.approx(x0 / (2 * K * TAU), rel=0.02)
    assert abs(got["bias"]["4"]) < 0.01 * x0 / (2 * K * TAU)


def test_13_cubic_nonlinearity_is_an_eighth_harmonic_of_the_angle(fmu: GyroFmu) -> None:
    """Rate error 0.75 b a^2 W at the 8th harmonic, that is 0.75 b/(8k) of angle; goes with a^2."""
    b = 1e-3
    read = read_angle_error(fmu, {"pickOff.cubic": b})
    assert abs(read["8"]) == pytest.approx(0.75 * b / (8 * K), rel=0.02)
    assert abs(read["4"]) < 0.02 * b
    half = read_angle_error(fmu, {"pickOff.cubic": b, "startAmplitude": 0.5})
    assert abs(half["8"]) == pytest.approx(abs(read["8"]) / 4, rel=0.02)


def test_14_duffing_with_quadrature_is_a_constant_bias(fmu: GyroFmu) -> None:
    """+delta a q/(3k), delta = 3 gamma/8w the shift at unit amplitude; frequency moves with a^2.

    The catalogue prints -gamma a q/(8 k w): the size is the same, the sign is that of the wave."""
    delta, q = 0.05, 1e-3
    got = at_rest(fmu, {"resonator.material.duffing": delta, "controller.quadratureSetpoint": q})
    assert close(got["bias"]["0"], delta * q / (3 * K), delta * q / (3 * K), 0.02)
    assert close(got["frequencyOffset"]["0"], delta, delta)
    quarter = at_rest(
        fmu,
        {"resonator.material.duffing": delta, "startAmplitude": 0.5},
        {"amplitudeSetpoint": 0.5},
    )
    assert close(quarter["frequencyOffset"]["0"], delta / 4, delta / 4)


def test_33_electrostatic_cubic_is_an_eighth_harmonic(fmu: GyroFmu) -> None:
    """N = (delta/4) s8 and P = -delta (3 + c8)/4, with V^2; nothing in the fourth."""
    delta, voltage = 0.02, 1.1
    got = at_rest(fmu, {"resonator.material.electrostaticCubic": delta}, {"biasVoltage": voltage})
    size = delta * voltage**2
    assert close(got["quadratureForce"]["8"], 1j * size / 4, size)
    assert close(got["frequencyOffset"]["0"], -0.75 * size, size)
    assert close(got["frequencyOffset"]["8"], -size / 4, size)
    assert abs(got["quadratureForce"]["4"]) < 1e-3 * size


def test_30_resolution_and_full_scale(fmu: GyroFmu) -> None:
    """A coarse converter makes the angle step; a small full scale spoils it and drops `valid`."""
    with fmu.power_on({"pickOff.resolution": 1e-3}, seed=0, start_angle=0.3) as gyro:
        angles = drive(gyro, np.full(2000, 0.01), 1e-3)
    assert 1 < len(np.unique(angles)) < 400
    with fmu.power_on({"pickOff.fullScale": 0.5}, seed=0, start_angle=0.0) as gyro:
        advance(gyro, 0.0, 5.0)
        assert gyro.read("valid") == 0
        assert gyro.read("amplitude") <= 0.5 * math.sqrt(2)
