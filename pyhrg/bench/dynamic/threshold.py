"""Threshold: the smallest rate to which the output responds with at least half the expected change.

The table turns at small rates in both directions, with rests between them. The response is the
change of the mean output rate from the neighbouring rests over the change of the input; the second
half of each dwell is used. This test doesn't show a dead zone by damping anisotropy D: the pattern
is captured only after 1/D, hours, and until then the output follows the input (`dead_zone`).
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from matplotlib.figure import Figure
from scipy import stats

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.figures import finish_axes
from pyhrg.bench.outcome import BenchError, Finding, Outcome
from pyhrg.bench.procedure import Procedure, require_tests
from pyhrg.bench.programme import Programme
from pyhrg.bench.readings.plateaus import Plateau, find_plateaus
from pyhrg.common.pages.markup import Table
from pyhrg.common.units import DEG
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign, Test

KIND = "threshold"
RATES = tuple(np.array([2.0, 1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01]) * 1e-3 * DEG)
"""Table rates, rad/s, around the paper's 0.001 deg/s (3.2) and lower."""
REPEATS = 5
"""Dwells at each rate and direction."""
DWELL = 100.0
"""Duration of a dwell, s."""
SENSED_RESPONSE = 0.5
"""Smallest response at which a rate is sensed (GJB 585B)."""
SETTLED_SHARE = 0.5
"""Share of a dwell, at its end, that is used."""


@dataclass(frozen=True)
class Response:
    """Response at one rate.

    Attributes:
        rate: rate of the table, rad/s.
        value: change of the output rate over change of the input rate.
        reach: half width of the value's 95 % interval.
        n: number of dwells.
    """

    rate: float
    value: float
    reach: float
    n: int


def make_programme(bench: Bench, rates: Sequence[float], repeats: int, dwell: float) -> Programme:
    """Programme of one power-on, input axis east: rest, rate, rest, opposite rate, rest, ..."""
    course = bench.programme().attitude(0.0).rest(dwell)
    for _ in range(repeats):
        for rate in rates:
            course.spin(rate, dwell).rest(dwell).spin(-rate, dwell).rest(dwell)
    return course


def record(
    bench: Bench, rates: Sequence[float] = RATES, repeats: int = REPEATS, dwell: float = DWELL
) -> list[Test]:
    """Test of one power-on through all rates in both directions, several times."""
    return bench.run([PowerOn("threshold", KIND, make_programme(bench, rates, repeats, dwell))])


def read_changes(log: Log) -> list[tuple[float, float]]:
    """Table rate and change of the output rate, rad/s, of each dwell between two rests."""
    steady = find_plateaus(log, 10 * log.interval)
    pairs = []
    for before, moved, after in zip(steady, steady[1:], steady[2:], strict=False):
        if moved.rate == 0.0 or abs(before.rate) + abs(after.rate) > 1e-3 * abs(moved.rate):
            continue
        resting = (_read_mean_output(log, before) + _read_mean_output(log, after)) / 2
        pairs.append((moved.rate, _read_mean_output(log, moved) - resting))
    return pairs


def _read_mean_output(log: Log, plateau: Plateau) -> float:
    return plateau.later(SETTLED_SHARE).mean_rate(log, log.gyro_angle)


def measure_responses(logs: Sequence[Log]) -> list[Response]:
    """Responses in order of the rates; the noise variance is pooled over all rates."""
    pairs = [pair for log in logs for pair in read_changes(log)]
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


def find_threshold(name: str, responses: Sequence[Response]) -> Finding:
    """Smallest rate from which on all larger rates have responses of half or more.

    The interval begins at the largest rate whose response is certainly below half (0 if there is
    none). It ends at the smallest rate from which on all responses are certainly half or more
    (infinite if there is none).
    """
    rising = sorted(responses, key=lambda response: abs(response.rate))
    value = _find_smallest(rising, [r.value >= SENSED_RESPONSE for r in rising])
    high = _find_smallest(rising, [r.value - r.reach >= SENSED_RESPONSE for r in rising])
    missed = (abs(r.rate) for r in rising if r.value + r.reach < SENSED_RESPONSE)
    low, n = max(missed, default=0.0), sum(response.n for response in rising)
    if np.isinf(value):
        return Finding(name, np.nan, "deg/s", low, high, n, "the greatest rate is not sensed")
    lowest = value == abs(rising[0].rate)
    return Finding(name, value, "deg/s", low, high, n, "at most: the lowest rate" if lowest else "")


def _find_smallest(rising: Sequence[Response], passed: Sequence[bool]) -> float:
    """Smallest rate from which on all responses have passed; infinite if the largest has not."""
    last_failed = max((i for i, ok in enumerate(passed) if not ok), default=-1)
    return abs(rising[last_failed + 1].rate) if last_failed + 1 < len(rising) else math.inf


def evaluate(campaign: Campaign) -> Outcome:
    """Threshold in both directions, and the response at every rate."""
    tests = require_tests(campaign, KIND)
    responses = measure_responses([test.log for test in tests])
    sides: dict[str, list[Response]] = {"positive": [], "negative": []}
    for response in responses:
        sides["positive" if response.rate > 0 else "negative"].append(response)
    for name in (name for name, side in sides.items() if not side):
        raise BenchError(f"{tests[0].log.source}: no {name} rates, the threshold takes both signs")
    findings = [find_threshold(f"threshold {name}", side) for name, side in sides.items()]
    worst = max(findings, key=lambda f: (np.isnan(f.si_value), f.si_value, f.si_high))
    note = f" ({worst.note})" if worst.note else ""
    single = [
        Finding(
            f"response to {name} {abs(r.rate) / DEG:.3g} deg per s",
            *(r.value, "1", r.value - r.reach, r.value + r.reach, r.n),
        )
        for name, side in reversed(sides.items())
        for r in side
    ]
    rows = tuple(
        (f"{r.rate / DEG:.3g}", f"{r.value:.4f}", f"{r.reach:.4f}", str(r.n)) for r in responses
    )
    longest = max(
        log.time[p.last] - log.time[p.first] + log.interval
        for log in (test.log for test in tests)
        for p in find_plateaus(log, 10 * log.interval)
    )
    return Outcome(
        findings=(replace(worst, name="threshold"), *findings, *single),
        verdict=f"Threshold {worst.value:.3g} deg/s{note}, the worse of both signs.",
        tables=(Table("Responses", ("rate, deg/s", "response", "+- 95 %", "n"), rows),),
        warnings=(
            f"dwells last {longest:.4g} s: a dead zone by damping anisotropy captures the pattern "
            "within 1/D, so that one with 1/D longer than that is not seen here",
        ),
        draw=lambda figure: draw(figure, responses),
    )


def draw(figure: Figure, responses: Sequence[Response]) -> None:
    axes = figure.add_subplot(title="Threshold, 95 % intervals", xscale="log")
    for sign, name, mark in ((1, "positive", "+"), (-1, "negative", "s")):
        side = [r for r in responses if sign * r.rate > 0]
        rate = [abs(r.rate) / DEG for r in side]
        axes.errorbar(
            rate, [r.value for r in side], [r.reach for r in side],
            fmt=mark, mfc="none", ms=7, capsize=3, label=name,
        )  # fmt: skip
    axes.axhline(SENSED_RESPONSE, color="k", ls="--", lw=1, label="half of what is expected")
    finish_axes(axes, "rate of the table, deg/s", "change of the output over change of the input")


PROCEDURE: Procedure = Procedure(
    name="threshold",
    group="dynamic",
    title="Threshold around the dead zone",
    source="paper 2.4, 3.2; IEEE Std 528: threshold; GJB 585B, half of the expected output",
    kinds=(KIND,),
    record=record,
    evaluate=evaluate,
)
