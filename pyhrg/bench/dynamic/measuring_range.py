"""Measuring range: how fast the gyro may turn, either way.

The table's rate goes up in steps, each a plateau; the range is the highest rate up to which, at
every step, the output is valid and linear. The next power-on divides the interval between the last
step within and the first outside.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.outcome import BenchError, Finding, Outcome
from pyhrg.bench.procedure import Procedure, exclusions_of, tests_of
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.plateaus import plateaus
from pyhrg.common.pages.markup import Table
from pyhrg.common.site import EARTH_RATE
from pyhrg.common.units import DEG
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign, Test

KIND = "range"
LIMIT = 100e-6
"""Of nonlinearity: deviation of the output rate from the input, relative."""
HIGHEST = 5700 * DEG
"""End of the search: the FMU's greatest rate is 100 rad/s."""
STEPS = np.geomspace(5 * DEG, HIGHEST, 16)
STAGES = 3
INTERVAL = 0.1
SETTLE = 2.0
TURN = 2 * np.pi / (4 * 0.277)
"""Of the table for a period of the fourth harmonic, rad."""


@dataclass(frozen=True)
class Step:
    """One plateau.

    rate: of the table, rad/s; error: of the output, relative; valid: throughout.
    """

    rate: float
    error: float
    valid: bool

    @property
    def within(self) -> bool:
        """The output is valid and linear."""
        return self.valid and abs(self.error) <= LIMIT


def programme(bench: Bench, rates: Sequence[float]) -> Programme:
    """One power-on, input axis east; each rate held for two periods of the pattern or more."""
    course = bench.programme(INTERVAL).attitude(0.0).rest(3.0)
    for rate in rates:
        hold = SETTLE + 2 * max(1.0, np.ceil(abs(rate) * 5.0 / (2 * TURN))) * TURN / abs(rate)
        course.spin(rate, (np.round(hold / INTERVAL) + 1) * INTERVAL)
    return course


def record(bench: Bench, steps: Sequence[float] = tuple(STEPS), stages: int = STAGES) -> list[Test]:
    """Both directions; each stage closes in between the last rate within and the first outside."""
    tests: list[Test] = []
    for sign, name in ((1, "positive"), (-1, "negative")):
        rates = np.asarray(steps)
        for stage in range(stages):
            task = PowerOn(
                f"range_{name}_{stage + 1}", KIND, programme(bench, (sign * rates).tolist())
            )
            tests += bench.run([task])
            low, high = bracket(steps_of(bench.campaign([tests[-1]]), sign))
            if not np.isfinite(high) or low == 0.0:
                break
            rates = np.linspace(low, high, 8)
    return tests


def steps_of(campaign: Campaign, sign: int) -> list[Step]:
    """Plateaus of one direction, slowest first."""
    found = [
        step
        for test in tests_of(campaign, KIND)
        for step in _steps(test.log, campaign.site.latitude)
        if sign * step.rate > 0
    ]
    return sorted(found, key=lambda step: abs(step.rate))


def _steps(log: Log, latitude: float) -> list[Step]:
    log.require("axis_up")
    steps = []
    for plateau in plateaus(log, SETTLE + 10 * log.interval):
        if abs(plateau.rate) < DEG:
            continue
        settled = replace(plateau, first=plateau.first + round(SETTLE / log.interval))
        rows = slice(settled.first, settled.last + 1)
        earth = EARTH_RATE * np.sin(latitude) * np.mean(log.axis_up[rows])
        error = (settled.mean_rate(log, log.gyro_angle) - earth) / plateau.rate - 1
        valid = not np.any(log.valid[rows] < 1 - 1e-9)
        steps.append(Step(plateau.rate, float(error), bool(valid)))
    return steps


def bracket(steps: Sequence[Step]) -> tuple[float, float]:
    """Highest rate up to which every step is within, and the next; rad/s, without sign.

    The first is 0 where no step is within, the second infinite where none is outside.
    """
    inside = 0.0
    for step in steps:
        if not step.within:
            return inside, abs(step.rate)
        inside = abs(step.rate)
    return inside, np.inf


def finding(name: str, steps: Sequence[Step]) -> Finding:
    """Range of one direction, bracketed by steps; statistics have no part in it."""
    low, high = bracket(steps)
    if not np.isfinite(high):
        note = "at least: the search ended here"
    elif low == 0.0:
        note = "below the slowest step, which is outside; a bracket, no statistics"
    else:
        outside = next(step for step in steps if abs(step.rate) == high)
        why = "nonlinear" if outside.valid else "not valid"
        note = f"the next step is {why}; the interval is the one between both, no statistics"
    return Finding(name, low, "deg/s", low, high, len(steps), note, at_least=True)


def evaluate(campaign: Campaign) -> Outcome:
    """Range either way, and the error at every step."""
    tests = tests_of(campaign, KIND)
    both = {"positive": steps_of(campaign, 1), "negative": steps_of(campaign, -1)}
    for name, steps in both.items():
        if len(steps) < 3:
            raise BenchError(
                f"{tests[0].log.source}: {len(steps)} {name} rates of {SETTLE:g} s and more, "
                "the range takes at least 3"
            )
    findings = [finding(f"measuring range {name}", steps) for name, steps in both.items()]
    worst = min(findings, key=lambda f: (0.0 if np.isnan(f.value) else f.value, f.high))
    unseen = any(np.isnan(test.log.valid).any() for test in tests)
    return Outcome(
        procedure=PROCEDURE.name,
        findings=(replace(worst, name="measuring range"), *findings),
        verdict=(
            f"Within {LIMIT / 1e-6:g} ppm of the input and valid up to "
            f"{worst.shown:.5g} deg/s either way; {worst.note}."
        ),
        tables=tuple(_table(name, steps) for name, steps in both.items()),
        warnings=("valid is missing from rows of the log: judged by linearity alone there",)
        if unseen
        else (),
        exclusions=exclusions_of(tests),
        draw=lambda figure: draw(figure, both),
    )


def _table(name: str, steps: Sequence[Step]) -> Table:
    rows = [(f"{s.rate / DEG:.6g}", f"{s.error / 1e-6:.3g}", "yes" * s.valid) for s in steps]
    return Table(f"Steps, {name}", ("rate, deg/s", "error, ppm", "valid"), tuple(rows))


def draw(figure: Figure, both: dict[str, list[Step]]) -> None:
    """Error against rate, both directions."""
    axes = figure.add_subplot()
    for (name, steps), mark in zip(both.items(), ("o", "s"), strict=True):
        rate = np.array([abs(step.rate) for step in steps]) / DEG
        error = np.array([abs(step.error) for step in steps]) / 1e-6
        axes.loglog(rate, error, mark, ms=5, label=name, mfc="none")
    outside = [abs(s.rate) / DEG for steps in both.values() for s in steps if not s.valid]
    if outside:
        axes.axvspan(min(outside), max(rate), color="0.85", label="not valid")
    axes.axhline(LIMIT / 1e-6, color="k", ls="--", lw=1, label="limit")
    axes.set_xlabel("rate of the table, deg/s")
    axes.set_ylabel("error of the output rate, ppm")
    axes.set_title("Measuring range")
    axes.grid(alpha=0.3, which="both")
    axes.legend()


PROCEDURE = Procedure(
    name="range",
    group="dynamic",
    title="Measuring range",
    rows=("measuring range",),
    source="paper Table 1; IEEE Std 1431: input range, highest rate within the nonlinearity limit",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
