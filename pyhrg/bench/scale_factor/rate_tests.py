"""Tests at constant rates, the table turning both ways: how they are made and picked."""

import numpy as np

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.outcome import BenchError
from pyhrg.bench.procedure import exclusions_of, tests_of
from pyhrg.bench.readings.turns import PERIOD, Turn, left_out, turns
from pyhrg.common.units import DEG
from pyhrg.records.campaign import Campaign, Test

KIND = "rate"
RUNS = 7
FASTEST_A = 20 * DEG
"""Method A takes rates up to here, method B those above, rad/s."""
WARM_UP = 10.0
"""At rest before the table turns, s."""
INTERVAL = 0.1
"""Of a log's rows, s."""


def rate_turns(campaign: Campaign, slow: bool) -> list[Turn]:
    """Turns of the campaign's rate tests at rates up to `FASTEST_A`, or above.

    Raises:
        BenchError: there are none.
    """
    found = [turn for test in tests_of(campaign, KIND) for turn in turns_of(campaign, test)]
    chosen = [turn for turn in found if (abs(turn.table_rate) <= FASTEST_A) == slow]
    if not chosen:
        rates = ", ".join(f"{turn.table_rate / DEG:.3g}" for turn in found)
        side = "up to" if slow else "above"
        raise BenchError(
            f"{campaign.device}: no rate test {side} {FASTEST_A / DEG:g} deg/s; "
            f"there are {rates} deg/s"
        )
    return chosen


def turns_of(campaign: Campaign, test: Test) -> list[Turn]:
    """Turns of one power-on."""
    return turns(test.log, campaign.site.latitude)


def exclusions(campaign: Campaign, *kinds: str) -> tuple[str, ...]:
    """What was left out of the logs of these kinds, on reading and here."""
    tests, latitude = tests_of(campaign, *kinds), campaign.site.latitude
    short = (text for test in tests for text in left_out(test.log, latitude))
    return (*exclusions_of(tests), *short)


def record_turns(bench: Bench, rate: float, periods: int, runs: int = RUNS) -> list[Test]:
    """Make the power-ons of `turn_power_ons`."""
    return bench.run(turn_power_ons(bench, rate, periods, runs))


def turn_power_ons(bench: Bench, rate: float, periods: int, runs: int = RUNS) -> list[PowerOn]:
    """Power-ons in which the table turns by whole periods of the pattern, each way in its own."""
    tasks = []
    for way, sign in (("pos", 1), ("neg", -1)):
        course = bench.programme(INTERVAL).rest(WARM_UP)
        duration = PERIOD * periods / (bench.device.bryan_factor * rate) + 3.0
        course.spin(sign * rate, np.ceil(duration / INTERVAL) * INTERVAL)
        name = f"rate_{rate / DEG:g}dps_{way}"
        tasks += [PowerOn(f"{name}_{run + 1}", KIND, course) for run in range(runs)]
    return tasks
