"""Keys of a device file that state loops, quantization and noise, on the FMU, as `test_devices`."""

import math
from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np
import pytest

from pyhrg.common.units import ARCSEC, DEG, DEG_PER_SQRT_H
from pyhrg.device import device_file
from pyhrg.fmu import Gyro, GyroFmu
from pyhrg.theory.closed_forms import find_largest_filter_delay
from tests.agreement.device_keys import K, gyro
from tests.driving import advance, drive


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


@pytest.mark.parametrize(("share", "holds"), [(0.8, True), (1.25, False)])
def test_a_loop_is_stable_up_to_its_largest_filter_delay(
    fmu_path: Path, share: float, holds: bool
) -> None:
    """The phase loop, which is the fastest, after a step of its set point: it settles, or no longer
    holds the phase within the tolerance of a valid output."""
    delay = share * find_largest_filter_delay(200.0)
    with gyro(GyroFmu(fmu_path), {"filter_delay_s": delay}, 0.1) as running:
        advance(running, 0.0, 0.1)
        running.command("phaseOffset", 0.01)
        advance(running, 0.0, 4.0)
        valid = set()
        for _ in range(50):
            advance(running, 0.0, 0.01)
            valid.add(running.read("valid"))
    assert (valid == {1.0}) == holds


def test_a_filter_takes_noise_away(fmu: GyroFmu) -> None:
    """White noise of the pick-offs, read every 0.1 s: times sqrt(Ts/(Ts + 2 td)), of 400 values
    within 3.5 sigma."""
    delay = 2e-3
    keys = {"angle_white_noise_arcsec": 0.2}
    with gyro(fmu, keys, 0.2) as plain:
        noise = deviation_of_angles(plain)
    with gyro(fmu, {**keys, "filter_delay_s": delay}, 0.2) as filtered:
        ratio = deviation_of_angles(filtered) / noise
    assert ratio == pytest.approx(math.sqrt(1e-3 / (1e-3 + 2 * delay)), rel=3.5 / math.sqrt(400))


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


@pytest.mark.parametrize(("angle", "share"), [(20 + 22.5, 1.0), (20 + 7.5, 0.5), (20.0, 0.0)])
def test_flicker_of_the_damping_goes_with_the_angle(
    fmu: GyroFmu, angle: float, share: float
) -> None:
    """Allan deviation 0.664 B (D/4k) |s4'| of 400 means of 1 s, within 20 %; 1e-3 along the axis,
    where the mean bias turns the pattern by nothing."""
    keys = {
        "damping_anisotropy_per_s": 1e-7,
        "damping_axis_deg": 20.0,
        "damping_anisotropy_flicker": 0.1,
    }
    size = 0.664 * 0.1 * 1e-7 / (4 * K)
    with gyro(fmu, keys, angle * DEG) as running:
        advance(running, 0.0, 5.0)
        means = np.diff(drive(running, np.zeros(401), 1.0))
    deviation = math.sqrt(np.mean(np.diff(means) ** 2) / 2)
    assert deviation == pytest.approx(share * size, rel=0.2, abs=1e-3 * size)


def test_flickers_of_the_electrodes_are_their_coefficients() -> None:
    """What the FMU makes of them is a claim of `HRG.Validation.RandomErrors`."""
    keys = {"pickoff_gain_flicker": 1e-6, "phase_flicker_rad": 2e-6}
    device = device_file.from_table(keys, "test")
    parameters = {"flicker.gainMismatch": 1e-6, "flicker.phaseError": 2e-6}
    assert device.fmu_parameters() == parameters
    assert device.without_noise().fmu_parameters() == {}
