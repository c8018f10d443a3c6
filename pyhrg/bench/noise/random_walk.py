"""Random walk: the gyro's noises with the pattern at rest and with virtual rotation."""

import math

import numpy as np

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.noise.noise_of_tests import Noise, fit_noise_of_tests
from pyhrg.bench.noise.random_walk_figure import Shown, draw
from pyhrg.bench.outcome import Finding, Outcome
from pyhrg.bench.procedure import Procedure, list_exclusions, require_tests
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.segments import WARM_UP
from pyhrg.common.units import DEG, HOUR
from pyhrg.noise.allan import estimate_allan_deviation
from pyhrg.noise.coefficients import Coefficient
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
    """Run them."""
    return bench.run(plan_power_ons(bench))


def evaluate(campaign: Campaign) -> Outcome:
    """Coefficients without and with virtual rotation, and how much worse it makes the walk."""
    tests = require_tests(campaign, *KINDS)
    off, on = (fit_noise_of_tests(campaign, kind, kind == ROTATING_KIND) for kind in KINDS)
    ratio = _ratio(off, on)
    states = {"without": off, "with": on}
    return Outcome(
        procedure=PROCEDURE.name,
        findings=(*_findings(off, ""), *_findings(on, " under virtual rotation"), ratio),
        verdict=_verdict(off, on, ratio),
        warnings=tuple(text for found in states.values() if found for text in _warnings(found)),
        exclusions=(
            *list_exclusions(tests),
            *(text for found in states.values() if found for text in found.exclusions),
        ),
        draw=lambda figure: draw(figure, _drawn(states)),
    )


def _findings(found: Noise | None, state: str) -> list[Finding]:
    if found is None:
        note = "the campaign has no such test"
        return [Finding(name + state, np.nan, unit, note=note) for name, unit in TERMS.values()]
    return [
        _finding(getattr(found.coefficients, key), name + state, unit, found.n)
        for key, (name, unit) in TERMS.items()
    ]


def _finding(coefficient: Coefficient, name: str, unit: str, n: int) -> Finding:
    note = "" if coefficient.present else "not told from zero: an upper bound"
    return Finding(name, coefficient.value, unit, coefficient.low, coefficient.high, n, note)


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


def _warnings(found: Noise) -> list[str]:
    longest = found.longest
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
    if math.isnan(ratio.value):
        return "No angle random walk is told from zero without virtual rotation: no comparison."
    rate = abs(on.longest.rotation) / DEG
    within = f"{ratio.low:.2g} to {ratio.high:.2g}"
    return f"Virtual rotation at {rate:.3g} deg/s makes the random walk {within} times as large."


def _drawn(states: dict[str, Noise | None]) -> list[Shown]:
    """One curve a state: the Allan deviation of its longest record, without its trends, as far as
    two clusters a trend leave it what it was."""
    return [_shown(f"{name} virtual rotation", found) for name, found in states.items() if found]


def _shown(label: str, found: Noise) -> Shown:
    longest = found.longest
    measured = estimate_allan_deviation(longest.spectrum.rest, longest.interval)
    trends = 1 + len(longest.spectrum.products)
    most = longest.n * longest.interval / (2 * trends)
    return Shown(label, measured.up_to(most), found.coefficients)


PROCEDURE: Procedure = Procedure(
    name="random-walk",
    group="noise",
    title="Random walk without and with virtual rotation",
    rows=("random walk",),
    source="paper 2.5 and 3.2; IEEE Std 952, annex C; restricted likelihood of the angle",
    kinds=KINDS,
    record=record,
    evaluate=evaluate,
)
