"""The paper's bias test (section 4.1): 8N positions of the pattern, moved by the table.

One power-on goes through all positions; 100 s means at each; seven power-ons. The standard
deviation of a run's points is its bias stability, that of the runs' means the repeatability. A fit
of harmonics and tilt tells what the bias depends on, as far as the positions can tell.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.bias.bias_test import RUNS, BiasTest, bias_test
from pyhrg.bench.bias.position.position_runs import complete_runs, leakage
from pyhrg.bench.bias.position.position_variances import between_finding, within_finding
from pyhrg.bench.bias.position.positions import HARMONICS, Plan, chosen, visible
from pyhrg.bench.estimation.harmonics import MEAN, TILT, Fit, design, fit, harmonic
from pyhrg.bench.outcome import BenchError, Finding, Outcome, mean_finding
from pyhrg.bench.procedure import Option, Procedure, exclusions_of, tests_of
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.segments import SEGMENT, WARM_UP, Segments
from pyhrg.common.units import DEG, DEG_PER_H
from pyhrg.records.campaign import Campaign, Test

POSITIONS = 24
SEGMENTS = 3
TABLE_RATE = 10 * DEG
SETTLE = 20.0
"""Time at rest before a position's first data point, s."""
KIND = "positions"
SHORTEST = Plan(positions=8, pattern_step=22.5 * DEG)
"""The paper's simplest case with its spacing mended: the standard deviation of a fourth harmonic
does not depend on where the pattern begins."""


@dataclass(frozen=True)
class Map:
    """Bias against pattern angle: terms of the fit, one fit a run, and what can't be seen."""

    harmonics: tuple[int, ...]
    tilt: bool
    fits: tuple[Fit, ...]
    refused: tuple[str, ...]

    def value(self, name: str) -> float:
        """Of a term, mean over runs, rad/s."""
        return float(np.mean([fitted.value(name) for fitted in self.fits]))

    def finding(self, name: str) -> Finding:
        """A term with its interval: over runs where there are three, else the fit's own."""
        label = "mean of the map" if name == MEAN else f"bias {name.replace('_', ' ')}"
        if len(self.fits) > 2:
            return mean_finding(label, [fitted.value(name) for fitted in self.fits], "deg/h")
        fitted = self.fits[0]
        low, high = fitted.interval(name)
        n = len(fitted.residual)
        return Finding(label, fitted.value(name), "deg/h", low, high, n, "of the first run")

    @property
    def names(self) -> tuple[str, ...]:
        """Terms of the fit."""
        return self.fits[0].names


def programme(bench: Bench, plan: Plan, segments: int = SEGMENTS) -> Programme:
    """One power-on: input axis up, the table turns from position to position.

    Earth turns the pattern as well, by 0.07 deg in 100 s; the table makes up for it, so that the
    positions are spaced as planned and their mean is that of the circumference.
    """
    course = bench.programme().rest(WARM_UP)
    dwell = SETTLE + segments * SEGMENT
    cycle = dwell + plan.table_step / TABLE_RATE
    step = plan.table_step - bench.device.site.vertical_rate * cycle
    for position in range(plan.positions):
        if position:
            course.turn(step, TABLE_RATE)
        course.rest(dwell)
    return course


def power_ons(
    bench: Bench, plan: Plan | None = None, runs: int = RUNS, segments: int = SEGMENTS
) -> list[PowerOn]:
    """Seven through all positions; the plan is chosen to tell all terms apart."""
    plan = plan or chosen(POSITIONS, bench.device.bryan_factor)
    course = programme(bench, plan, segments)
    return [PowerOn(f"positions_{n + 1}", KIND, course) for n in range(runs)]


def record(
    bench: Bench,
    positions: int = POSITIONS,
    spacing_deg: float | None = None,
    dwell_s: float = SEGMENTS * SEGMENT,
    runs: int = RUNS,
) -> list[Test]:
    """Run them; the options of the plan are those of the command line.

    Raises:
        BenchError: a plan that can't be had.
    """
    segments = round(dwell_s / SEGMENT)
    if segments < 1 or abs(segments * SEGMENT - dwell_s) > 1e-6:
        raise BenchError(f"a dwell of {dwell_s:g} s: expected whole segments of {SEGMENT:g} s")
    if runs < 1 or positions < 8 or positions % 8:
        raise BenchError(
            f"{positions} positions in {runs} runs: expected 8, 16, 24, ... and at least one run"
        )
    if spacing_deg is not None and not 1 <= spacing_deg <= 720:
        raise BenchError(f"{spacing_deg:g} deg between positions: expected 1 to 720")
    factor = bench.device.bryan_factor
    if spacing_deg is None:
        plan = chosen(positions, factor)
    else:
        plan = Plan(positions, spacing_deg * DEG, factor)
    return bench.run(power_ons(bench, plan, runs, segments))


def measured(campaign: Campaign) -> BiasTest:
    """Means, stability and repeatability of the campaign's position tests (paper 4.1)."""
    return bias_test(runs_of(campaign))


def mean_bias(campaign: Campaign) -> float:
    """Bias averaged over the circumference, rad/s: the mean of the fitted fourth harmonic's map."""
    return fitted_map(runs_of(campaign), wanted=(4,), tilt=False).value(MEAN)


def runs_of(campaign: Campaign) -> list[Segments]:
    """Data points of each power-on, equally many at each position.

    Raises:
        BenchError: no power-on has 8N positions, evenly spaced.
    """
    return complete_runs(tests_of(campaign, KIND), campaign.site.latitude, SETTLE)[0]


def fitted_map(
    runs: Sequence[Segments], wanted: Sequence[int] = HARMONICS, tilt: bool = True
) -> Map:
    """Fit each run by what its positions can tell apart."""
    pattern, table = (
        np.array(
            [np.mean(getattr(runs[0], name)[runs[0].dwell == d]) for d in np.unique(runs[0].dwell)]
        )
        for name in ("pattern_angle", "table_angle")
    )
    seen, with_tilt, refused = visible(pattern, table, wanted, tilt)
    fits = tuple(
        fit(design(run.pattern_angle, run.table_angle, seen, with_tilt), run.rate) for run in runs
    )
    return Map(tuple(seen), with_tilt, fits, tuple(refused))


def evaluate(campaign: Campaign) -> Outcome:
    """Stability, repeatability, variances, harmonics and tilt."""
    tests = tests_of(campaign, KIND)
    runs, left_out = complete_runs(tests, campaign.site.latitude, SETTLE)
    test, fitted = bias_test(runs), fitted_map(runs)
    within = within_finding("within positions", runs)
    between = between_finding("between positions", runs, fitted.fits)
    maps = tuple(fitted.finding(name) for name in fitted.names)
    return Outcome(
        procedure=PROCEDURE.name,
        findings=(*test.findings(), within, between, *_amplitude(fitted), *maps),
        verdict=_verdict(test, within.value, between.value),
        tables=(test.table(),),
        warnings=(*fitted.refused, *filter(None, [leakage(runs[0])])),
        exclusions=(*exclusions_of(tests), *left_out),
        draw=lambda figure: draw(figure, runs, fitted),
        values={"bias_map": {name: fitted.value(name) for name in fitted.names}},
    )


def _amplitude(fitted: Map) -> tuple[Finding, ...]:
    if 4 not in fitted.harmonics:
        return ()
    cosine, sine = harmonic(4)
    sizes = [float(np.hypot(f.value(cosine), f.value(sine))) for f in fitted.fits]
    return (mean_finding("fourth harmonic", sizes, "deg/h", "amplitude"),)


def _verdict(test: BiasTest, within: float, between: float) -> str:
    stability = f"Bias stability {test.stability / DEG_PER_H:.2g} deg/h over the circumference"
    if not within > 0:
        return f"{stability}."
    share = f"{between / within:.3g} times as much as a position's points do"
    return f"{stability}; positions differ {share}."


def draw(figure: Figure, runs: Sequence[Segments], fitted: Map) -> None:
    """Data points and fitted map against the pattern angle."""
    axes = figure.add_subplot()
    grid = np.linspace(0.0, np.pi, 361)
    columns = design(grid, grid, fitted.harmonics, tilt=False)
    curve = sum(fitted.value(name) * column for name, column in columns.items())
    for number, run in enumerate(runs):
        lean = sum(
            fitted.value(name) * trig(run.table_angle)
            for name, trig in zip(TILT, (np.cos, np.sin), strict=True)
            if fitted.tilt
        )
        label = f"100 s means, {len(runs)} runs" if number == 0 else None
        axes.plot(
            run.pattern_angle % np.pi / DEG, (run.rate - lean) / DEG_PER_H, ".", label=label, ms=4
        )
    names = ", ".join(str(order) for order in fitted.harmonics) or "none"
    axes.plot(grid / DEG, curve / DEG_PER_H, "k-", lw=1.2, label=f"fit, harmonics {names}")
    axes.set_xlabel("pattern angle, deg")
    axes.set_ylabel("bias, deg/h")
    axes.set_xlim(0, 180)
    axes.set_title("Bias over the circumference" + (", tilt removed" if fitted.tilt else ""))
    axes.grid(alpha=0.3)
    axes.legend()


PROCEDURE = Procedure(
    name="full-circumference",
    group="bias",
    title="Bias over the full circumference (8N positions)",
    rows=("bias stability, room temperature", "bias repeatability, room temperature"),
    source="paper 4.1, items 1 to 5; harmonics and tilt: docs/paper.md",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
    options=(
        Option("positions", int, f"8, 16, 24, ... (default {POSITIONS})"),
        Option(
            "spacing_deg", float, "of pattern from one to the next (default: chosen to see most)"
        ),
        Option("dwell_s", float, f"means at each, whole 100 s (default {SEGMENTS * SEGMENT:g})"),
        Option("runs", int, f"power-ons (default {RUNS})"),
    ),
)
