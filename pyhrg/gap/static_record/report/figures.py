"""Figures of a channel as inline SVG: Allan deviation and spectrum, measured and modelled."""

import io
from collections.abc import Callable

import matplotlib
import numpy as np
from matplotlib.figure import Figure

from pyhrg.common.arrays import Array
from pyhrg.gap.static_record.allan import ChannelNoise
from pyhrg.gap.static_record.allan_figure import (
    AFTER,
    MEASURED,
    plot_deviation,
    plot_fitted_noise,
    scale_axes,
)
from pyhrg.gap.static_record.fit.diagnosis import ChannelDiagnosis
from pyhrg.gap.static_record.terms import Kind
from pyhrg.noise.allan import AllanDeviation, estimate_allan_deviation
from pyhrg.noise.coefficients import Coefficient, NoiseCoefficients, compute_allan_deviation
from pyhrg.noise.likelihood import compute_spectrum

BEFORE = "#555555"
SIZE = (6.4, 4.2)
"""Width and height of a figure, inches."""


def draw_allan_deviation(d: ChannelDiagnosis) -> str:
    """Allan deviation of the whole record with 95 % intervals, and of the believed and closed
    noise."""
    measured = estimate_allan_deviation(d.channel.angle, d.channel.interval)
    scale = d.channel.kind.rate_scale
    figure = plot_measured_allan(measured, d.channel.kind)

    def model(levels: Array) -> Array:
        noise = NoiseCoefficients(*(Coefficient(x, x, x) for x in levels.tolist()))
        return compute_allan_deviation(measured.tau, noise) / scale

    return _finish(d, figure, measured.tau, model)


def draw_fitted_noise(each: ChannelNoise) -> str:
    """Allan deviation with 95 % intervals, and that of the noise and the rate ramp fitted to the
    record."""
    figure = plot_measured_allan(each.deviation, each.channel.kind)
    plot_fitted_noise(figure.axes[0], each.deviation.tau, each.noise, each.ramp, each.channel.kind)
    return _render(figure)


def plot_measured_allan(measured: AllanDeviation, kind: Kind) -> Figure:
    """A figure of the Allan deviation with its 95 % intervals."""
    figure = Figure(figsize=SIZE, layout="constrained")
    plot_deviation(figure.add_subplot(), measured, kind)
    return figure


def draw_spectrum(d: ChannelDiagnosis) -> str:
    """Spectral density of the rate of the whole record in narrow bands, and of the believed and
    closed noise."""
    n, interval = len(d.channel.angle), d.channel.interval
    spectrum = compute_spectrum(d.channel.angle)
    bands = spectrum.bands
    hertz = (bands.starts + (bands.count + 1) / 2) / (2 * n * interval)
    gain = (2 * np.sin(np.pi * hertz * interval)) ** 2 / interval
    scale = d.channel.kind.rate_scale

    def model(levels: Array) -> Array:
        return np.asarray(np.sqrt(2 * gain * ((levels / d.units) ** 2 @ bands.shapes)) / scale)

    figure = Figure(figsize=SIZE, layout="constrained")
    axes = figure.add_subplot()
    scale_axes(axes, "frequency, Hz", f"density of the rate, {d.channel.kind.rate_unit}/sqrt(Hz)")
    measured = np.sqrt(2 * gain * spectrum.power / bands.count) / scale
    axes.plot(hertz, measured, ".", ms=3, color=MEASURED, label="measured")
    return _finish(d, figure, hertz, model)


def _finish(d: ChannelDiagnosis, figure: Figure, x: Array, model: Callable[[Array], Array]) -> str:
    """The figure as SVG, with the curves of the believed and of the closed noise added."""
    (axes,) = figure.axes
    axes.plot(x, model(d.belief.levels), "--", color=BEFORE, label="as believed")
    if d.causes:
        axes.plot(x, model(d.closed), "-", color=AFTER, label="with the terms that were found")
    return _render(figure)


def _render(figure: Figure) -> str:
    """The figure as SVG, with a legend beside the curves."""
    figure.legend(loc="outside upper center", ncols=3, frameon=False)
    buffer = io.StringIO()
    with matplotlib.rc_context({"svg.hashsalt": "hrg", "svg.fonttype": "none"}):
        figure.savefig(buffer, format="svg", metadata={"Date": None})
    text = buffer.getvalue()
    return text[text.index("<svg") :]
