"""Figure of the random walk: Allan deviations, what the coefficients promise, slopes."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyhrg.common.units import DEG_PER_H
from pyhrg.noise.allan import AllanDeviation
from pyhrg.noise.coefficients import NoiseCoefficients, compute_allan_deviation
from pyhrg.noise.likelihood import Array

LARGEST = math.sqrt(0.5)
"""Share of the deviation from which a noise is the largest."""


@dataclass(frozen=True)
class Style:
    """Style of a curve, distinct without colour too; offset of the slopes' names, points."""

    colour: str
    marker: str
    offset: tuple[float, float]


STYLES = (Style("#0072b2", "o", (0, -30)), Style("#d55e00", "s", (8, 16)))
SLOPES: dict[str, tuple[str, Callable[[float, Array], Array]]] = {
    "angle_white_noise": ("Q, slope -1", lambda q, t: np.sqrt(3) * q / t),
    "angle_random_walk": ("N, slope -1/2", lambda n, t: n / np.sqrt(t)),
    "bias_instability": ("B, slope 0", lambda b, t: np.sqrt(2 * np.log(2) / np.pi) * b + 0 * t),
    "rate_random_walk": ("K, slope +1/2", lambda k, t: k * np.sqrt(t / 3)),
}
"""Allan deviation of each coefficient alone (IEEE Std 952, annex C), with its name."""


@dataclass(frozen=True)
class Shown:
    """One curve."""

    label: str
    measured: AllanDeviation
    coefficients: NoiseCoefficients


def draw(figure: Figure, curves: Sequence[Shown]) -> None:
    """Allan deviations with 95 % bands, fitted model, and the slope of each noise that is seen."""
    axes = figure.add_subplot(xscale="log", yscale="log")
    axes.set_ylim(*_limits(curves))
    for curve, style in zip(curves, STYLES, strict=False):
        _draw_curve(axes, curve, style)
    axes.set_xlabel("cluster time, s")
    axes.set_ylabel("Allan deviation, deg/h")
    axes.set_title("Random walk: Allan deviation with 95 % bands, fitted noises, slopes")
    axes.grid(which="both", alpha=0.2)
    axes.legend()


def _draw_curve(axes: Axes, curve: Shown, style: Style) -> None:
    found, tau = curve.measured, curve.measured.tau
    axes.fill_between(
        tau, found.low / DEG_PER_H, found.high / DEG_PER_H, color=style.colour, alpha=0.2, lw=0
    )
    axes.plot(
        tau, found.deviation / DEG_PER_H, style.marker, color=style.colour, ms=4, label=curve.label
    )
    promised = compute_allan_deviation(tau, curve.coefficients) / DEG_PER_H
    axes.plot(tau, promised, color=style.colour, lw=1.5, label="fitted noises")
    _draw_slopes(axes, curve.coefficients, tau, promised, style)


def _draw_slopes(
    axes: Axes, coefficients: NoiseCoefficients, tau: Array, promised: Array, style: Style
) -> None:
    """A line for each noise that is seen, with its name where it is the largest."""
    for name, (label, alone) in SLOPES.items():
        coefficient = getattr(coefficients, name)
        if not coefficient.present:
            continue
        line = alone(coefficient.value, tau) / DEG_PER_H
        axes.plot(tau, line, ":", color=style.colour, lw=1)
        at = int(np.argmax(line / promised))
        if line[at] > LARGEST * promised[at]:
            side = "right" if at > len(tau) / 2 else "left"
            axes.annotate(
                label,
                (tau[at], line[at]),
                style.offset,
                textcoords="offset points",
                color=style.colour,
                ha=side,
            )


def _limits(curves: Sequence[Shown]) -> tuple[float, float]:
    """Half an octave and more around the bands, deg/h."""
    lows = [np.min(curve.measured.low) for curve in curves]
    highs = [np.max(curve.measured.high) for curve in curves]
    return float(min(lows) / DEG_PER_H / 1.5), float(max(highs) / DEG_PER_H * 2)
