"""Eq. (1): bias by damping and stiffness anisotropy (section 1.2), re-derived and on the FMU."""

import math

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG, DEG_PER_H, HZ
from tests.agreement.paper.gyros import (
    DAMPING,
    DAMPING_AXIS,
    QUADRATURE,
    SPLIT,
    STIFFNESS_AXIS,
    K,
    simulate_output_rate,
)

ANGLES = np.arange(2.5, 90.0, 7.5) * DEG
DAMPING_AT, STIFFNESS_AT = 10 * DEG, 40 * DEG
"""Axes of the gyros here: of maximum damping, of lower frequency."""
AXES = {DAMPING_AXIS: DAMPING_AT, STIFFNESS_AXIS: STIFFNESS_AT}
STATES = 1000


def figures() -> dict[str, float]:
    """Derivation, damping term, quadrature term, and the mean over a turn."""
    return {**_derivation(), **_damping_term(), **_quadrature_term(), **_mean_over_a_turn()}


def damping_rate(anisotropy: float, angle: Array) -> Array:
    """d theta/dt by damping at Q = 0, rad/s: (D/4) sin 4(theta - theta_tau)."""
    return np.asarray(anisotropy / 4 * np.sin(4 * (angle - DAMPING_AT)))


def stiffness_rate(split: float, angle: Array) -> Array:
    """d theta/dt by stiffness over Q/L, rad/s: (dw/4) cos 4(theta - theta_w)."""
    return np.asarray(split / 4 * np.cos(4 * (angle - STIFFNESS_AT)))


def _derivation() -> dict[str, float]:
    """The envelope's rate of theta at random states, with nothing left out, against the formula.

    X = (a cos 2theta + i q sin 2theta) e^(i phi), Y = (a sin 2theta - i q cos 2theta) e^(i phi);
    R = |X|^2 - |Y|^2, S = 2 Re(X Y*), theta = atan2(S, R)/4; E = a^2 + q^2, Q = 2aq.
    """
    generator = np.random.default_rng(1)
    angle, phase = generator.uniform(-math.pi, math.pi, (2, STATES))
    a, q = generator.uniform(0.5, 1.0, STATES), generator.uniform(-0.4, 0.4, STATES)
    d, split = 1e-3, 2e-3
    turn = np.exp(1j * phase)
    x = (a * np.cos(2 * angle) + 1j * q * np.sin(2 * angle)) * turn
    y = (a * np.sin(2 * angle) - 1j * q * np.cos(2 * angle)) * turn
    along = d / 2 * np.cos(4 * DAMPING_AT) + 0.5j * split * np.cos(4 * STIFFNESS_AT)
    across = d / 2 * np.sin(4 * DAMPING_AT) + 0.5j * split * np.sin(4 * STIFFNESS_AT)
    dx, dy = -(along * x + across * y), -(across * x - along * y)
    r, s = np.abs(x) ** 2 - np.abs(y) ** 2, 2 * (x * y.conj()).real
    dr, ds = 2 * (x.conj() * dx - y.conj() * dy).real, 2 * (dx * y.conj() + x * dy.conj()).real
    exact = (r * ds - s * dr) / (4 * (r**2 + s**2))
    length = a**2 - q**2
    formula = damping_rate(d, angle) * (a**2 + q**2) / length
    formula = formula + stiffness_rate(split, angle) * 2 * a * q / length
    return {"eq1_derivation_departure": float(np.max(np.abs(exact - formula)) / (d / 4))}


def _damping_term() -> dict[str, float]:
    """Bias of the FMU at rest over the circumference, against Eq. (1) mended step by step.

    A departure is the largest over the angles, in units of the true amplitude D/4k.
    """
    d = 1e-4
    bias = np.array([simulate_output_rate({DAMPING: d, **AXES}, angle) for angle in ANGLES])
    true = d / (4 * K)
    printed = d / 2 * np.sin(4 * (ANGLES - STIFFNESS_AT))
    axis = d / 2 * np.sin(4 * (ANGLES - DAMPING_AT))
    steps = {
        "printed": printed,
        "axis": axis,
        "axis_sign": -axis,
        "corrected": -damping_rate(d, ANGLES) / K,
    }
    wave = -K * np.polynomial.polynomial.polyfit(np.sin(4 * (ANGLES - DAMPING_AT)), bias, 1)[1] / d
    return {
        **{f"eq1_{name}_departure": _largest(bias - form) / true for name, form in steps.items()},
        "eq1_wave_coefficient": float(wave),
        "eq1_output_coefficient": float(wave) / K,
        "eq1_carrier_departure": _carrier_departure(),
    }


def _carrier_departure() -> float:
    """The corrected form against the vibration at its carrier, nothing averaged."""
    d, angles = 1e-2, ANGLES[::3]
    bias = [
        simulate_output_rate({DAMPING: d, **AXES}, angle, 0.0, 3.0, 0.2, "HRGCarrier")
        for angle in angles
    ]
    moved = angles - K * np.array(bias) * 3.1
    return _largest(np.array(bias) + damping_rate(d, moved) / K) / (d / (4 * K))


def _quadrature_term() -> dict[str, float]:
    """Bias with a quadrature that the loop leaves, against the second term."""
    split, q = 1e-3 * HZ, 1e-3
    parameters = {SPLIT: split, QUADRATURE: q, **AXES}
    bias = np.array([simulate_output_rate(parameters, angle, settle=10.0) for angle in ANGLES])
    corrected = -stiffness_rate(split, ANGLES) * 2 * q / K
    amplitude = split * q / (2 * K)
    return {
        "eq1_quadrature_departure": _largest(bias - corrected) / amplitude,
        "eq1_quadrature_other_axis_departure": _largest(bias + corrected) / amplitude,
    }


def _mean_over_a_turn() -> dict[str, float]:
    """Mean bias over the circumference: of positions that are imposed, and of free precession.

    Free, d theta/dt = -kW + (D/4) sin 4(theta - theta_tau): the mean output rate is
    sqrt(W^2 - W_L^2), W_L = D/4k (Adler).
    """
    limit, earth = 1 * DEG_PER_H, 15.04 * DEG_PER_H
    parameters = {DAMPING: 4 * K * limit}
    imposed = np.mean(
        [simulate_output_rate(parameters, angle, 0.0, 10.0, 10.0, "HRGSlow") for angle in ANGLES]
    )
    mean = math.sqrt(earth**2 - limit**2)
    period = 2 * math.pi / (4 * K * mean)
    free = simulate_output_rate(parameters, 0.0, earth, 100.0, round(period, 1), "HRGSlow")
    fast = 5 * DEG
    return {
        "imposed_mean_deg_h": float(imposed) / DEG_PER_H,
        "adler_shortfall_deg_h": (mean - earth) / DEG_PER_H,
        "free_shortfall_deg_h": (free - earth) / DEG_PER_H,
        "adler_shortfall_5_deg_s_deg_h": -(limit**2) / (2 * fast) / DEG_PER_H,
    }


def _largest(departure: Array) -> float:
    return float(np.max(np.abs(departure)))
