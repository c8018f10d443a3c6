"""The free orbit against the closed forms of its special cases."""

import numpy as np
import pytest

from pyhrg.common.units import DEG
from pyhrg.theory.free_orbit import FreeShell

TIME = np.linspace(1.0, 400.0, 50)


def test_damping_alone_turns_the_pattern_to_its_axis() -> None:
    """tan 2(th - th_tau) = tan 2(th0 - th_tau) exp(D t)."""
    anisotropy, axis, start = 2e-3, 30 * DEG, 40 * DEG
    shell = FreeShell(1 / 450, anisotropy * np.exp(4j * axis), 0j)
    angle, _ = shell.orbit(TIME, start, 0.0)
    expected = np.tan(2 * (start - axis)) * np.exp(anisotropy * TIME)
    assert np.tan(2 * (angle - axis)) == pytest.approx(expected, rel=1e-12)


def test_rotation_alone_turns_the_pattern_for_good() -> None:
    angle, logarithm = FreeShell(1 / 450, 0j, 0j).orbit(TIME, 1.0, 0.02)
    assert angle == pytest.approx(1.0 + 0.02 * TIME, rel=1e-12)
    assert logarithm == pytest.approx(-TIME / 450, rel=1e-12)


def test_amplitude_decays_by_the_axis_it_lies_on() -> None:
    for axis, rate in ((0.0, 1 / 450 + 1e-3), (45 * DEG, 1 / 450 - 1e-3)):
        shell = FreeShell(1 / 450, 2e-3 * np.exp(4j * axis), 0j)
        assert shell.orbit(TIME, 0.0, 0.0)[1] == pytest.approx(-rate * TIME, rel=1e-9)


def test_split_alone_beats() -> None:
    """At 45 modal degrees from the axes quadrature is a sin(dw t/2): the antinode is cos(dw t/2)
    until it is less than the quadrature."""
    split = 3e-3
    shell = FreeShell(0.0, 0j, split + 0j)
    angle, logarithm = shell.orbit(TIME, 22.5 * DEG, 0.0)
    assert angle == pytest.approx(22.5 * DEG, abs=1e-12)
    assert np.exp(logarithm) == pytest.approx(np.cos(split * TIME / 2), rel=1e-9)
