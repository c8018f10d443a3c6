"""Figures of a channel as inline SVG: Allan deviation and spectrum, measured and promised."""

import io

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from pyhrg.gap.static_record.fit.diagnosis import ChannelDiagnosis
from pyhrg.noise.allan import allan_deviation, expected_deviation
from pyhrg.noise.likelihood import spectrum
from pyhrg.noise.model import Coefficient, NoiseCoefficients

Array = NDArray[np.float64]

MEASURED, BEFORE, AFTER = "#0072b2", "#555555", "#d55e00"


def allan_svg(d: ChannelDiagnosis) -> str:
    """Allan deviation of the whole record with 95 % bands; believed and closed noise."""
    found = allan_deviation(d.channel.angle, d.channel.interval)
    scale, unit = d.channel.kind.rate_scale, d.channel.kind.rate_unit
    figure = Figure(figsize=(6.4, 4.2), layout="constrained")
    axes = figure.add_subplot(xscale="log", yscale="log")
    axes.fill_between(
        found.tau, found.low / scale, found.high / scale, color=MEASURED, alpha=0.2, lw=0
    )
    axes.plot(found.tau, found.deviation / scale, "o", ms=3, color=MEASURED, label="measured")
    for levels, label, style in _models(d):
        promised = expected_deviation(found.tau, _coefficients(levels)) / scale
        axes.plot(found.tau, promised, style[0], color=style[1], label=label)
    _finish(axes, "cluster time, s", f"Allan deviation, {unit}")
    return _svg(figure)


def spectrum_svg(d: ChannelDiagnosis) -> str:
    """Spectrum of the rate of the whole record in narrow bands."""
    n, interval = len(d.channel.angle), d.channel.interval
    bands = spectrum(d.channel.angle)
    first = np.concatenate([[0], np.cumsum(bands.count)[:-1]])
    hertz = (first + (bands.count + 1) / 2) / (2 * n * interval)
    gain = (2 * np.sin(np.pi * hertz * interval)) ** 2 / interval
    scale = d.channel.kind.rate_scale
    figure = Figure(figsize=(6.4, 4.2), layout="constrained")
    axes = figure.add_subplot(xscale="log", yscale="log")
    measured = np.sqrt(2 * gain * bands.power / bands.count) / scale
    axes.plot(hertz, measured, ".", ms=3, color=MEASURED, label="measured")
    for levels, label, style in _models(d):
        promised = np.sqrt(2 * gain * ((levels / d.units) ** 2 @ bands.shapes)) / scale
        axes.plot(hertz, promised, style[0], color=style[1], label=label)
    _finish(axes, "frequency, Hz", f"density of the rate, {d.channel.kind.rate_unit}/sqrt(Hz)")
    return _svg(figure)


def _models(d: ChannelDiagnosis) -> list[tuple[Array, str, tuple[str, str]]]:
    found = [(d.belief.levels, "as believed", ("--", BEFORE))]
    if d.causes:
        found.append((d.closed, "with what was missing", ("-", AFTER)))
    return found


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
