"""Scale factor over the range: nonlinearity, symmetry, repeatability.

Each power-on steps through 11 rates each way, whole periods of the pattern at each so that the map
over the circumference averages out. F = K W + F0 by least squares; nonlinearity is the largest
residual over the largest output, symmetry |K+ - K-| over K, repeatability the standard deviation of
K over power-ons.
"""

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.estimation.largest import largest_interval
from pyhrg.bench.estimation.line import Line
from pyhrg.bench.outcome import BenchError, Finding, Outcome, deviation_finding, mean_finding
from pyhrg.bench.procedure import Procedure, tests_of
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.turns import PERIOD, SETTLE, Turn
from pyhrg.bench.scale_factor.rate_tests import INTERVAL, RUNS, WARM_UP, exclusions, turns_of
from pyhrg.common.pages.markup import Table
from pyhrg.common.units import DEG
from pyhrg.records.campaign import Campaign, Test

Array = NDArray[np.float64]

KIND = "linearity"
RATES = tuple(rate * DEG for rate in (0.5, 1, 2, 5, 10, 20, 50, 100, 150, 200, 300))
FEWEST = 11
"""Rates each way that the standards ask for."""
SHORTEST = 30.0
"""Of the average at a rate, s."""
ALIKE = 0.01
"""Rates that differ less than this, relatively, are one rate."""


def programme(bench: Bench, rates: Sequence[float] = RATES) -> Programme:
    """One power-on: through all rates, each way in turn, whole periods of the pattern at each."""
    course = bench.programme(INTERVAL).rest(WARM_UP)
    earth = bench.device.site.vertical_rate
    for rate in rates:
        period = PERIOD / (bench.device.bryan_factor * rate)
        count = np.ceil(SHORTEST / period)
        # as near to whole periods as rows allow, so that little is interpolated
        rows = np.ceil(count * period / INTERVAL)
        exact = count * PERIOD / (bench.device.bryan_factor * rows * INTERVAL)
        for signed in (exact, -exact):
            course.spin(signed - earth, (rows + np.ceil((SETTLE + 1.0) / INTERVAL)) * INTERVAL)
    return course


def record(bench: Bench, runs: int = RUNS, rates: Sequence[float] = RATES) -> list[Test]:
    """Seven power-ons."""
    course = programme(bench, rates)
    return bench.run([PowerOn(f"linearity_{n + 1}", KIND, course) for n in range(runs)])


def line(found: Sequence[Turn]) -> Line:
    """Means over whole periods of each turn, in the order of the rates.

    Raises:
        BenchError: fewer than 11 rates each way.
    """
    points = []
    for turn in found:
        time, angle, excess = turn.whole_periods()
        rate = (angle[-1] - angle[0]) / (time[-1] - time[0])
        points.append((rate, rate + (excess[-1] - excess[0]) / (time[-1] - time[0])))
    inputs, outputs = np.array(sorted(points)).T
    for way, count in (("positive", _different(inputs)), ("negative", _different(-inputs))):
        if count < FEWEST:
            raise BenchError(
                f"{found[0].source}: {count} {way} rates with whole periods of the pattern; "
                f"linearity needs {FEWEST} each way"
            )
    return Line(inputs, outputs)


def _different(rates: Array) -> int:
    positive = np.sort(rates[rates > 0])
    return len(positive) - int(np.sum(np.diff(positive) < ALIKE * positive[1:]))


def lines(campaign: Campaign) -> list[Line]:
    """Of each power-on.

    Raises:
        BenchError: the power-ons were not at the same rates.
    """
    tests = tests_of(campaign, KIND)
    found = [line(turns_of(campaign, test)) for test in tests]
    for test, other in zip(tests, found, strict=True):
        same = len(other.input) == len(found[0].input)
        if not same or np.any(np.abs(other.input / found[0].input - 1) > ALIKE):
            raise BenchError(f"{test.id}: not at the rates of {tests[0].id}; all must be alike")
    return found


def evaluate(campaign: Campaign) -> Outcome:
    """Scale factor, nonlinearity, symmetry, repeatability."""
    found = lines(campaign)
    factors = [one.fit()[0] for one in found]
    nonlinearity, asymmetry = _nonlinearity(found), _asymmetry(found)
    findings = (
        mean_finding("scale factor error", np.array(factors) - 1, "ppm"),
        nonlinearity,
        asymmetry,
        deviation_finding(
            "scale factor repeatability", np.array(factors) / np.mean(factors), "ppm"
        ),
        mean_finding("bias", [one.fit()[1] for one in found], "deg/h"),
    )
    top = max(float(np.max(np.abs(one.input))) for one in found) / DEG
    return Outcome(
        procedure=PROCEDURE.name,
        findings=findings,
        verdict=(
            f"Up to {top:.0f} deg/s the output departs from a line by {nonlinearity.shown:.2g} ppm "
            f"of the largest; both ways differ by {asymmetry.shown:.2g} ppm."
        ),
        tables=(_table(found),),
        exclusions=exclusions(campaign, KIND),
        draw=lambda figure: draw(figure, found),
    )


def _nonlinearity(found: Sequence[Line]) -> Finding:
    residuals = np.array([one.residual for one in found])
    value, low, high = largest_interval(residuals)
    note = "largest residual of the power-ons' mean over the largest output"
    note += "" if len(found) > 1 else "; one power-on: no interval"
    return Finding("scale factor nonlinearity", value, "ppm", low, high, len(found), note)


def _asymmetry(found: Sequence[Line]) -> Finding:
    signed = mean_finding("scale factor asymmetry", [one.asymmetry for one in found], "ppm")
    bounds = np.abs([signed.low, signed.high])
    low = 0.0 if signed.low <= 0.0 <= signed.high else float(np.min(bounds))
    note = signed.note or "of the power-ons' mean, either sign"
    return Finding(
        signed.name, abs(signed.value), "ppm", low, float(np.max(bounds)), signed.n, note
    )


def _table(found: Sequence[Line]) -> Table:
    rates = np.mean([one.input for one in found], axis=0) / DEG
    errors = np.mean([one.output / one.input - 1 for one in found], axis=0) * 1e6
    left = np.mean([one.residual for one in found], axis=0) * 1e6
    rows = [
        (f"{r:+.4g}", f"{e:.4f}", f"{x:.5f}") for r, e, x in zip(rates, errors, left, strict=True)
    ]
    header = ("input, deg/s", "output's error, ppm", "residual, ppm of the largest")
    return Table("Rates, means of all power-ons", header, tuple(rows))


def draw(figure: Figure, found: Sequence[Line]) -> None:
    """Residuals of each power-on and their mean against the rate."""
    axes = figure.add_subplot()
    for number, one in enumerate(found):
        label = f"{len(found)} power-ons" if number == 0 else None
        axes.plot(
            one.input / DEG, one.residual * 1e6, "o", color="C0", ms=4, alpha=0.4, label=label
        )
    mean = np.mean([one.residual for one in found], axis=0)
    axes.plot(found[0].input / DEG, mean * 1e6, "k-", lw=1.2, label="mean")
    axes.set_xscale("symlog", linthresh=1.0)
    axes.set_xlabel("input rate, deg/s")
    axes.set_ylabel("residual, ppm of the largest output")
    axes.set_title("Output less its best line")
    axes.grid(alpha=0.3)
    axes.legend()


PROCEDURE = Procedure(
    name="linearity",
    group="scale factor",
    title="Scale-factor nonlinearity, symmetry and repeatability",
    rows=(
        "scale factor nonlinearity",
        "scale factor symmetry",
        "scale factor repeatability, room temperature",
    ),
    source="GJB 2426A and IEEE Std 952 (formulas); whole periods of the pattern: paper 1.2",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
