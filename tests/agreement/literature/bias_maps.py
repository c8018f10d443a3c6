"""Improvements of the bias over the pattern angle: by force, by trimmed mass, by an even gap."""

import math
from collections.abc import Mapping

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG, DEG_PER_H, HZ
from tests.agreement.paper.gyros import TAU, K, simulate_output_rate

ANGLES = np.arange(16) * math.pi / 16
CANCELLATION = "controller.cancellation."
RESONATOR = {
    "resonator.material.dampingAnisotropy": 0.01 / TAU,
    "resonator.material.dampingAxis": 20 * DEG,
    "resonator.material.frequencySplit": 0.01 * HZ,
    "resonator.material.stiffnessAxis": 50 * DEG,
    "pickOff.phaseError": 1e-3,
}
"""1 % of damping anisotropy, a split of 10 mHz read 1 mrad out of phase."""
DEFECTS = "resonator.massDefects."
HARMONICS = {"first": 2e-3, "second": 1e-3, "third": 1e-3}
KEPT = {"first": 1 - 0.928, "second": 1 - 0.893, "third": 1 - 0.755}
"""Shares that the published trimming left of the first three harmonics."""
UNCOMPENSATED, DELAYED = 62.52, 9.72
"""Published bias over the pattern angle, deg/h, before and with the damping taken out alone."""
EARTH = 15.04 * DEG_PER_H
DEAD_ZONE = 25 * DEG_PER_H
VIRTUAL_ROTATION = 1 * DEG


def figures() -> dict[str, float]:
    """Ratios of bias amplitudes, and output over input in a dead zone."""
    return {
        **_iterate_cancellation(),
        **_trim_mass(),
        **_even_gap(),
        **_dead_zone(),
        "delay_angle_deg": math.asin(DELAYED / UNCOMPENSATED / 2) / 2 / DEG,
    }


def simulate_map(parameters: Mapping[str, float]) -> Array:
    """(16,) output bias at rest over half a turn of the pattern, rad/s."""
    return np.array([simulate_output_rate(parameters, float(a), settle=10.0) for a in ANGLES])


def _spread(bias: Array) -> float:
    return float(np.ptp(bias))


def _iterate_cancellation() -> dict[str, float]:
    """The fourth harmonic of the map, measured, driven against, measured again; peak to peak."""
    driven, spreads = 0j, []
    for _ in range(2):
        force = {
            CANCELLATION + "dampingAnisotropy": abs(driven),
            CANCELLATION + "dampingAxis": float(np.angle(driven)) / 4,
        }
        bias = simulate_map({**RESONATOR, **force})
        spreads.append(_spread(bias))
        driven += 4j * K * 2 * complex(np.mean(bias * np.exp(4j * ANGLES)))
    before, after = spreads
    return {"uncancelled_deg_h": before / DEG_PER_H, "cancelled_ratio": before / after}


def _trim_mass() -> dict[str, float]:
    """Bias by support loss, over that after trimming; the loss coefficients cancel."""

    def spread(loss: str, shares: Mapping[str, float]) -> float:
        masses = {DEFECTS + name: size * shares[name] for name, size in HARMONICS.items()}
        return _spread(simulate_map({**masses, DEFECTS + loss: 100.0}))

    raw = dict.fromkeys(HARMONICS, 1.0)
    return {
        f"trimmed_{loss}": spread(loss, raw) / spread(loss, KEPT)
        for loss in ("lateralLoss", "axialLoss")
    }


def _even_gap() -> dict[str, float]:
    """Bias of a gap of 5 % eccentricity, and of 0.5 % of the fourth harmonic, deg/h."""
    return {
        f"gap_{name}_deg_h": _spread(simulate_map({f"ring.{name}": size})) / DEG_PER_H
        for name, size in (("eccentricity", 0.05), ("fourthHarmonic", 0.005))
    }


def _dead_zone() -> dict[str, float]:
    """Output over Earth's rate in a dead zone of 25 deg/h, without and with virtual rotation."""
    gyro = {"resonator.material.dampingAnisotropy": 4 * K * DEAD_ZONE}

    def gain(rotation: float, settle: float, duration: float) -> float:
        rate = simulate_output_rate(
            gyro, 0.0, EARTH, settle, duration, "HRGSlow", virtualRotation=rotation
        )
        return rate / EARTH

    period = 2 * math.pi / (4 * K * (VIRTUAL_ROTATION - EARTH))
    return {
        "earth_locked": gain(0.0, 1e5, 100.0),
        "earth_rotated": gain(VIRTUAL_ROTATION, 100.0, round(10 * period, 1)),
    }
