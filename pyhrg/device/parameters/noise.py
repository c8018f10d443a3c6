"""Noise of a gyro: coefficients of IEEE Std 952, input-referred."""

import math
from dataclasses import dataclass

from pyhrg.common.units import ARCSEC, DEG_PER_H, DEG_PER_SQRT_H, HOUR
from pyhrg.device.declarations import EffectDeclaration, parameter


@dataclass(frozen=True)
class NoiseParameters:
    """Random errors and the quantization of the output; SI."""

    angle_random_walk: float = parameter(
        key="angle_random_walk_deg_sqrt_h",
        unit=DEG_PER_SQRT_H,
        limits=(0, 10),
        noise=EffectDeclaration("angle_random_walk", 1e-3 * DEG_PER_SQRT_H, ("noise",)),
    )
    """White force noise, as the input-referred angle random walk [N], rad/sqrt(s)."""
    rate_random_walk: float = parameter(
        key="rate_random_walk_deg_h_sqrt_h",
        unit=DEG_PER_H / math.sqrt(HOUR),
        limits=(0, 1000),
        noise=EffectDeclaration(
            "rate_random_walk", 1e-2 * DEG_PER_H / math.sqrt(HOUR), ("noise", "time")
        ),
    )
    """Input-referred rate random walk coefficient [K], rad/s/sqrt(s)."""
    bias_instability: float = parameter(
        key="bias_instability_deg_h",
        unit=DEG_PER_H,
        limits=(0, 1e4),
        fmu="noise.biasInstability",
        noise=EffectDeclaration("bias_instability", 1e-2 * DEG_PER_H, ("noise", "time")),
    )
    """Input-referred flicker coefficient (IEEE Std 952: the Allan deviation's floor is 0.664 B)
    [B], rad/s."""
    angle_white_noise: float = parameter(
        key="angle_white_noise_arcsec",
        unit=ARCSEC,
        limits=(0, 1e4),
        noise=EffectDeclaration("angle_white_noise", 0.1 * ARCSEC, ("noise",)),
    )
    """Standard deviation of the white noise of the detected angle, per 1 ms sample, as an angle of
    the case, rad."""
    quantization_step: float = parameter(
        key="quantum_arcsec",
        unit=ARCSEC,
        limits=(0, 3600),
        fmu="controller.readout.quantum",
        noise=EffectDeclaration("angle_quantisation", 0.3 * ARCSEC, ("noise",)),
    )
    """Quantization step of the output angle, rad; 0: none."""
