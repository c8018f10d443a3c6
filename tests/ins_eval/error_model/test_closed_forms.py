"""The linear model at rest against closed forms, and against published figures."""

import numpy as np
import pytest

from ins_eval.common import earth
from ins_eval.error_model.dynamics import COUNT, dynamics
from ins_eval.error_model.linear_model import linearize
from ins_eval.error_model.motion import Motion
from ins_eval.navigation.height import Clamped, Free
from pyhrg.common.units import DEG_PER_H
from tests.ins_eval.error_model.cases import propagate

CLAMPED = Clamped(np.zeros(1))
BIAS = 1e-8
"""rad/s."""
FORCE = 1e-4
"""m/s^2."""


def at_rest(latitude_deg: float, height: float, step: float, count: int) -> Motion:
    """Level, heading north."""
    latitude = np.deg2rad(latitude_deg)
    nodes = 4 * count + 1
    rate = earth.RATE * np.array([np.cos(latitude), 0, -np.sin(latitude)])
    return Motion(
        step=step,
        start=0.0,
        latitude=np.full(nodes, latitude),
        height=np.full(nodes, height),
        velocity=np.zeros((nodes, 3)),
        mat_nb=np.tile(np.eye(3), (nodes, 1, 1)),
        rate=np.tile(rate, (nodes, 1)),
        force=np.tile([0, 0, -earth.gravity(latitude, height)], (nodes, 1)),
        turned=rate * step / 4 * np.arange(nodes)[:, None],
    )


def drift(motion: Motion, sensor: int, axis: int, size: float) -> np.ndarray:
    coefficients = np.zeros((2, 3))
    coefficients[sensor, axis] = size
    return propagate(linearize(motion, CLAMPED), np.zeros(COUNT), coefficients)


def schuler(latitude: float) -> tuple[float, float, float]:
    """Frequencies of the north and the east channel, rad/s; gravity."""
    gravity = earth.gravity(latitude, 0.0)
    north = np.sqrt(gravity / earth.meridian_radius(latitude))
    return north, np.sqrt(gravity / earth.transverse_radius(latitude)), gravity


@pytest.mark.parametrize("latitude_deg", [10.0, 45.0, 70.0])
def test_frequencies(latitude_deg: float) -> None:
    """24 h, Schuler split by Foucault, and one that is still: Earth's rate, and Schuler's plus and
    minus Earth's about the vertical (Britting 1971, section 4.1.1)."""
    latitude = np.deg2rad(latitude_deg)
    horizontal = [0, 1, 3, 4, 6, 7, 8]
    f = dynamics(at_rest(latitude_deg, 0.0, 1.0, 1), CLAMPED)[0][np.ix_(horizontal, horizontal)]
    result = np.sort(np.abs(np.linalg.eigvals(f)))
    middle = np.mean(schuler(latitude)[:2])
    vertical = earth.RATE * np.sin(latitude)
    assert result[0] < 1e-3 * earth.RATE
    assert result[1:3] == pytest.approx([earth.RATE] * 2, rel=5e-3)
    assert result[3:] == pytest.approx(
        np.repeat([middle - vertical, middle + vertical], 2), rel=2e-3
    )
    assert np.max(np.abs(np.linalg.eigvals(f).real)) < 1e-5 * middle


def test_free_height_runs_away_by_e_in_565_s() -> None:
    """At the rate sqrt(2 g / R), to 1 % (Groves 2013, section 5.7.2)."""
    f = dynamics(at_rest(45.0, 0.0, 1.0, 1), Free())[0]
    expected = np.sqrt(2 * earth.gravity(np.pi / 4, 0.0) / 6.371e6)
    assert np.max(np.linalg.eigvals(f).real) == pytest.approx(expected, rel=1e-2)


def test_published_up_gyro_bias() -> None:
    """Two independent navigators agree on these to 0.1 % (latitude 34 deg, height 380 m, +0.01
    deg/h up)."""
    result = drift(at_rest(34.0, 380.0, 10.0, 720), 0, 2, -0.01 * DEG_PER_H)[[360, 720], :2]
    assert result == pytest.approx(np.array([[105.06, 8.01], [450.1, 46.7]]), rel=2e-3)


def test_accelerometer_biases_swing() -> None:
    """b / w^2 (1 - cos w t) over half an hour; Earth's rate turns it by some percent
    (Titterton and Weston 2004, Table 12.1)."""
    latitude = np.deg2rad(45.0)
    motion = at_rest(45.0, 0.0, 10.0, 180)
    t = motion.time
    for axis, frequency in enumerate(schuler(latitude)[:2]):
        expected = FORCE / frequency**2 * (1 - np.cos(frequency * t))
        result = drift(motion, 1, axis, FORCE)[:, axis]
        assert np.max(np.abs(result - expected)) < 0.01 * np.max(expected)


@pytest.mark.parametrize("axis", [0, 1, 2], ids=["north", "east", "down"])
def test_gyro_biases_drift_for_a_day(axis: int) -> None:
    """Earth turns a constant bias; Schuler's swing, turned by Foucault, is laid over what builds
    up. To 1 %: (Earth's rate / Schuler's)^2 is 0.4 %."""
    latitude = np.deg2rad(45.0)
    motion = at_rest(45.0, 0.0, 60.0, 1440)
    t = motion.time
    axis_n = np.array([np.cos(latitude), 0, -np.sin(latitude)])
    bias = BIAS * np.eye(3)[axis]
    turning, along_axis = np.cross(axis_n, bias), axis_n * (axis_n @ bias)
    w = earth.RATE
    built_up = (
        along_axis * t[:, None]
        + (bias - along_axis) * np.sin(w * t)[:, None] / w
        - turning * (1 - np.cos(w * t))[:, None] / w
    )
    frequency = np.mean(schuler(latitude)[:2])
    foucault = np.exp(1j * w * np.sin(latitude) * t)
    swing = (1j * bias[0] - bias[1]) * np.sin(frequency * t) / frequency * foucault
    drifted = 1j * built_up[:, 0] - built_up[:, 1] - swing
    radii = earth.meridian_radius(latitude), earth.transverse_radius(latitude)
    expected = np.stack([radii[0] * drifted.real, radii[1] * drifted.imag], axis=-1)
    result = drift(motion, 0, axis, BIAS)[:, :2]
    assert np.max(np.abs(result - expected)) < 0.01 * np.max(np.abs(expected))
