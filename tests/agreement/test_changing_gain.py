"""The amplitude force while a pick-off's gain changes at a constant rate, in both fidelities.

The loop holds the detected amplitude, so that the true one shrinks as the gain g cos 4 th/2 grows:
the mean force over a period is -g'/2 cos 4 th beside (1 - g cos 4 th/2)/tau.
"""

import math

import numpy as np
import pytest

from fmu_build.bundle import build_fmu
from pyhrg.fmu import GyroFmu
from tests.agreement.mechanisms import TAU
from tests.driving import advance

ANGLE = 0.1
RATE = 5e-5
"""Rate of the gain mismatch, 1/s."""
SOAK = {"resonator.environment.thermalLag": 1.0}


@pytest.mark.parametrize("authority", [0.0, 0.2])
@pytest.mark.parametrize(
    ("parameter", "name", "start", "others"),
    [
        ("pickOff.gainPerAcceleration[1]", "accelerationX", 0.0, {}),
        ("pickOff.gainPerKelvin", "caseTemperature", 298.15, SOAK),
    ],
)
def test_the_force_follows_the_gain(
    fmu: GyroFmu,
    parameter: str,
    name: str,
    start: float,
    others: dict[str, float],
    authority: float,
) -> None:
    """Within 0.5 % of the gain's part, read as the mean of all control periods of 0.1 s."""
    step = 1e-3 if fmu.is_sampled else 0.1
    values = {parameter: 1e-3, "drive.authority": authority, **others}
    forces = []
    with fmu.power_on(values, seed=0, start_angle=ANGLE) as gyro:
        for i in range(round(15 / step)):
            gyro.command(name, start + RATE / 1e-3 * i * step)
            advance(gyro, 0.0, step)
            forces.append(gyro.read("amplitudeForce"))
    lag = sum(value for value in others.values())
    g = RATE * (14.95 - lag)
    part = -RATE / 2 * math.cos(4 * ANGLE)
    expected = (1 - g / 2 * math.cos(4 * ANGLE)) / TAU + part
    mean = np.mean(forces[-round(0.1 / step) :])
    assert mean == pytest.approx(expected, abs=5e-3 * abs(part))


@pytest.mark.parametrize("model", ["HRG", "HRGCarrier"])
@pytest.mark.parametrize(
    ("parameter", "output", "slope"),
    [
        ("pickOff.gainPerKelvin", "amplitudeForce", -0.5 * math.cos(4 * ANGLE)),
        ("pickOff.gainPerGradient", "amplitudeForce", -0.5 * math.cos(4 * ANGLE)),
        ("pickOff.phasePerKelvin", "frequencyOffset", 1.0),
    ],
)
def test_a_value_at_samples_of_the_temperature_is_the_mean(
    model: str, parameter: str, output: str, slope: float
) -> None:
    """Gains and phases follow straight lines between samples, every 10 ms: where steps of 10 ms
    end, loops show what their mean over all control periods is, within 1 % (steps of the gain would
    make it 5 %, and 4 times the whole for the phase)."""
    gyro_fmu, per_kelvin = GyroFmu(build_fmu(model)), 1e-4
    lag = 1e4 if "Gradient" in parameter else 1.0
    duration = 3.0 if model == "HRG" else 0.6
    shown = {}
    for step in (1e-3, 1e-2):
        changes = []
        for value in (0.0, per_kelvin):
            values = {parameter: value, "resonator.environment.thermalLag": lag}
            with gyro_fmu.power_on(values, seed=0, start_angle=ANGLE) as gyro:
                readings = []
                for i in range(round(duration / step)):
                    gyro.command("caseTemperature", 298.15 + 0.5 * round(i * step, 2))
                    advance(gyro, 0.0, step)
                    readings.append(gyro.read(output))
            changes.append(np.mean(readings[-round(0.1 / step) :]))
        shown[step] = changes[1] - changes[0]
    assert shown[1e-2] == pytest.approx(shown[1e-3], abs=1e-2 * abs(slope) * per_kelvin * 0.5)
