"""Stretches of consecutive rows at rest, and what keeps other rows out of them."""

from collections import Counter
from itertools import groupby
from typing import NamedTuple

import numpy as np

from pyhrg.common.units import DEG
from pyhrg.device.device import Device
from pyhrg.gap.evidence.residuals import AMPLITUDE_TOLERANCE, is_nominal
from pyhrg.gap.replay.observations import COMMAND_COLUMNS, ObservedTest
from pyhrg.gap.replay.reading_noise import REST_RATE

MIN_STRETCH_ROWS = 60
"""Rows that a stretch must have. Chosen."""
MAX_WARMING = 3.0
"""Change of the temperature in a stretch, K. Chosen: the room of a laboratory keeps within it."""


class RestStretches(NamedTuple):
    """Rows of a test at rest, a list of them by stretch, and how many others were refused, by the
    reason in words."""

    stretches: list[list[int]]
    refused: Counter[str]


def find_rest_stretches(nominal: Device, test: ObservedTest) -> RestStretches:
    """Consecutive rows without rotation, at nominal amplitude and under constant commands, while
    the temperature changes by `MAX_WARMING` at most."""
    log, rates = test.log, np.abs(test.inputs.table.rates)
    limits = {
        "without angles or before the loops settle": ~test.rows["gyro_angle"],
        f"more than {AMPLITUDE_TOLERANCE:.0%} off the amplitude": ~is_nominal(log, nominal),
        f"on a table that turns at {REST_RATE / DEG:.2g} deg/s or faster": (
            np.maximum(rates[1:], rates[:-1]) >= REST_RATE
        ),
        "with virtual rotation": log.virtual_rotation != 0,
    }
    is_rest, refused = np.ones(len(log.time), dtype=bool), Counter[str]()
    for limit, exceeds in limits.items():
        refused[limit] += int(np.sum(is_rest & exceeds))
        is_rest &= ~exceeds
    commands = np.column_stack([getattr(log, name) for name in COMMAND_COLUMNS])
    groups = groupby(range(len(is_rest)), key=lambda i: (bool(is_rest[i]), *commands[i].tolist()))
    stretches = []
    for rows in (list(group) for (is_stretch, *_), group in groups if is_stretch):
        if len(rows) < MIN_STRETCH_ROWS:
            refused[f"in stretches of less than {MIN_STRETCH_ROWS} rows"] += len(rows)
        elif np.ptp(test.inputs.temperatures[rows]) > MAX_WARMING:
            refused[f"while the temperature changed by more than {MAX_WARMING:g} K"] += len(rows)
        else:
            stretches.append(rows)
    return RestStretches(stretches, +refused)
