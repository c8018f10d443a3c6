"""Sensitivities from the FMU against closed forms, and against a simulation of a whole flight."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.device.device import Device
from pyhrg.fmu import CONTROL_PERIOD, GyroFmu
from pyhrg.theory import closed_forms
from pyhrg.witness.design import Motion, compute_design, stack_signals
from pyhrg.witness.mechanisms import COUNT, MECHANISMS, NAMES, change_device, find, read_values
from pyhrg.witness.responses import Responses, measure_channels
from tests.pyhrg.witness.flights import GYRO

FOURTH = slice(3, 5)
"""Places of cos 4th and sin 4th among the terms."""
REST, TURNING, ROTATED = 0, 1, 3
"""Places of the motions 1, W and V."""
LINEAR = [each.name for each in MECHANISMS if each.signal == "one" and "residual" not in each.name]
"""Mechanisms whose closed form is that of the bias at rest."""


def differentiate(closed_form: object, name: str) -> np.ndarray:
    """Cosine and sine of a phasor's change per unit of a mechanism."""
    mechanism = MECHANISMS[find(name)]
    changed = mechanism.add(GYRO, mechanism.step)
    phasor = (closed_form(changed) - closed_form(GYRO)) / mechanism.step
    return np.array([phasor.real, phasor.imag])


@pytest.mark.parametrize("name", LINEAR)
def test_bias_at_rest(responses: Responses, name: str) -> None:
    """Fourth harmonic and mean of the output, to 1 % of the largest."""
    found = responses.output[find(name), 0, REST]
    expected = differentiate(closed_forms.static_bias_phasor, name)
    mean = differentiate(lambda d: complex(closed_forms.mean_bias(d)), name)[0]
    size = max(np.abs(found).max(), 1e-9)
    assert found[FOURTH] == pytest.approx(expected, abs=0.01 * size)
    assert found[0] == pytest.approx(mean, abs=0.01 * size)


def test_channels_have_no_noise(slow_fmu: GyroFmu) -> None:
    """A map is read off a simulation of some minutes, in which a random walk of 6e-4 deg/sqrt(h)
    makes harmonics of 2e-3 deg/h."""
    noisy = replace(GYRO, angle_random_walk=1.75e-7)
    quiet, same = measure_channels(slow_fmu, [GYRO.without_noise(), noisy])
    assert np.array_equal(same, quiet)


FORCES_AT_REST = ["damping anisotropy, cosine", "damping anisotropy, sine"]
ELECTRODES = [name for name in NAMES if "mismatch" in name or "orthogonality" in name]


@pytest.mark.parametrize("name", [*FORCES_AT_REST, *ELECTRODES])
def test_amplitude_force(responses: Responses, name: str) -> None:
    """At rest, per rate of the case and per virtual rotation, to 1 %."""
    found = responses.forces[find(name), 0, 0]
    for motion, form in (
        (REST, closed_forms.amplitude_force_phasor),
        (TURNING, closed_forms.turning_amplitude_force_phasor),
        (ROTATED, closed_forms.rotated_amplitude_force_phasor),
    ):
        expected = differentiate(form, name)
        size = max(abs(expected).max(), 1e-3 * np.abs(found).max())
        assert found[motion, FOURTH] == pytest.approx(expected, abs=0.01 * size), motion


def test_heating_of_the_case(responses: Responses) -> None:
    """The bias per rate of temperature is what its name says, and no force tells it at rest."""
    place = find("bias per rate of temperature")
    assert responses.output[place, 0, REST, 0] == pytest.approx(1.0, rel=0.01)
    assert np.abs(responses.forces[place, :, 0, REST]).max() < 1e-3
    assert np.abs(responses.forces[place, 0, 0, ROTATED, 0]) > 10


def test_specific_force(responses: Responses) -> None:
    """The bias per specific force is what its name says, and a pick-off's gain acts as without
    it."""
    bias, gain = find("bias per specific force"), find("pick-off gain per specific force")
    assert responses.output[bias, 0, REST, 0] == pytest.approx(1.0, rel=0.01)
    for found in (responses.output, responses.forces):
        assert found[gain] == pytest.approx(
            found[find("pick-off gain mismatch")], rel=0.01, abs=1e-3 * np.abs(found[gain]).max()
        )


def test_a_specific_force_that_changes(fmu: GyroFmu, responses: Responses) -> None:
    """Amplitude force and output of a gyro at rest whose pick-off gain follows a ramp of the
    specific force, 0.5 m/s^2 a second, to 2 %."""
    row, ramp, name = 0.2, 0.5, "pick-off gain per specific force"
    time = np.arange(0.0, 10.0, CONTROL_PERIOD).reshape(-1, round(row / CONTROL_PERIOD))
    moving = {"angularRate": 0 * time, "accelerationX": ramp * time}
    quiet, recorded = GYRO.without_noise(), []
    for device in (quiet, MECHANISMS[find(name)].add(quiet, 1e-5)):
        with fmu.power_on(device.fmu_parameters(), 0, 0.3) as gyro:
            names = ["gyroAngle", "patternAngle"], ["amplitudeForce"]
            ends, means = gyro.record(moving, {}, CONTROL_PERIOD, *names)
        recorded.append((ends[:, 1], means[:, 0], np.gradient(ends[:, 0], row)))
    (angle, *before), (_, *after) = recorded
    none = 0 * angle
    signals = stack_signals(none, ramp * np.outer(time.mean(axis=1), [1.0, 0.0, 0.0]))
    motion = Motion(row, angle, none, none, none, signals)
    channels = responses.forces[:, :1], responses.output[:, None]
    for sensitivities, unchanged, changed in zip(channels, before, after, strict=True):
        expected = compute_design(sensitivities, motion, responses.angular_gain)[:, 0, find(name)]
        size = np.abs(expected).max()
        assert (changed - unchanged)[5:-2] / 1e-5 == pytest.approx(expected[5:-2], abs=0.02 * size)


def test_the_bias_is_the_slope_of_the_amplitude_force() -> None:
    """B = (1/8k) dG/dth, whatever of damping and electrodes makes it."""
    device = replace(GYRO, phase_error=0.0)
    force = closed_forms.amplitude_force_phasor(device)
    slope = -4j * force / (8 * device.bryan_factor)
    assert closed_forms.static_bias_phasor(device) == pytest.approx(slope, rel=1e-12)


def test_changes_of_a_device_are_read_again() -> None:
    changes = np.array([each.step for each in MECHANISMS])
    changed = change_device(Device(damping_anisotropy=1e-5, damping_axis=0.2), changes)
    unchanged = Device(damping_anisotropy=1e-5, damping_axis=0.2)
    assert read_values(changed) - read_values(unchanged) == pytest.approx(changes, rel=1e-6)
    assert len(changes) == COUNT
