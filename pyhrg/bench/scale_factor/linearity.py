"""Scale factor over the range: nonlinearity, asymmetry, repeatability.

Each power-on goes through 11 rates in each direction. At each rate the pattern turns by whole
periods, so that the map over the circumference averages out. A line F = K W + F0 is fitted by least
squares. Nonlinearity is the largest residual over the largest output, asymmetry |K+ - K-| over K,
repeatability the standard deviation of K over power-ons.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.estimation.sizes import estimate_largest
from pyhrg.bench.figures import finish_axes
from pyhrg.bench.outcome import BenchError, Finding, Outcome, estimate_deviation, estimate_mean
from pyhrg.bench.procedure import Procedure, require_tests
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.turns import PERIOD, SETTLE, Turn, find_turns
from pyhrg.bench.scale_factor import scale_factor
from pyhrg.bench.scale_factor.scale_factor import INTERVAL, RUNS, WARM_UP
from pyhrg.common.arrays import Array, Mask
from pyhrg.common.pages.markup import Table
from pyhrg.common.units import DEG
from pyhrg.records.campaign import Campaign, Test


@dataclass(frozen=True)
class Line:
    """Input and output rates of one power-on, (n,) rad/s, for the line output = K input + F0.

    K is relative to the nominal scale factor.
    """

    input: Array
    output: Array

    def fit(self, rows: Mask | None = None) -> tuple[float, float]:
        """K and F0, rad/s, by least squares on some of the rates, or all."""
        # the error is fitted, not the output, so that rounding is relative to the error
        chosen = np.ones(len(self.input), dtype=bool) if rows is None else rows
        error = (self.output - self.input)[chosen]
        slope, offset = np.polyfit(self.input[chosen], error, 1)
        return 1.0 + float(slope), float(offset)

    @property
    def residual(self) -> Array:
        """(n,) output less line, relative to the largest output."""
        factor, offset = self.fit()
        deviation = (self.output - self.input) - (factor - 1.0) * self.input - offset
        return np.asarray(deviation / np.max(np.abs(self.output)))

    @property
    def asymmetry(self) -> float:
        """(K+ - K-) / K, from lines fitted to the positive and to the negative rates."""
        ways = [self.fit(self.input > 0)[0], self.fit(self.input < 0)[0]]
        return (ways[0] - ways[1]) / self.fit()[0]


KIND = "linearity"
RATES = tuple(rate * DEG for rate in (0.5, 1, 2, 5, 10, 20, 50, 100, 150, 200, 300))
FEWEST_RATES = 11
"""Fewest rates in each direction, as the standards require."""
SHORTEST_AVERAGE = 30.0
"""Shortest average at a rate, s."""
RATE_TOLERANCE = 0.01
"""Relative difference below which two rates count as one."""


def make_programme(bench: Bench, rates: Sequence[float] = RATES) -> Programme:
    """Programme of one power-on: all rates, in both directions, whole periods of the pattern at
    each."""
    course = bench.programme(INTERVAL).rest(WARM_UP)
    earth = bench.device.site.vertical_rate
    for rate in rates:
        period = PERIOD / (bench.device.bryan_factor * rate)
        count = np.ceil(SHORTEST_AVERAGE / period)
        # as near to whole periods as rows allow, so that little is interpolated
        rows = np.ceil(count * period / INTERVAL)
        exact = count * PERIOD / (bench.device.bryan_factor * rows * INTERVAL)
        for signed in (exact, -exact):
            course.spin(
                signed - earth,
                (rows + np.ceil((SETTLE + 1.0) / INTERVAL)) * INTERVAL,
            )
    return course


def record(bench: Bench, runs: int = RUNS, rates: Sequence[float] = RATES) -> list[Test]:
    """Tests of the power-ons, by default seven."""
    course = make_programme(bench, rates)
    return bench.run([PowerOn(f"linearity_{n + 1}", KIND, course) for n in range(runs)])


def read_line(turns: Sequence[Turn]) -> Line:
    """Input and output rates of one power-on, means over whole periods, in order of the rates."""
    points = []
    for turn in turns:
        time, angle, excess = turn.whole_periods()
        rate = (angle[-1] - angle[0]) / (time[-1] - time[0])
        points.append((rate, rate + (excess[-1] - excess[0]) / (time[-1] - time[0])))
    inputs, outputs = np.array(sorted(points)).T
    for way, count in (("positive", _count_rates(inputs)), ("negative", _count_rates(-inputs))):
        if count < FEWEST_RATES:
            raise BenchError(
                f"{turns[0].source}: {count} {way} rates with whole periods of the pattern; "
                f"linearity needs {FEWEST_RATES} each way"
            )
    return Line(inputs, outputs)


def _count_rates(rates: Array) -> int:
    positive = np.sort(rates[rates > 0])
    return len(positive) - int(np.sum(np.diff(positive) < RATE_TOLERANCE * positive[1:]))


def read_lines(campaign: Campaign) -> list[Line]:
    """Input and output rates of each power-on."""
    tests = require_tests(campaign, KIND)
    lines = [read_line(find_turns(test.log, campaign.site)) for test in tests]
    for test, line in zip(tests, lines, strict=True):
        same = len(line.input) == len(lines[0].input)
        if not same or np.any(np.abs(line.input / lines[0].input - 1) > RATE_TOLERANCE):
            raise BenchError(f"{test.id}: not at the rates of {tests[0].id}; all must be alike")
    return lines


def evaluate(campaign: Campaign) -> Outcome:
    """Scale factor, nonlinearity, asymmetry, repeatability and bias."""
    lines = read_lines(campaign)
    factors = [line.fit()[0] for line in lines]
    nonlinearity, asymmetry = _estimate_nonlinearity(lines), _estimate_asymmetry(lines)
    findings = (
        estimate_mean("scale factor error", np.array(factors) - 1, "ppm"),
        nonlinearity,
        asymmetry,
        estimate_deviation(
            "scale factor repeatability", np.array(factors) / np.mean(factors), "ppm"
        ),
        estimate_mean("bias", [line.fit()[1] for line in lines], "deg/h"),
    )
    top = max(float(np.max(np.abs(line.input))) for line in lines) / DEG
    columns = ([x.input / DEG, (x.output / x.input - 1) * 1e6, x.residual * 1e6] for x in lines)
    rows = tuple(
        (f"{r:+.4g}", f"{e:.4f}", f"{x:.5f}") for r, e, x in np.mean(list(columns), axis=0).T
    )
    header = ("input, deg/s", "output's error, ppm", "residual, ppm of the largest")
    return Outcome(
        findings=findings,
        verdict=(
            f"Up to {top:.0f} deg/s the output deviates from a line by "
            f"{nonlinearity.value:.2g} ppm of the largest; both ways differ by "
            f"{asymmetry.value:.2g} ppm."
        ),
        tables=(Table("Rates, means of all power-ons", header, rows),),
        exclusions=scale_factor.list_unused_turns(campaign, KIND),
        draw=lambda figure: draw(figure, lines),
    )


def _estimate_nonlinearity(lines: Sequence[Line]) -> Finding:
    residuals = np.array([line.residual for line in lines])
    value, low, high = estimate_largest(residuals)
    note = "largest residual of the power-ons' mean over the largest output"
    note += "" if len(lines) > 1 else "; one power-on: no interval"
    return Finding("scale factor nonlinearity", value, "ppm", low, high, len(lines), note)


def _estimate_asymmetry(lines: Sequence[Line]) -> Finding:
    signed = estimate_mean("scale factor asymmetry", [line.asymmetry for line in lines], "ppm")
    low, high = sorted((abs(signed.si_low), abs(signed.si_high)))
    low = 0.0 if signed.si_low <= 0.0 <= signed.si_high else low
    note = signed.note or "of the power-ons' mean, either sign"
    return replace(signed, si_value=abs(signed.si_value), si_low=low, si_high=high, note=note)


def draw(figure: Figure, lines: Sequence[Line]) -> None:
    axes = figure.add_subplot(title="Output less its best line")
    for number, line in enumerate(lines):
        label = f"{len(lines)} power-ons" if number == 0 else None
        points = (line.input / DEG, line.residual * 1e6, "o")
        axes.plot(*points, color="C0", ms=4, alpha=0.4, label=label)
    mean = np.mean([line.residual for line in lines], axis=0)
    axes.plot(lines[0].input / DEG, mean * 1e6, "k-", lw=1.2, label="mean")
    axes.set_xscale("symlog", linthresh=1.0)
    finish_axes(axes, "input rate, deg/s", "residual, ppm of the largest output")


PROCEDURE: Procedure = Procedure(
    name="linearity",
    group="scale factor",
    title="Scale-factor nonlinearity, symmetry and repeatability",
    source="GJB 2426A and IEEE Std 952 (formulas); whole periods of the pattern: paper 1.2",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
