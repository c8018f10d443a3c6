"""Tests at constant table rates in both directions: their programmes and their turns."""

import numpy as np

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.outcome import BenchError
from pyhrg.bench.procedure import list_exclusions, require_tests
from pyhrg.bench.readings.turns import PERIOD, Turn, find_turns, list_short_turns
from pyhrg.common.units import DEG
from pyhrg.records.campaign import Campaign, Test

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
    turns = [turn for test in require_tests(campaign, KIND) for turn in read_turns(campaign, test)]
    chosen = [turn for turn in turns if (abs(turn.table_rate) <= FASTEST_RATE_A) == slow]
    if not chosen:
        rates = ", ".join(f"{turn.table_rate / DEG:.3g}" for turn in turns)
        side = "up to" if slow else "above"
        raise BenchError(
            f"{campaign.device}: no rate test {side} {FASTEST_RATE_A / DEG:g} deg/s; "
            f"there are {rates} deg/s"
        )
    return chosen


def read_turns(campaign: Campaign, test: Test) -> list[Turn]:
    """Turns of one power-on."""
    return find_turns(test.log, campaign.site.latitude)


def list_turn_exclusions(campaign: Campaign, *kinds: str) -> tuple[str, ...]:
    """A sentence on each part of the logs of these kinds that is not used: excluded on reading, or
    too short a turn."""
    tests, latitude = require_tests(campaign, *kinds), campaign.site.latitude
    short = (text for test in tests for text in list_short_turns(test.log, latitude))
    return (*list_exclusions(tests), *short)


def record_turns(bench: Bench, rate: float, periods: int, runs: int = RUNS) -> list[Test]:
    """Tests of the power-ons of `make_turn_power_ons`."""
    return bench.run(make_turn_power_ons(bench, rate, periods, runs))


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
