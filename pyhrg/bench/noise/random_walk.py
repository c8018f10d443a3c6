"""Random walk: the gyro's noises with the pattern at rest and with virtual rotation."""

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.figures import finish_axes
from pyhrg.bench.outcome import Finding, Outcome
from pyhrg.bench.procedure import Procedure, require_tests
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.noise_records import Noise, fit_noise_of_tests
from pyhrg.bench.readings.segments import WARM_UP
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG, DEG_PER_H, HOUR
from pyhrg.noise.allan import estimate_allan_deviation
from pyhrg.noise.coefficients import Coefficient, NoiseCoefficients, compute_allan_deviation
from pyhrg.records.campaign import Campaign, Test

RESTING_KIND, ROTATING_KIND = KINDS = ("static", "virtual_rotation")
DURATION = 2 * HOUR
ROTATION = 1 * DEG
"""Commanded, as an input rate: the pattern turns by 0.277 of it, rad/s."""
TERMS = {
    "angle_random_walk": ("angle random walk", "deg/sqrt(h)"),
    "bias_instability": ("bias instability", "deg/h"),
    "rate_random_walk": ("rate random walk", "deg/h/sqrt(h)"),
    "angle_white_noise": ("white angle noise", "arcsec"),
}
"""Name and unit of each coefficient's finding, by the field of `NoiseCoefficients`."""
RATIO = "random walk ratio"
CREEP = 0.1 * DEG
"""Arc over which the bias map begins to look like slow noise, rad."""


def make_programme(bench: Bench, rotation: float, duration: float = DURATION) -> Programme:
    """One power-on: at rest, input axis east, so that no Earth rate moves the pattern."""
    course = bench.programme().attitude(0.0).command(virtual_rotation=rotation)
    return course.rest(WARM_UP + duration)


def plan_power_ons(bench: Bench, duration: float = DURATION) -> list[PowerOn]:
    """Without and with virtual rotation."""
    return [
        PowerOn("random_walk_off", RESTING_KIND, make_programme(bench, 0.0, duration)),
        PowerOn("random_walk_on", ROTATING_KIND, make_programme(bench, ROTATION, duration)),
    ]


def record(bench: Bench) -> list[Test]:
    return bench.run(plan_power_ons(bench))


def evaluate(campaign: Campaign) -> Outcome:
    """Coefficients without and with virtual rotation, and how much worse it makes the walk."""
    require_tests(campaign, *KINDS)
    off, on = (fit_noise_of_tests(campaign, kind, kind == ROTATING_KIND) for kind in KINDS)
    ratio = _ratio(off, on)
    states = {state: noise for state, noise in (("without", off), ("with", on)) if noise}
    return Outcome(
        findings=(*_findings(off, ""), *_findings(on, " under virtual rotation"), ratio),
        verdict=_verdict(off, on, ratio),
        warnings=tuple(text for noise in states.values() for text in _warnings(noise)),
        exclusions=tuple(text for noise in states.values() for text in noise.exclusions),
        draw=lambda figure: draw(figure, states),
    )


def _findings(noise: Noise | None, state: str) -> list[Finding]:
    if noise is None:
        note = "the campaign has no such test"
        return [Finding(name + state, np.nan, unit, note=note) for name, unit in TERMS.values()]
    findings = []
    for key, (name, unit) in TERMS.items():
        level: Coefficient = getattr(noise.coefficients, key)
        note = "" if level.present else "compatible with zero: an upper bound"
        values = (level.value, unit, level.low, level.high, noise.n)
        findings.append(Finding(name + state, *values, note))
    return findings


def _ratio(off: Noise | None, on: Noise | None) -> Finding:
    """Ratio of the random walks, with virtual rotation over without.

    Interval of a ratio of independent estimates from the interval of each, in logarithms
    (G. Zou, A. Donner, Stat. Med. 27 (2008)).
    """
    if off is None or on is None:
        return Finding(RATIO, np.nan, "1", note="needs tests without and with virtual rotation")
    top, bottom = on.coefficients.angle_random_walk, off.coefficients.angle_random_walk
    if not bottom.present:
        return Finding(RATIO, np.nan, "1", note="no angle random walk without virtual rotation")
    n = min(off.n, on.n)
    value = top.value / bottom.value
    if not top.present:
        return Finding(RATIO, value, "1", 0.0, top.high / bottom.low, n, "an upper bound")
    above = math.hypot(math.log(top.high / top.value), math.log(bottom.value / bottom.low))
    below = math.hypot(math.log(top.value / top.low), math.log(bottom.high / bottom.value))
    return Finding(RATIO, value, "1", value * math.exp(-below), value * math.exp(above), n)


def _warnings(noise: Noise) -> list[str]:
    longest = noise.longest
    span = longest.n * longest.interval
    state = "with" if longest.rotation else "without"
    warnings = [
        f"{state} virtual rotation: nothing is seen of noise slower than {span:.0f} s, the longest "
        "stretch; a constant rate and a ramp of it are taken out"
    ]
    if longest.rotation == 0 and longest.swept > CREEP:
        warnings.append(
            f"the pattern crept over {longest.swept / DEG:.2g} deg of the bias map; what a fourth "
            "harmonic does over that arc is taken out, and with it as much of the slowest noise"
        )
    if longest.rotation and longest.swept < math.pi:
        warnings.append(
            f"virtual rotation turned the pattern by {longest.swept / DEG:.0f} deg, less than half "
            "a turn: its second harmonic is taken out together with slow noise"
        )
    return warnings


def _verdict(off: Noise | None, on: Noise | None, ratio: Finding) -> str:
    if off is None or on is None:
        return "The campaign has tests of one state only: no comparison."
    if math.isnan(ratio.si_value):
        return "Without virtual rotation no angle random walk is seen: no comparison."
    rate = abs(on.longest.rotation) / DEG
    within = f"{ratio.si_low:.2g} to {ratio.si_high:.2g}"
    return f"Virtual rotation at {rate:.3g} deg/s makes the random walk {within} times as large."


LARGEST_SHARE = math.sqrt(0.5)
"""Share of the deviation from which a noise is the largest."""
STYLES = (("#0072b2", "o", (0, -30)), ("#d55e00", "s", (8, 16)))
"""Colour and marker of a state's curve, and offset of its slopes' names, points."""
SLOPES = {
    "angle_white_noise": "Q, slope -1",
    "angle_random_walk": "N, slope -1/2",
    "bias_instability": "B, slope 0",
    "rate_random_walk": "K, slope +1/2",
}
"""Name of the Allan deviation of each coefficient alone."""


def draw(figure: Figure, states: Mapping[str, Noise]) -> None:
    """Allan deviations with 95 % bands, fitted model, and the slope of each noise that is seen."""
    title = "Random walk: Allan deviation with 95 % bands, fitted noises, slopes"
    axes = figure.add_subplot(xscale="log", yscale="log", title=title)
    bounds = []
    for (state, noise), (colour, marker, offset) in zip(states.items(), STYLES, strict=False):
        spectrum, interval = noise.longest.spectrum, noise.longest.interval
        measured = estimate_allan_deviation(spectrum.rest, interval)
        # up to where taking the trends out hardly changes it
        measured = measured.up_to(noise.longest.n * interval / (2 * (1 + len(spectrum.products))))
        tau, low, high = measured.tau, measured.low / DEG_PER_H, measured.high / DEG_PER_H
        bounds += [np.min(low), np.max(high)]
        axes.fill_between(tau, low, high, color=colour, alpha=0.2, lw=0)
        label = f"{state} virtual rotation"
        axes.plot(tau, measured.deviation / DEG_PER_H, marker, color=colour, ms=4, label=label)
        fitted = compute_allan_deviation(tau, noise.coefficients) / DEG_PER_H
        axes.plot(tau, fitted, color=colour, lw=1.5, label="fitted noises")
        _draw_slopes(axes, noise.coefficients, tau, fitted, colour, offset)
    finish_axes(axes, "cluster time, s", "Allan deviation, deg/h", grid="both")
    axes.set_ylim(min(bounds) / 1.5, max(bounds) * 2)


def _draw_slopes(
    axes: Axes,
    coefficients: NoiseCoefficients,
    tau: Array,
    fitted: Array,
    colour: str,
    offset: tuple[float, float],
) -> None:
    """A line for each noise that is seen, with its name where it is the largest."""
    for name, label in SLOPES.items():
        if not getattr(coefficients, name).present:
            continue
        others = {other: Coefficient(0.0, 0.0, 0.0) for other in SLOPES if other != name}
        line = compute_allan_deviation(tau, replace(coefficients, **others)) / DEG_PER_H
        axes.plot(tau, line, ":", color=colour, lw=1)
        at = int(np.argmax(line / fitted))
        if line[at] > LARGEST_SHARE * fitted[at]:
            side = "right" if at > len(tau) / 2 else "left"
            where = (tau[at], line[at]), offset, "data", "offset points"
            axes.annotate(label, *where, color=colour, ha=side)


PROCEDURE: Procedure = Procedure(
    name="random-walk",
    group="noise",
    title="Random walk without and with virtual rotation",
    source="paper 2.5 and 3.2; IEEE Std 952, annex C; restricted likelihood of the angle",
    kinds=KINDS,
    record=record,
    evaluate=evaluate,
)
