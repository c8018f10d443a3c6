"""The Allan deviation of a channel, measured and fitted, drawn into axes."""

import numpy as np
from matplotlib.axes import Axes

from pyhrg.common.arrays import Array
from pyhrg.gap.static_record.terms import Kind
from pyhrg.noise.allan import AllanDeviation
from pyhrg.noise.coefficients import Coefficient, NoiseCoefficients, compute_allan_deviation

MEASURED, AFTER = "#0072b2", "#d55e00"


def plot_deviation(axes: Axes, measured: AllanDeviation, kind: Kind) -> None:
    """Draw the Allan deviation with its 95 % intervals."""
    scale = kind.rate_scale
    scale_axes(axes, "cluster time, s", f"Allan deviation, {kind.rate_unit}")
    low, high = measured.low / scale, measured.high / scale
    axes.fill_between(measured.tau, low, high, color=MEASURED, alpha=0.2, lw=0)
    axes.plot(measured.tau, measured.deviation / scale, "o", ms=3, color=MEASURED, label="measured")


def plot_fitted_noise(
    axes: Axes, tau: Array, noise: NoiseCoefficients, ramp: Coefficient, kind: Kind
) -> None:
    """Draw the Allan deviation of noise and rate ramp at cluster times (n,), s."""
    drift = ramp.value * tau / np.sqrt(2)
    fitted = np.hypot(compute_allan_deviation(tau, noise), drift) / kind.rate_scale
    axes.plot(tau, fitted, "-", color=AFTER, label="fitted noise and rate ramp")


def scale_axes(axes: Axes, x: str, y: str) -> None:
    """Make both axes logarithmic, with labels and a faint grid."""
    axes.set(xscale="log", yscale="log", xlabel=x, ylabel=y)
    axes.grid(which="both", alpha=0.2)
