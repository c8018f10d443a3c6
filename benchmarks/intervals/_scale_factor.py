"""Gyros with random imperfections and what the scale-factor tests should find of them."""

import math

import numpy as np

from pyhrg.bench.outcome import Outcome
from pyhrg.common.units import ARCSEC, DEG_PER_SQRT_H
from pyhrg.device.ready_devices import Device
from pyhrg.theory import closed_forms as theory

Intervals = dict[str, tuple[float, float, float]]

CONTROL_PERIOD = 1e-3
LOOP_LAG = 0.3
"""Time constant of the amplitude in HRGSlow, three of its sample periods, s."""


def gyro(generator: np.random.Generator) -> Device:
    """Every imperfection that the scale-factor map and the bias map show, at random."""

    def normal(size: float) -> float:
        return float(generator.normal(0.0, size))

    factor_error = normal(20e-6)
    return Device(
        damping_anisotropy=abs(normal(1e-6)),
        damping_axis=generator.uniform(0.0, math.pi / 2),
        pickoff_gain_mismatch=normal(5e-5),
        pickoff_nonorthogonality=normal(5e-5),
        drive_gain_mismatch=normal(5e-5),
        drive_nonorthogonality=normal(5e-5),
        angle_random_walk=10 ** generator.uniform(-4, -3) * DEG_PER_SQRT_H,
        angle_white_noise=10 ** generator.uniform(-2, -1) * ARCSEC,
        power_on_angle=generator.uniform(0.0, math.pi / 2),
        model={
            "resonator.material.bryanFactor": 0.277 * (1 + factor_error),
            "pickOff.offset": normal(2e-5),
            "pickOff.cubic": normal(2e-5),
            "controller.synthesis.loopDelay": generator.uniform(0.0, 1e-3),
        },
    )


def truths(device: Device, rate: float) -> dict[str, float]:
    """By the findings' names, SI: paper's Eq. 2 with the laws in `theory`.

    First order; second of the mean scale factor, which is known well enough to show it.

    An offset x0 errs the angle by -(x0/2) sin 2th, a cubic b by -(3b/32) sin 8th; each such error e
    misaims the amplitude force too, a bias of -e/(k tau).
    """
    k, tau = device.bryan_factor, device.decay_time
    cubic = 0.75 * device.model["pickOff.cubic"]
    offset = device.model["pickOff.offset"]
    delay = device.model["controller.synthesis.loopDelay"]
    rest = theory.static_bias_phasor(device)
    gain, skew = device.pickoff_gain_mismatch, device.pickoff_nonorthogonality
    scale = {2: -offset + 0j, 4: -gain - 1j * skew, 8: -cubic + 0j}
    bias = {2: 1j * offset / (2 * k * tau), 4: rest, 8: 1j * cubic / (8 * k * tau)}
    loops = {order: 1 / (1 + 1j * order * k * rate * LOOP_LAG) for order in scale}
    for order, loop in loops.items():
        ripple = theory.late_ripple(loop, CONTROL_PERIOD / 2 + delay, k, rate)
        bias[order] += -1j * scale[order] * rate * ripple.real
        scale[order] *= 1 + ripple.imag
    hold = theory.hold_scale_factor_error(CONTROL_PERIOD, delay, tau)
    misaimed = theory.misaimed_ripple_scale_factor(gain, skew, loops[4])
    true_factor = device.model["resonator.material.bryanFactor"]
    return {
        "scale factor error": true_factor / k - 1 + hold + misaimed,
        "scale factor variation": math.sqrt(sum(abs(x) ** 2 for x in scale.values()) / 2),
        "pick-off gain mismatch": -scale[4].real,
        "pick-off non-orthogonality": -scale[4].imag,
        "bias": theory.mean_bias(device),
        **_parts("scale factor", {order: scale[order] for order in (2, 8)}),
        **_parts("bias", bias),
    }


def _parts(kind: str, harmonics: dict[int, complex]) -> dict[str, float]:
    """Cosines and sines of harmonics (cosine + i sine)."""
    return {
        f"{kind} {name}{order}": part
        for order, value in harmonics.items()
        for name, part in (("cos", value.real), ("sin", value.imag))
    }


def compared(outcome: Outcome, device: Device, rate: float) -> Intervals:
    """Truth and interval of each finding that has both."""
    return {
        name: (truth, outcome.finding(name).si_low, outcome.finding(name).si_high)
        for name, truth in truths(device, rate).items()
    }


def noiseless(device: Device) -> Device:
    """The same gyro without noise."""
    return device.without_noise()
