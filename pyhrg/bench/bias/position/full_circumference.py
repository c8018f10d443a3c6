"""The paper's bias test (section 4.1): 8N positions of the pattern, which the table turns.

A power-on goes through all positions, with 100 s means at each; there are seven power-ons. Bias
stability is the standard deviation of a run's data points, repeatability that of the runs' means. A
fit by harmonics of the pattern angle and the tilt of the input axis gives the bias map.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import pandas as pd
from matplotlib.figure import Figure
from scipy import stats

from pyhrg.bench.bench import NAMELESS, Bench, PowerOn
from pyhrg.bench.bias.bias_test import RUNS, BiasTest
from pyhrg.bench.bias.position import positions
from pyhrg.bench.bias.position.positions import HARMONICS, Plan, choose_plan, select_visible
from pyhrg.bench.estimation.harmonics import MEAN, TILT, Fit, fit, make_columns, name_terms
from pyhrg.bench.figures import finish_axes
from pyhrg.bench.outcome import BenchError, Finding, Outcome, estimate_mean
from pyhrg.bench.procedure import Option, Procedure, require_tests
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.segments import SEGMENT, WARM_UP, Points
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG, DEG_PER_H
from pyhrg.records.campaign import Campaign, Test

MAX_POSITIONS, MAX_RUNS = 720, 1000
"""Largest numbers of positions and runs. Chosen: thirty and a hundred times the usual ones."""
POSITIONS = 24
"""Positions of the default plan."""
SEGMENTS = 3
"""Data points at each position."""
TABLE_RATE = 10 * DEG
"""Rate from one position to the next, rad/s."""
SETTLE = 20.0
"""Time at rest before a position's first data point, s."""
KIND = "positions"
SHORTEST = Plan(positions=8, pattern_step=22.5 * DEG)
"""Shortest plan whose standard deviation of a fourth harmonic doesn't depend on the start angle:
the paper's eight positions, half as far apart."""


@dataclass(frozen=True)
class RestRateMap:
    """Output rate at rest less Earth's rate, by pattern angle. It holds the bias map and Earth's
    vertical rate times the map of the scale factor; `calibration_maps.fit_maps` separates them.

    Attributes:
        harmonics: orders that are fitted.
        tilt: whether the tilt of the input axis is fitted.
        fits: fit of each run.
        refused: a sentence on each term that the positions can't separate.
    """

    harmonics: tuple[int, ...]
    tilt: bool
    fits: tuple[Fit, ...]
    refused: tuple[str, ...]

    def value(self, name: str) -> float:
        """Value of a term, mean over the runs, rad/s."""
        return float(np.mean([fitted.value(name) for fitted in self.fits]))

    def estimate(self, name: str) -> tuple[float, float, float]:
        """Value of a term, rad/s, its standard error, and the degrees of freedom of that: over the
        runs where there are three or more, else by the runs' fits."""
        values, count = [fitted.value(name) for fitted in self.fits], len(self.fits)
        if count > 2:
            error = float(np.std(values, ddof=1) / np.sqrt(count))
            return float(np.mean(values)), error, count - 1.0
        error = float(np.hypot.reduce([fitted.deviation(name) for fitted in self.fits])) / count
        return float(np.mean(values)), error, float(sum(fitted.freedom for fitted in self.fits))

    def finding(self, name: str, note: str = "") -> Finding:
        """A term with Student's 95 % interval, see `estimate`."""
        label = "mean of the map" if name == MEAN else f"bias {name.replace('_', ' ')}"
        value, error, freedom = self.estimate(name)
        reach = float(stats.t.ppf(0.975, freedom)) * error
        points = sum(len(fitted.residual) for fitted in self.fits)
        n = len(self.fits) if len(self.fits) > 2 else points
        return Finding(label, value, "deg/h", value - reach, value + reach, n, note)

    def evaluate(self, pattern_angle: Array) -> Array:
        """(n,) rates of the map at pattern angles (n,), rad, without the tilt, rad/s."""
        columns = make_columns(pattern_angle, pattern_angle, self.harmonics, tilt=False)
        return np.asarray(sum(self.value(name) * column for name, column in columns.items()))

    def remove_tilt(self, run: Points) -> Array:
        """(n,) rates of a run without the tilt of the input axis, rad/s."""
        if not self.tilt:
            return run.rate
        cosine, sine = map(self.value, TILT)
        lean = cosine * np.cos(run.table_angle) + sine * np.sin(run.table_angle)
        return np.asarray(run.rate - lean)

    @property
    def names(self) -> tuple[str, ...]:
        return self.fits[0].names


def make_programme(bench: Bench, plan: Plan, segments: int = SEGMENTS) -> Programme:
    """Programme of one power-on: input axis up, the table turns from position to position.

    Earth's rate turns the pattern too, by 0.07 deg in 100 s. The table steps allow for it, so that
    the positions are spaced as planned and their mean is that over the circumference.

    Raises:
        BenchError: the gyro sweeps its pattern, which then rests nowhere.
    """
    if bench.device.sweep_angle:
        raise BenchError(
            f"{bench.device.name or NAMELESS}: found sweep_angle_deg = "
            f"{bench.device.sweep_angle / DEG:g}: a pattern that the electronics sweep rests at no "
            "position; expected 0 for a test over positions"
        )
    course = bench.programme().rest(WARM_UP)
    dwell = SETTLE + segments * SEGMENT
    cycle = dwell + plan.table_step / TABLE_RATE
    step = plan.table_step - bench.device.site.vertical_rate * cycle
    for position in range(plan.positions):
        if position:
            course.turn(step, TABLE_RATE)
        course.rest(dwell)
    return course


def make_power_ons(
    bench: Bench, plan: Plan | None = None, runs: int = RUNS, segments: int = SEGMENTS
) -> list[PowerOn]:
    """Power-ons through all positions of a plan; by default of one that separates all terms."""
    plan = plan or choose_plan(POSITIONS, bench.device.bryan_factor)
    course = make_programme(bench, plan, segments)
    return [PowerOn(f"positions_{n + 1}", KIND, course) for n in range(runs)]


def record(
    bench: Bench,
    positions: int = POSITIONS,
    spacing_deg: float | None = None,
    dwell_s: float = SEGMENTS * SEGMENT,
    runs: int = RUNS,
) -> list[Test]:
    """Tests of the power-ons of a plan.

    `spacing_deg` is the pattern angle between positions, chosen to separate most terms if None;
    `dwell_s` is a multiple of 100 s.
    """
    segments = round(dwell_s / SEGMENT)
    if segments < 1 or abs(segments * SEGMENT - dwell_s) > 1e-6:
        raise BenchError(f"a dwell of {dwell_s:g} s: expected whole segments of {SEGMENT:g} s")
    if not 1 <= runs <= MAX_RUNS or positions not in range(8, MAX_POSITIONS + 1, 8):
        raise BenchError(
            f"{positions} positions in {runs} runs: expected 8, 16, 24, ... {MAX_POSITIONS} in "
            f"1 to {MAX_RUNS} runs"
        )
    if spacing_deg is not None and not 1 <= spacing_deg <= 720:
        raise BenchError(f"{spacing_deg:g} deg between positions: expected 1 to 720")
    factor = bench.device.bryan_factor
    plan = (
        Plan(positions, spacing_deg * DEG, factor)
        if spacing_deg
        else choose_plan(positions, factor)
    )
    return bench.run(make_power_ons(bench, plan, runs, segments))


def measure_bias(campaign: Campaign) -> BiasTest:
    """Bias, stability and repeatability of the campaign's position tests (paper 4.1)."""
    return BiasTest(read_runs(campaign))


def measure_mean_bias(campaign: Campaign) -> float:
    """Mean bias over the circumference, rad/s, from a map of the fourth harmonic."""
    return fit_map(read_runs(campaign), wanted=(4,), tilt=False).value(MEAN)


def read_runs(campaign: Campaign) -> list[Points]:
    """Data points of each power-on, equally many at each position."""
    return positions.read_complete_runs(require_tests(campaign, KIND), campaign.site, SETTLE)[0]


def fit_map(
    runs: Sequence[Points], wanted: Sequence[int] = HARMONICS, tilt: bool = True
) -> RestRateMap:
    """Bias map of the terms that the positions can separate, fitted to each run.

    The data points of all runs lie at the same positions.
    """
    first = runs[0]
    dwells = [first.dwell == number for number in np.unique(first.dwell)]
    pattern, table = (
        np.array([np.mean(angle[chosen]) for chosen in dwells])
        for angle in (first.pattern_angle, first.table_angle)
    )
    seen, with_tilt, refused = select_visible(pattern, table, wanted, tilt)
    fits = tuple(
        fit(make_columns(run.pattern_angle, run.table_angle, seen, with_tilt), run.rate)
        for run in runs
    )
    return RestRateMap(tuple(seen), with_tilt, fits, tuple(refused))


def evaluate(campaign: Campaign) -> Outcome:
    """Bias, stability, repeatability, variances within and between positions, bias map."""
    tests = require_tests(campaign, KIND)
    runs, exclusions = positions.read_complete_runs(tests, campaign.site, SETTLE)
    test, fitted = BiasTest(runs), fit_map(runs)
    within = positions.estimate_within("within positions", runs)
    between = positions.estimate_between("between positions", runs, fitted.fits)
    earth = f"{campaign.site.vertical_rate / DEG_PER_H:.3g} deg/h of Earth x scale factor included"
    maps = [fitted.finding(name, "" if name in (MEAN, *TILT) else earth) for name in fitted.names]
    if 4 in fitted.harmonics:
        cosine, sine = name_terms(4)
        sizes = [float(np.hypot(f.value(cosine), f.value(sine))) for f in fitted.fits]
        note = f"amplitude; {earth}"
        maps.insert(0, estimate_mean("fourth harmonic", sizes, "deg/h", note))
    return Outcome(
        findings=(*test.findings(), within, between, *maps),
        verdict=_describe_verdict(test, within.si_value, between.si_value),
        tables=(test.table(),),
        warnings=(*fitted.refused, *filter(None, [positions.describe_leakage(runs[0])])),
        exclusions=tuple(exclusions),
        draw=lambda figure: draw(figure, runs, fitted),
        values={"bias_map": {name: fitted.value(name) for name in fitted.names}},
        points=_tabulate_points(test, within, fitted),
    )


def _tabulate_points(test: BiasTest, within: Finding, fitted: RestRateMap) -> pd.DataFrame:
    """The data points; where the tilt of the input axis is fitted, without it as well."""
    points, name = test.tabulate_points(within), "bias_without_tilt_deg_per_h"
    if fitted.tilt:
        points[name] = np.concatenate([fitted.remove_tilt(r) for r in test.runs]) / DEG_PER_H
        points.attrs["units"][name] = "deg/h"
    return points


def _describe_verdict(test: BiasTest, within: float, between: float) -> str:
    stability = f"Bias stability {test.stability / DEG_PER_H:.2g} deg/h over the circumference"
    if within > 0:
        stability += (
            f"; positions differ {between / within:.3g} times as much as a position's points do"
        )
    return (
        f"{stability}. Harmonics of the scale factor show here as bias, times Earth's vertical "
        "rate; the test calibration, which has rate tests too, takes them out."
    )


def draw(figure: Figure, runs: Sequence[Points], fitted: RestRateMap) -> None:
    """Above: data points and the map; below: data points less the map."""
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=(2, 1))
    grid = np.linspace(0.0, np.pi, 361)
    for number, run in enumerate(runs):
        label = f"{SEGMENT:g} s means, {len(runs)} runs" if number == 0 else None
        angle, rate = run.pattern_angle % np.pi / DEG, fitted.remove_tilt(run)
        residual = rate - fitted.evaluate(run.pattern_angle)
        above.plot(angle, rate / DEG_PER_H, ".", label=label, ms=4)
        below.plot(angle, residual / DEG_PER_H, ".", ms=4)
    names = ", ".join(str(order) for order in fitted.harmonics) or "none"
    curve = fitted.evaluate(grid) / DEG_PER_H
    above.plot(grid / DEG, curve, "k-", lw=1.2, label=f"fit, harmonics {names}")
    finish_axes(above, "", "bias, deg/h", xlim=(0, 180))
    above.set_title("Bias over the circumference" + (", tilt removed" if fitted.tilt else ""))
    below.set(xlabel="pattern angle, deg", ylabel="less the fit, deg/h")
    below.grid(alpha=0.3)


PROCEDURE: Procedure = Procedure(
    name="full-circumference",
    group="bias",
    title="Bias over the full circumference (8N positions)",
    source="paper 4.1, items 1 to 5; harmonics and tilt: docs/paper.md",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
    options=(
        Option("positions", int, f"number: 8, 16, 24, ... (default {POSITIONS})"),
        Option(
            "spacing_deg",
            float,
            "pattern angle from one to the next (default: separates most terms)",
        ),
        Option("dwell_s", float, f"time at each, whole 100 s (default {SEGMENTS * SEGMENT:g})"),
        Option("runs", int, f"number of power-ons (default {RUNS})"),
    ),
)
