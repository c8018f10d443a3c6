"""Figures of a channel as inline SVG: Allan deviation and spectrum, measured and modelled."""

import io

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from pyhrg.gap.static_record.fit.diagnosis import ChannelDiagnosis
from pyhrg.noise.allan import estimate_allan_deviation
from pyhrg.noise.coefficients import Coefficient, NoiseCoefficients, compute_allan_deviation
from pyhrg.noise.likelihood import compute_spectrum

Array = NDArray[np.float64]

MEASURED, BEFORE, AFTER = "#0072b2", "#555555", "#d55e00"


def draw_allan_deviation(d: ChannelDiagnosis) -> str:
    """Allan deviation of the whole record with 95 % intervals, and of the believed and closed
    noise."""
    measured = estimate_allan_deviation(d.channel.angle, d.channel.interval)
    scale, unit = d.channel.kind.rate_scale, d.channel.kind.rate_unit
    figure = Figure(figsize=(6.4, 4.2), layout="constrained")
    axes = figure.add_subplot(xscale="log", yscale="log")
    axes.fill_between(
        measured.tau, measured.low / scale, measured.high / scale, color=MEASURED, alpha=0.2, lw=0
    )
    axes.plot(measured.tau, measured.deviation / scale, "o", ms=3, color=MEASURED, label="measured")
    for levels, label, style in _models(d):
        modelled = compute_allan_deviation(measured.tau, _coefficients(levels)) / scale
        axes.plot(measured.tau, modelled, style[0], color=style[1], label=label)
    _finish(axes, "cluster time, s", f"Allan deviation, {unit}")
    return _svg(figure)


def draw_spectrum(d: ChannelDiagnosis) -> str:
    """Spectral density of the rate of the whole record in narrow bands, and of the believed and
    closed noise."""
    n, interval = len(d.channel.angle), d.channel.interval
    bands = compute_spectrum(d.channel.angle)
    first = np.concatenate([[0], np.cumsum(bands.count)[:-1]])
    hertz = (first + (bands.count + 1) / 2) / (2 * n * interval)
    gain = (2 * np.sin(np.pi * hertz * interval)) ** 2 / interval
    scale = d.channel.kind.rate_scale
    figure = Figure(figsize=(6.4, 4.2), layout="constrained")
    axes = figure.add_subplot(xscale="log", yscale="log")
    measured = np.sqrt(2 * gain * bands.power / bands.count) / scale
    axes.plot(hertz, measured, ".", ms=3, color=MEASURED, label="measured")
    for levels, label, style in _models(d):
        modelled = np.sqrt(2 * gain * ((levels / d.units) ** 2 @ bands.shapes)) / scale
        axes.plot(hertz, modelled, style[0], color=style[1], label=label)
    _finish(axes, "frequency, Hz", f"density of the rate, {d.channel.kind.rate_unit}/sqrt(Hz)")
    return _svg(figure)


def _models(d: ChannelDiagnosis) -> list[tuple[Array, str, tuple[str, str]]]:
    models = [(d.belief.levels, "as believed", ("--", BEFORE))]
    if d.causes:
        models.append((d.closed, "with the terms that were found", ("-", AFTER)))
    return models


def _coefficients(levels: Array) -> NoiseCoefficients:
    return NoiseCoefficients(*(Coefficient(x, x, x) for x in levels.tolist()))


def _finish(axes: Axes, x: str, y: str) -> None:
    axes.set_xlabel(x)
    axes.set_ylabel(y)
    axes.grid(which="both", alpha=0.2)
    axes.legend()


def _svg(figure: Figure) -> str:
    buffer = io.StringIO()
    with matplotlib.rc_context({"svg.hashsalt": "hrg", "svg.fonttype": "none"}):
        figure.savefig(buffer, format="svg", metadata={"Date": None})
    text = buffer.getvalue()
    return text[text.index("<svg") :]
