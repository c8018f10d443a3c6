"""Mechanism 32: what the FMU computes of an uneven gap, against its integral and closed forms."""

import cmath
import math

import numpy as np
import pytest

from pyhrg.fmu import GyroFmu
from pyhrg.theory.electrode_ring import combine_gap_harmonics, lump_gap_harmonic

NAMES = ("eccentricity", "secondHarmonic", "thirdHarmonic", "fourthHarmonic")
AXES = ("eccentricityAxis", "secondAxis", "thirdAxis", "fourthAxis")
ANGLES = (0.5, 0.8, 1.1, 0.3)


def read_errors(fmu: GyroFmu, electrodes: int, coverage: float, sizes: list[float]) -> np.ndarray:
    """(9,) as of `Electrodes.ringErrors`."""
    parameters = {"ring.electrodes": electrodes, "ring.coverage": coverage}
    parameters |= {f"ring.{name}": size for name, size in zip(NAMES, sizes, strict=True)}
    parameters |= {f"ring.{name}": angle for name, angle in zip(AXES, ANGLES, strict=True)}
    with fmu.power_on(parameters, seed=0, start_angle=0.0) as gyro:
        return np.array([gyro.read(f"ring.errors[{i}]") for i in range(1, 10)])


def integrate_gains(electrodes: int, coverage: float, sizes: list[float]) -> np.ndarray:
    """(2, 2) gains of the pick-offs by 2000 points an electrode."""
    centers = 2 * math.pi * np.arange(electrodes) / electrodes
    inside = (np.arange(2000) + 0.5) / 1000 - 1
    azimuth = centers[:, None] + math.pi / electrodes * coverage * inside
    gap = 1 + sum(sizes[n] * np.cos((n + 1) * (azimuth - ANGLES[n])) for n in range(4))
    weights = np.stack([np.cos(2 * centers), np.sin(2 * centers)])
    modes = np.stack([np.cos(2 * azimuth), np.sin(2 * azimuth)])
    uneven = np.einsum("aj,bji->ab", weights, modes / gap**2)
    return np.asarray(uneven / np.diag(np.einsum("aj,bji->ab", weights, modes))[:, None])


@pytest.mark.parametrize(("electrodes", "coverage"), [(8, 0.9), (8, 0.3), (16, 1.0)])
def test_lumped_errors_make_up_the_integral(fmu: GyroFmu, electrodes: int, coverage: float) -> None:
    """Of a gap that is 10 % uneven: scale, mismatch, non-orthogonality within 2e-6."""
    sizes = [0.1, 0.02, 0.03, 0.04]
    scale, g, d, *_ = read_errors(fmu, electrodes, coverage, sizes)
    lumped = (1 + scale) * np.diag([1 + g / 2, 1 - g / 2]) @ np.array([[1, 0], [d, 1]])
    gains = integrate_gains(electrodes, coverage, sizes)
    assert lumped @ lumped.T == pytest.approx(gains @ gains.T, abs=2e-6)


@pytest.mark.parametrize(("electrodes", "coverage"), [(8, 0.9), (8, 0.3), (16, 1.0)])
def test_lumped_errors_are_the_closed_form(fmu: GyroFmu, electrodes: int, coverage: float) -> None:
    """To 1 % for a gap that is 0.2 % uneven; drives as pick-offs, without a mean bias."""
    sizes = [2e-3, 2e-3, 2e-3, 1e-5]
    first, second, third, fourth = (
        sizes[n] * cmath.exp(1j * (n + 1) * ANGLES[n]) for n in range(4)
    )
    acting = combine_gap_harmonics(first, second, third, fourth)
    expected = lump_gap_harmonic(acting, electrodes, coverage)
    _, g, d, _, gd, nd, e, *_ = read_errors(fmu, electrodes, coverage, sizes)
    scale = max(abs(x) for x in expected)
    assert [g, d] == pytest.approx(expected, abs=0.01 * scale)
    assert [gd, nd] == pytest.approx(expected, abs=0.01 * scale)
    assert d + nd + 2 * e == pytest.approx(0.0, abs=1e-3 * scale)


def test_an_even_gap_makes_no_errors(fmu: GyroFmu) -> None:
    """Exactly: all results keep their bits."""
    assert not np.any(read_errors(fmu, 8, 0.9, [0.0] * 4))
