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
from pyhrg.fmu import Gyro, GyroFmu
from tests.driving import advance, drive

K = 0.277
TAU = 450.0
CHANNELS = ("amplitudeForce", "quadratureForce", "frequencyOffset")
ANGLES = np.arange(16) * 11.25 * DEG
"""Half a turn of the pattern: harmonics 2, 4 and 8 are orthogonal over it."""


def harmonics(values: np.ndarray) -> dict[str, complex]:
    """Mean and complex amplitudes: value = mean + Re sum H_n exp(-i n th)."""
    result: dict[str, complex] = {"0": complex(np.mean(values))}
    for n in (2, 4, 6, 8):
        result[str(n)] = complex(2 * np.mean(values * np.exp(1j * n * ANGLES)))
    return result


def at_rest(
    fmu: GyroFmu,
    parameters: Mapping[str, float],
    inputs: Mapping[str, float] | None = None,
    settle: float = 10.0,
    dwell: float = 20.0,
) -> dict[str, dict[str, complex]]:
    """Harmonics of output bias and channels over the circumference, the case at rest."""
    table: dict[str, list[float]] = {name: [] for name in ("bias", *CHANNELS)}
    for angle in ANGLES:
        with fmu.power_on(parameters, seed=0, start_angle=angle) as gyro:
            for name, value in (inputs or {}).items():
                gyro.command(name, value)
            settled = advance(gyro, 0.0, settle)
            table["bias"].append((advance(gyro, 0.0, dwell) - settled) / dwell)
            for name in CHANNELS:
                table[name].append(gyro.read(name))
    return {name: harmonics(np.array(values)) for name, values in table.items()}


def read_angle_error(fmu: GyroFmu, parameters: Mapping[str, float]) -> dict[str, complex]:
    """Harmonics of the error of the angle read, by parking the pattern at known angles.

    The gyro's angle right after power-on is the read-out's error: no time for anything to drift.
    """
    errors = []
    for angle in ANGLES:
        with fmu.power_on(parameters, seed=0, start_angle=angle) as gyro:
            errors.append(gyro.read("gyroAngle"))
    return harmonics(np.array(errors))


def close(got: complex, expected: complex, scale: float, tolerance: float = 0.01) -> bool:
    return abs(got - expected) <= tolerance * abs(scale)


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


@pytest.mark.parametrize("delay", [0.0, 5e-4, 3e-3])
def test_15_loop_delay_is_a_scale_factor_error(fmu: GyroFmu, delay: float) -> None:
    """-(Ts/2 + td)/tau, odd in the rate."""
    for rate in (0.5, -0.5):
        with fmu.power_on(
            {"controller.synthesis.loopDelay": delay}, seed=0, start_angle=0.1
        ) as gyro:
            error = advance(gyro, rate, 50.0) / (50 * rate) - 1
        assert error == pytest.approx(-(5e-4 + delay) / TAU, abs=5e-8)


def turning(fmu: GyroFmu, parameters: Mapping[str, float], rate: float = 0.5) -> float:
    """Scale-factor error after 50 s, the hold's taken out."""
    with fmu.power_on(parameters, seed=0, start_angle=0.1) as gyro:
        return advance(gyro, rate, 50.0) / (50 * rate) - 1 + 5e-4 / TAU


def test_16_bryan_factor_error_is_a_scale_factor_error(fmu: GyroFmu) -> None:
    error = turning(fmu, {"resonator.material.bryanFactor": 0.277 * (1 + 20e-6)})
    assert error == pytest.approx(20e-6, rel=0.01)


def test_17_clock_error_leaves_the_angle_and_scales_the_rate(fmu: GyroFmu) -> None:
    with fmu.power_on({"controller.readout.clockError": 1e-4}, seed=0, start_angle=0.1) as gyro:
        angle = advance(gyro, 0.5, 50.0)
        assert angle / 25 - 1 == pytest.approx(-5e-4 / TAU, abs=1e-7)
        assert gyro.read("gyroRate") / 0.5 - 1 == pytest.approx(-1e-4, rel=0.02)
        assert gyro.read("frequencyOffset") == pytest.approx(-1e-4 * 2 * math.pi * 7000, rel=1e-3)


@pytest.mark.parametrize("direction", [1, -1])
def test_18_virtual_rotation_error_flips_with_the_rotation(fmu: GyroFmu, direction: int) -> None:
    """B = -e V/k, V the pattern rate: -e times the commanded input rate."""
    rate, e = direction * 1.0 * DEG, 1e-4
    with fmu.power_on(
        {"controller.readout.virtualRotationError": e}, seed=0, start_angle=0.1
    ) as gyro:
        gyro.command("virtualRotation", rate)
        settled = advance(gyro, 0.0, 10.0)
        bias = (advance(gyro, 0.0, 40.0) - settled) / 40.0
    assert bias == pytest.approx(-e * rate, rel=0.02)


def test_18_rotation_noise_is_a_random_walk(fmu: GyroFmu) -> None:
    """400 means of 0.5 s, N = V s, within 3.5 sigma."""
    rate, noise = 10 * DEG, 1e-4
    with fmu.power_on({"noise.virtualRotation": noise}, seed=4, start_angle=0.1) as gyro:
        gyro.command("virtualRotation", rate)
        advance(gyro, 0.0, 5.0)
        means = np.diff(drive(gyro, np.zeros(401), 0.5)) / 0.5
    expected = rate * noise / math.sqrt(0.5)
    assert np.std(means, ddof=1) == pytest.approx(expected, rel=3.5 / math.sqrt(800))


def locked_angle(gyro: Gyro, rate: float, seconds: float) -> float:
    advance(gyro, rate, seconds)
    return gyro.read("patternAngle")


def test_19_lock_in_follows_adler(fmu: GyroFmu) -> None:
    """Below W_L = D/4k the pattern stops where sin 4(th - th_tau) = W/W_L; above, free precession
    has the mean rate sqrt(W^2 - W_L^2), while an imposed uniform turn has none."""
    d = 1e-2
    limit = d / (4 * K)
    parameters = {"resonator.material.dampingAnisotropy": d}
    with fmu.power_on(parameters, seed=0, start_angle=0.1) as gyro:
        angle = locked_angle(gyro, 0.5 * limit, 3000.0)
        held = advance(gyro, 0.5 * limit, 100.0)
        assert gyro.read("patternAngle") == pytest.approx(angle, abs=1e-6)
        assert math.sin(4 * angle) == pytest.approx(0.5, rel=0.02)
        assert held == pytest.approx((0.1 - angle) / K, rel=1e-3)
    period = 2 * math.pi / (4 * K * math.sqrt(3) * limit)
    with fmu.power_on(parameters, seed=0, start_angle=0.1) as gyro:
        before = advance(gyro, 2 * limit, 50.0)
        mean = (advance(gyro, 2 * limit, period) - before) / period
    assert mean == pytest.approx(math.sqrt(3) * limit, rel=1e-3)


def test_20_random_walk_grows_as_the_amplitude_falls(fmu: GyroFmu) -> None:
    """N ~ 1/a: 400 means of 1 s at half amplitude."""
    parameters = {"noise.angleRandomWalk": 1e-6, "startAmplitude": 0.5}
    with fmu.power_on(parameters, seed=5, start_angle=0.1) as gyro:
        gyro.command("amplitudeSetpoint", 0.5)
        advance(gyro, 0.0, 5.0)
        means = np.diff(drive(gyro, np.zeros(401), 1.0))
    assert np.std(means, ddof=1) == pytest.approx(2e-6, rel=3.5 / math.sqrt(800))


def test_22_rate_random_walk(fmu: GyroFmu) -> None:
    """Means of 1 s walk by K each second: 300 differences, within 3.5 sigma; the mean of a second
    smooths the walk within it, variance 2/3."""
    with fmu.power_on({"noise.rateRandomWalk": 1e-6}, seed=6, start_angle=0.1) as gyro:
        advance(gyro, 0.0, 5.0)
        means = np.diff(drive(gyro, np.zeros(302), 1.0))
    steps = np.diff(means)
    expected = 1e-6 * math.sqrt(2 / 3)
    assert np.std(steps, ddof=1) == pytest.approx(expected, rel=3.5 / math.sqrt(600) * 1.3)


def test_22_flicker_has_a_flat_allan_deviation(fmu: GyroFmu) -> None:
    """0.664 B at 0.3 to 10 s, within 25 % (2000 s of record)."""
    b = 1e-6
    with fmu.power_on({"noise.biasInstability": b}, seed=7, start_angle=0.1) as gyro:
        advance(gyro, 0.0, 20.0)
        rates = np.diff(drive(gyro, np.zeros(20_001), 0.1)) / 0.1
    for m in (3, 10, 30, 100):
        means = rates[: len(rates) // m * m].reshape(-1, m).mean(axis=1)
        deviation = math.sqrt(0.5 * np.mean(np.diff(means) ** 2))
        assert deviation == pytest.approx(0.664 * b, rel=0.25)


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


def test_30_resolution_and_full_scale(fmu: GyroFmu) -> None:
    """A coarse converter makes the angle step; a small full scale spoils it and drops `valid`."""
    with fmu.power_on({"pickOff.resolution": 1e-3}, seed=0, start_angle=0.3) as gyro:
        angles = drive(gyro, np.full(2000, 0.01), 1e-3)
    assert 1 < len(np.unique(angles)) < 400
    with fmu.power_on({"pickOff.fullScale": 0.5}, seed=0, start_angle=0.0) as gyro:
        advance(gyro, 0.0, 5.0)
        assert gyro.read("valid") == 0
        assert gyro.read("amplitude") <= 0.5 * math.sqrt(2)


def test_31_ageing_shortens_the_decay_time(fmu: GyroFmu) -> None:
    """tau = tau0 exp(-rate t)."""
    rate = 1e-4
    with fmu.power_on(
        {"resonator.material.decayTimeAgeing": rate}, seed=0, start_angle=0.1
    ) as gyro:
        advance(gyro, 0.0, 1000.0)
        assert gyro.read("amplitudeForce") == pytest.approx(math.exp(0.1) / TAU, rel=1e-3)
