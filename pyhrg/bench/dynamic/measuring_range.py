"""Measuring range: the largest rate in both directions at which the output is valid and linear.

The table's rate rises in steps. The range is the rate of the last step before the first at which
the output is not valid or not linear. Further power-ons divide the interval between these steps.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.figures import finish_axes
from pyhrg.bench.outcome import BenchError, Finding, Outcome
from pyhrg.bench.procedure import Procedure, require_tests
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.plateaus import find_plateaus
from pyhrg.common.pages.markup import Table
from pyhrg.common.site import Site
from pyhrg.common.units import DEG
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign, Test

KIND = "range"
ERROR_LIMIT = 100e-6
"""Largest relative error of the output rate that counts as linear."""
HIGHEST = 5700 * DEG
"""Highest rate of the search, rad/s; the FMU takes up to 100 rad/s."""
STEPS = np.geomspace(5 * DEG, HIGHEST, 16)
"""Rates of the first power-on, rad/s."""
STAGES = 3
"""Power-ons in each direction, at most."""
INTERVAL = 0.1
"""Length of a row, s."""
SETTLE = 2.0
"""Time at the beginning of a step that is not used, s."""
NO_VALIDITY = "valid is missing from rows of the log: linearity alone decides there"
TURN = 2 * np.pi / (4 * 0.277)
"""Table angle for one period of the fourth harmonic of the pattern angle, rad."""


@dataclass(frozen=True)
class Step:
    """A plateau of the table's rate.

    Attributes:
        rate: rate of the table, rad/s.
        error: relative error of the output rate against the table's.
        valid: whether the output was valid throughout.
    """

    rate: float
    error: float
    valid: bool

    @property
    def within(self) -> bool:
        """Whether the output is valid and linear."""
        return self.valid and abs(self.error) <= ERROR_LIMIT


def make_programme(bench: Bench, rates: Sequence[float]) -> Programme:
    """Programme of one power-on, input axis east; each rate lasts two periods or more of the fourth
    harmonic."""
    course = bench.programme(INTERVAL).attitude(0.0).rest(3.0)
    for rate in rates:
        hold = SETTLE + 2 * max(1.0, np.ceil(abs(rate) * 5.0 / (2 * TURN))) * TURN / abs(rate)
        course.spin(rate, (np.round(hold / INTERVAL) + 1) * INTERVAL)
    return course


def record(bench: Bench, steps: Sequence[float] = tuple(STEPS), stages: int = STAGES) -> list[Test]:
    """Tests of both directions; each power-on divides the bracket that the one before gave."""
    tests: list[Test] = []
    for sign, name in ((1, "positive"), (-1, "negative")):
        rates = np.asarray(steps)
        for stage in range(stages):
            task = PowerOn(
                f"range_{name}_{stage + 1}", KIND, make_programme(bench, (sign * rates).tolist())
            )
            tests += bench.run([task])
            low, high = bracket_range(read_steps(bench.campaign([tests[-1]]), sign))
            if not np.isfinite(high) or low == 0.0:
                break
            rates = np.linspace(low, high, 8)
    return tests


def read_steps(campaign: Campaign, sign: int) -> list[Step]:
    """Steps of one direction, by `sign`, in order of their rates."""
    steps = [
        step
        for test in require_tests(campaign, KIND)
        for step in _read_steps(test.log, campaign.site)
        if sign * step.rate > 0
    ]
    return sorted(steps, key=lambda step: abs(step.rate))


def _read_steps(log: Log, site: Site) -> list[Step]:
    log.require("axis_up")
    steps = []
    for plateau in find_plateaus(log, SETTLE + 10 * log.interval):
        if abs(plateau.rate) < DEG:
            continue
        settled = replace(plateau, first=plateau.first + round(SETTLE / log.interval))
        rows = slice(settled.first, settled.last + 1)
        earth = site.vertical_rate * np.mean(log.axis_up[rows])
        error = (settled.mean_rate(log, log.gyro_angle) - earth) / plateau.rate - 1
        valid = not np.any(log.valid[rows] < 1 - 1e-9)
        steps.append(Step(plateau.rate, float(error), bool(valid)))
    return steps


def bracket_range(steps: Sequence[Step]) -> tuple[float, float]:
    """Rates, rad/s without sign, of the last step of the range and of the first beyond it.

    The first is 0 where the slowest step is beyond the range, the second infinite where no step is.
    """
    inside = 0.0
    for step in steps:
        if not step.within:
            return inside, abs(step.rate)
        inside = abs(step.rate)
    return inside, np.inf


def make_finding(name: str, steps: Sequence[Step]) -> Finding:
    """Range of one direction; its bounds are the rates of two steps, not a confidence interval."""
    low, high = bracket_range(steps)
    if not np.isfinite(high):
        note = "at least: the search ended here"
    elif low == 0.0:
        note = "below the slowest step, which is beyond the range; a bracket, no statistics"
    else:
        outside = next(step for step in steps if abs(step.rate) == high)
        why = "nonlinear" if outside.valid else "not valid"
        note = f"the next step is {why}; the interval is the one between both, no statistics"
    return Finding(name, low, "deg/s", low, high, len(steps), note, at_least=True)


def evaluate(campaign: Campaign) -> Outcome:
    """Measuring range in both directions, and the error at every step."""
    tests = require_tests(campaign, KIND)
    both = {"positive": read_steps(campaign, 1), "negative": read_steps(campaign, -1)}
    for name, steps in both.items():
        if len(steps) < 3:
            raise BenchError(
                f"{tests[0].log.source}: {len(steps)} {name} rates of {SETTLE:g} s and more, "
                "the range takes at least 3"
            )
    findings = [make_finding(f"measuring range {name}", steps) for name, steps in both.items()]
    header = ("rate, deg/s", "error, ppm", "valid")
    cells = {
        name: [(f"{s.rate / DEG:.6g}", f"{s.error / 1e-6:.3g}", "yes" * s.valid) for s in steps]
        for name, steps in both.items()
    }
    tables = tuple(Table(f"Steps, {n}", header, tuple(rows)) for n, rows in cells.items())
    worst = min(findings, key=lambda f: (0.0 if np.isnan(f.si_value) else f.si_value, f.si_high))
    unseen = any(np.isnan(test.log.valid).any() for test in tests)
    return Outcome(
        findings=(replace(worst, name="measuring range"), *findings),
        verdict=(
            f"Within {ERROR_LIMIT / 1e-6:g} ppm of the input and valid up to "
            f"{worst.value:.5g} deg/s either way; {worst.note}."
        ),
        tables=tables,
        warnings=(NO_VALIDITY,) if unseen else (),
        draw=lambda figure: draw(figure, both),
    )


def draw(figure: Figure, both: dict[str, list[Step]]) -> None:
    axes = figure.add_subplot(title="Measuring range")
    for (name, steps), mark in zip(both.items(), ("o", "s"), strict=True):
        rate = np.array([abs(step.rate) for step in steps]) / DEG
        error = np.array([abs(step.error) for step in steps]) / 1e-6
        axes.loglog(rate, error, mark, ms=5, label=name, mfc="none")
    outside = [abs(s.rate) / DEG for steps in both.values() for s in steps if not s.valid]
    if outside:
        axes.axvspan(min(outside), max(rate), color="0.85", label="not valid")
    axes.axhline(ERROR_LIMIT / 1e-6, color="k", ls="--", lw=1, label="limit")
    finish_axes(axes, "rate of the table, deg/s", "error of the output rate, ppm", grid="both")


PROCEDURE: Procedure = Procedure(
    name="range",
    group="dynamic",
    title="Measuring range",
    source="paper Table 1; IEEE Std 1431: input range, highest rate within the nonlinearity limit",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
