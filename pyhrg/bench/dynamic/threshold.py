"""Threshold: the smallest rate at which the output changes by half of what is expected or more.

Small rates of the table, each way, between rests; the change of the mean output rate from the
neighbouring rests, over the change of the input. The second half of each dwell counts. A dead zone
by damping anisotropy is no threshold: it captures the pattern within 1/D, hours, and until then the
output still follows the input (`dead_zone`).
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from matplotlib.figure import Figure
from scipy import stats

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.outcome import BenchError, Finding, Outcome
from pyhrg.bench.procedure import Procedure, exclusions_of, tests_of
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.plateaus import Plateau, plateaus
from pyhrg.common.pages.markup import Table
from pyhrg.common.units import DEG
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign, Test

KIND = "threshold"
RATES = tuple(np.array([2.0, 1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01]) * 1e-3 * DEG)
"""Around the 0.001 deg/s that the paper (3.2) names, and lower."""
REPEATS = 5
DWELL = 100.0
NEEDED = 0.5
"""Response that counts as sensed."""
SETTLED = 0.5
"""Share of a dwell that counts, its end."""


@dataclass(frozen=True)
class Response:
    """Change of the output over change of the input at one rate, with its 95 % interval."""

    rate: float
    value: float
    reach: float
    n: int

    @property
    def sensed(self) -> bool:
        """Surely half or more."""
        return self.value - self.reach >= NEEDED

    @property
    def missed(self) -> bool:
        """Surely less than half."""
        return self.value + self.reach < NEEDED


def programme(bench: Bench, rates: Sequence[float], repeats: int, dwell: float) -> Programme:
    """One power-on, input axis east: rest, rate, rest, opposite rate, rest, ..."""
    course = bench.programme().attitude(0.0).rest(dwell)
    for _ in range(repeats):
        for rate in rates:
            course.spin(rate, dwell).rest(dwell).spin(-rate, dwell).rest(dwell)
    return course


def record(
    bench: Bench,
    rates: Sequence[float] = RATES,
    repeats: int = REPEATS,
    dwell: float = DWELL,
) -> list[Test]:
    """One power-on through all rates, either way, repeated."""
    return bench.run([PowerOn("threshold", KIND, programme(bench, rates, repeats, dwell))])


def changes(log: Log) -> list[tuple[float, float]]:
    """(rate of the table, change of the output rate), rad/s, of each dwell between two rests."""
    steady = plateaus(log, 10 * log.interval)
    found = []
    for before, moved, after in zip(steady, steady[1:], steady[2:], strict=False):
        if moved.rate == 0.0 or abs(before.rate) + abs(after.rate) > 1e-3 * abs(moved.rate):
            continue
        rest = (_output(log, before) + _output(log, after)) / 2
        found.append((moved.rate, _output(log, moved) - rest))
    return found


def _output(log: Log, plateau: Plateau) -> float:
    return plateau.later(SETTLED).mean_rate(log, log.gyro_angle)


def responses(logs: Sequence[Log]) -> list[Response]:
    """Of every rate, ascending; noise is alike at all rates, so that its variance is pooled.

    Raises:
        BenchError: fewer than 2 rates, or none was repeated.
    """
    pairs = [pair for log in logs for pair in changes(log)]
    groups: dict[float, list[float]] = {}
    for rate, change in pairs:
        key = next((k for k in groups if abs(k - rate) <= 1e-2 * abs(k)), rate)
        groups.setdefault(key, []).append(change)
    freedom = sum(len(group) - 1 for group in groups.values())
    if len(groups) < 2 or freedom < 1:
        raise BenchError(
            f"{logs[0].source}: {len(pairs)} dwells at {len(groups)} rates between rests; the "
            "threshold takes 2 rates or more, and repeats"
        )
    squares = sum(float(np.var(group)) * len(group) for group in groups.values())
    reach = float(stats.t.ppf(0.975, freedom)) * np.sqrt(squares / freedom)
    return [
        Response(rate, float(np.mean(g)) / rate, float(reach / np.sqrt(len(g)) / abs(rate)), len(g))
        for rate, g in sorted(groups.items())
    ]


def threshold(name: str, found: Sequence[Response]) -> Finding:
    """Smallest rate from which on, upwards, all responses are half or more.

    Its interval runs from the greatest rate that is surely missed (0: none) to the least from which
    on all are surely sensed (infinite: none).
    """
    rising = sorted(found, key=lambda response: abs(response.rate))
    value = _least(rising, [response.value >= NEEDED for response in rising])
    high = _least(rising, [response.sensed for response in rising])
    low = max((abs(r.rate) for r in rising if r.missed), default=0.0)
    n = sum(response.n for response in rising)
    if np.isinf(value):
        return Finding(name, np.nan, "deg/s", low, high, n, "the greatest rate is not sensed")
    lowest = value == abs(rising[0].rate)
    return Finding(name, value, "deg/s", low, high, n, "at most: the lowest rate" if lowest else "")


def _least(rising: Sequence[Response], passed: Sequence[bool]) -> float:
    """Rate from which on all have passed."""
    least = np.inf
    for response, ok in zip(reversed(rising), reversed(passed), strict=True):
        if not ok:
            break
        least = abs(response.rate)
    return float(least)


def evaluate(campaign: Campaign) -> Outcome:
    """Threshold either way, and the responses."""
    tests = tests_of(campaign, KIND)
    found = responses([test.log for test in tests])
    sides = {
        "positive": [r for r in found if r.rate > 0],
        "negative": [r for r in found if r.rate < 0],
    }
    for name, side in sides.items():
        if not side:
            raise BenchError(
                f"{tests[0].log.source}: no {name} rates, the threshold takes both signs"
            )
    findings = [threshold(f"threshold {name}", side) for name, side in sides.items()]
    worst = max(findings, key=lambda f: (np.isnan(f.value), f.value, f.high))
    longest = max(
        log.time[p.last] - log.time[p.first] + log.interval
        for log in (test.log for test in tests)
        for p in plateaus(log, 10 * log.interval)
    )
    return Outcome(
        procedure=PROCEDURE.name,
        findings=(replace(worst, name="threshold"), *findings, *map(_finding, found)),
        verdict=_verdict(worst),
        tables=(_table(found),),
        warnings=(
            f"dwells last {longest:.4g} s: a dead zone by damping anisotropy captures the pattern "
            "within 1/D, so that one with 1/D longer than that is not seen here",
        ),
        exclusions=exclusions_of(tests),
        draw=lambda figure: draw(figure, found),
    )


def _verdict(worst: Finding) -> str:
    note = f" ({worst.note})" if worst.note else ""
    return f"Threshold {worst.shown:.3g} deg/s{note}, the worse of both signs."


def _finding(response: Response) -> Finding:
    sign = "positive" if response.rate > 0 else "negative"
    name = f"response to {sign} {abs(response.rate) / DEG:.3g} deg per s"
    low, high = response.value - response.reach, response.value + response.reach
    return Finding(name, response.value, "1", low, high, response.n)


def _table(found: Sequence[Response]) -> Table:
    rows = [(f"{r.rate / DEG:.3g}", f"{r.value:.4f}", f"{r.reach:.4f}", str(r.n)) for r in found]
    return Table("Responses", ("rate, deg/s", "response", "+- 95 %", "n"), tuple(rows))


def draw(figure: Figure, found: Sequence[Response]) -> None:
    """Response against rate, either way."""
    axes = figure.add_subplot()
    for sign, name, mark in ((1, "positive", "+"), (-1, "negative", "s")):
        side = [r for r in found if sign * r.rate > 0]
        rate = [abs(r.rate) / DEG for r in side]
        axes.errorbar(
            rate, [r.value for r in side], [r.reach for r in side],
            fmt=mark, mfc="none", ms=7, capsize=3, label=name,
        )  # fmt: skip
    axes.axhline(NEEDED, color="k", ls="--", lw=1, label="half of what is expected")
    axes.set_xscale("log")
    axes.set_xlabel("rate of the table, deg/s")
    axes.set_ylabel("change of the output over change of the input")
    axes.set_title("Threshold, 95 % intervals")
    axes.grid(alpha=0.3)
    axes.legend()


PROCEDURE = Procedure(
    name="threshold",
    group="dynamic",
    title="Threshold around the dead zone",
    rows=("threshold",),
    source="paper 2.4, 3.2; IEEE Std 528: threshold; GJB 585B, half of the expected output",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
