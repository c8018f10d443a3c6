"""Mechanisms of temperature, bias voltage, mounting, vibration, specific force and ageing, against
their closed forms; numbers as in `test_mechanisms`."""

import math

import pytest

from pyhrg.common.units import DEG
from pyhrg.fmu import GyroFmu
from tests.agreement.mechanisms import TAU, K, at_rest, close
from tests.driving import advance


def test_23_24_temperature(fmu: GyroFmu) -> None:
    """10 K above the reference, lag over: frequency, decay time, D, g and p move as stated."""
    warm = {"caseTemperature": 308.15}
    soak = {"resonator.environment.thermalLag": 1.0}
    omega = 2 * math.pi * 7000

    def run(parameters: dict[str, float]) -> dict[str, dict[str, complex]]:
        return at_rest(fmu, {**soak, **parameters}, warm, settle=20.0)

    frequency = run({"resonator.material.frequencyPerKelvin": 85e-6})
    assert close(frequency["frequencyOffset"]["0"], omega * 85e-5, omega * 85e-5)
    decay = run({"resonator.material.decayTimePerKelvin": -0.003})
    assert close(decay["amplitudeForce"]["0"], 1 / (TAU * 0.97), 1 / TAU)
    d = 1e-6
    damping = run(
        {
            "resonator.material.dampingAnisotropy": d,
            "resonator.material.dampingAnisotropyPerKelvin": 0.01,
        }
    )
    assert close(damping["bias"]["4"], -1.1j * d / (4 * K), d / (4 * K))
    gain = run({"pickOff.gainPerKelvin": 1e-5})
    assert close(gain["bias"]["4"], 1j * 1e-4 / (4 * K * TAU), 1e-4 / (4 * K * TAU))
    dw = 2 * math.pi * 1e-3
    phase = run({"resonator.material.frequencySplit": dw, "pickOff.phasePerKelvin": 1e-4})
    assert close(phase["bias"]["4"], -1j * dw * 1e-3 / (4 * K), dw * 1e-3 / (4 * K))
    bryan = {"resonator.material.bryanFactorPerKelvin": 1e-6, **soak}
    with fmu.power_on(bryan, seed=0, start_angle=0.1) as gyro:
        gyro.command("caseTemperature", 308.15)
        before = advance(gyro, 0.5, 20.0)
        error = (advance(gyro, 0.5, 50.0) - before) / 25 - 1 + 5e-4 / TAU
    assert error == pytest.approx(1e-5, rel=0.02)


def test_24_resonator_follows_the_case_with_its_lag(fmu: GyroFmu) -> None:
    parameters = {
        "resonator.material.frequencyPerKelvin": 1e-5,
        "resonator.environment.thermalLag": 30.0,
    }
    with fmu.power_on(parameters, seed=0, start_angle=0.1) as gyro:
        gyro.command("caseTemperature", 299.15)
        advance(gyro, 0.0, 30.0)
        share = gyro.read("frequencyOffset") / (2 * math.pi * 7000 * 1e-5)
    assert share == pytest.approx(1 - math.exp(-1), rel=1e-3)


def test_24_temperature_rate_bias(fmu: GyroFmu) -> None:
    """1 K/min in steps of 0.1 s: the angle gained is -(e'/2k tau) times the temperature gained."""
    e = 1e-2
    with fmu.power_on({"drive.rotationPerTemperatureRate": e}, seed=0, start_angle=0.1) as gyro:
        advance(gyro, 0.0, 1.0)
        for step in range(600):
            gyro.command("caseTemperature", 298.15 + (step + 1) / 600)
            angle = advance(gyro, 0.0, 0.1)
    assert angle == pytest.approx(-e / (2 * K * TAU), rel=0.02)


def test_25_bias_voltage(fmu: GyroFmu) -> None:
    """Frequency and split move with V^2 - 1, at constant temperature."""
    shift, split, change = 2 * math.pi * 0.1, 2 * math.pi * 1e-2, 1.01**2 - 1
    got = at_rest(
        fmu,
        {
            "resonator.material.electrostaticShift": shift,
            "resonator.material.electrostaticSplit": split,
        },
        {"biasVoltage": 1.01},
    )
    assert close(got["frequencyOffset"]["0"], -shift * change, shift * change)
    assert close(got["frequencyOffset"]["4"], -split * change / 2, split * change)
    assert close(got["quadratureForce"]["4"], 1j * split * change / 2, split * change)


def test_26_mounting_adds_to_damping_anisotropy(fmu: GyroFmu) -> None:
    """As vectors: two equal ones a quarter period apart make sqrt 2 of one."""
    d = 1e-6
    got = at_rest(
        fmu,
        {
            "resonator.material.dampingAnisotropy": d,
            "resonator.material.mountingDamping": d,
            "resonator.material.mountingAxis": 22.5 * DEG,
        },
    )
    assert close(got["bias"]["4"], -1j * (1 + 1j) * d / (4 * K), d / K)


def test_27_vibration_at_the_modal_frequency_is_a_second_harmonic(fmu: GyroFmu) -> None:
    """A force f on x drives the pattern at -(f/2) sin 2th: bias (f/2k) s2."""
    f = 1e-6
    got = at_rest(fmu, {"resonator.imbalanceX": f}, {"vibration": 1.0})
    assert close(got["bias"]["2"], 1j * f / (2 * K), f / (2 * K), 0.02)


def test_28_specific_force(fmu: GyroFmu) -> None:
    """Gain mismatch by a and a^2, force frame by a, split by a."""
    g = 9.8
    gain = at_rest(
        fmu,
        {"pickOff.gainPerAcceleration[1]": 1e-5, "pickOff.gainPerAccelerationSquared[1]": 1e-6},
        {"accelerationX": g},
    )
    scale = 1 / (4 * K * TAU)
    assert close(gain["bias"]["4"], 1j * (1e-5 * g + 1e-6 * g * g) * scale, 1e-4 * scale)
    frame = at_rest(fmu, {"drive.rotationPerAcceleration[3]": 1e-5}, {"accelerationZ": -g})
    assert close(frame["bias"]["0"], 1e-5 * g * 2 * scale, 1e-4 * scale)
    split = at_rest(fmu, {"resonator.material.splitPerAcceleration[2]": 1e-4}, {"accelerationY": g})
    assert close(split["frequencyOffset"]["4"], -1e-4 * g / 2, 1e-3)


def test_31_ageing_shortens_the_decay_time(fmu: GyroFmu) -> None:
    """tau = tau0 exp(-rate t)."""
    rate = 1e-4
    with fmu.power_on(
        {"resonator.material.decayTimeAgeing": rate}, seed=0, start_angle=0.1
    ) as gyro:
        advance(gyro, 0.0, 1000.0)
        assert gyro.read("amplitudeForce") == pytest.approx(math.exp(0.1) / TAU, rel=1e-3)
