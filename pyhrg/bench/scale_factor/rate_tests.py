"""Tests at constant table rates in both directions: their programmes and their turns."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.outcome import BenchError
from pyhrg.bench.procedure import list_exclusions, require_tests
from pyhrg.bench.readings.turns import PERIOD, Turn, find_turns, list_short_turns
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG
from pyhrg.records.campaign import Campaign

KIND = "rate"
RUNS = 7
"""Power-ons in each direction."""
FASTEST_RATE_A = 20 * DEG
"""Largest table rate for method A, rad/s; method B takes those above."""
WARM_UP = 10.0
"""Time at rest before the table turns, s."""
INTERVAL = 0.1
"""Length of a row, s."""


def read_rate_turns(campaign: Campaign, slow: bool) -> list[Turn]:
    """Turns of the campaign's rate tests at rates up to `FASTEST_RATE_A` (`slow`), or above."""
    tests, site = require_tests(campaign, KIND), campaign.site
    turns = [turn for test in tests for turn in find_turns(test.log, site)]
    chosen = [turn for turn in turns if (abs(turn.table_rate) <= FASTEST_RATE_A) == slow]
    if not chosen:
        rates = ", ".join(f"{turn.table_rate / DEG:.3g}" for turn in turns)
        side = "up to" if slow else "above"
        raise BenchError(
            f"{campaign.device}: no rate test {side} {FASTEST_RATE_A / DEG:g} deg/s; "
            f"there are {rates} deg/s"
        )
    return chosen


def list_turn_exclusions(campaign: Campaign, *kinds: str) -> tuple[str, ...]:
    """A sentence on each part of the logs of these kinds that is not used: excluded on reading, or
    too short a turn."""
    tests, site = require_tests(campaign, *kinds), campaign.site
    short = (text for test in tests for text in list_short_turns(test.log, site))
    return (*list_exclusions(tests), *short)


def make_turn_power_ons(bench: Bench, rate: float, periods: int, runs: int = RUNS) -> list[PowerOn]:
    """Power-ons, `runs` in each direction, in which the table turns at a rate, rad/s, until the
    pattern has turned by a number of periods of the scale-factor map."""
    tasks = []
    for way, sign in (("pos", 1), ("neg", -1)):
        course = bench.programme(INTERVAL).rest(WARM_UP)
        duration = PERIOD * periods / (bench.device.bryan_factor * rate) + 3.0
        course.spin(sign * rate, np.ceil(duration / INTERVAL) * INTERVAL)
        name = f"rate_{rate / DEG:g}dps_{way}"
        tasks += [PowerOn(f"{name}_{run + 1}", KIND, course) for run in range(runs)]
    return tasks


def draw_both_ways(
    axes: Axes, turns: Sequence[Turn], points: Sequence[tuple[Array, Array]]
) -> None:
    """Draw the points of turns on axes, with one label for each direction.

    `points` has pattern angles (m,), rad, and values (m,) of each turn.
    """
    for positive, mark, colour in ((True, ".", "C0"), (False, "x", "C1")):
        chosen = [i for i, turn in enumerate(turns) if (turn.table_rate > 0) == positive]
        angle = np.concatenate([points[i][0] for i in chosen]) % np.pi / DEG
        values = np.concatenate([points[i][1] for i in chosen])
        rate = np.mean([turns[i].table_rate for i in chosen]) / DEG
        label = f"{rate:+.3g} deg/s"
        axes.plot(angle, values, mark, color=colour, ms=2.5, label=label, alpha=0.5)
    axes.set(xlabel="pattern angle, deg", xlim=(0, 180))
    axes.grid(alpha=0.3)
