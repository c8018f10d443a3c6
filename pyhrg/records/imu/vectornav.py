"""IMU logs in ASCII messages of VectorNav sensors, axes forward, right, down.

VectorNav ASCII output: VNDTV (register 80), VNIMU (54), VNYMR (27), VNINS (63), asynchronous output
frequency (7); Safran VersaSync User Manual, section 5.3.4 "ASCII Output Settings", has them.
"""

from array import array
from collections.abc import Sequence

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.reading.messages import Message, choose_message, read_messages, unroll_weeks
from pyhrg.records.columns import LogError
from pyhrg.records.imu.log import (
    ACCELEROMETERS,
    AXES,
    GYROS,
    MIN_ROWS,
    VELOCITY,
    RecordedImu,
)
from pyhrg.records.imu.table_log import MAX_INTERVAL, MIN_INTERVAL, build_log

INCREMENTS = "VNDTV"
"""Message of increments, with the time over which each was integrated."""
MESSAGES = {
    INCREMENTS: (GYROS[1], VELOCITY, (0, 1, 2, 3, 4, 5, 6)),
    "VNIMU": (GYROS[2], ACCELEROMETERS[1], (6, 7, 8, 3, 4, 5)),
    "VNYMR": (GYROS[2], ACCELEROMETERS[1], (9, 10, 11, 6, 7, 8)),
}
"""Quantities of gyros and accelerometers, and places of what is read: of increments the time, then
gyros and accelerometers."""
NAVIGATION = "VNINS"
"""Message that begins with seconds of the GPS week, and the week."""
ANSWERS, FREQUENCY = ("VNRRG", "VNWRG"), 7
"""The sensor's answers that state a register, and the register of the messages' frequency in Hz."""


def read_vectornav(source: str, lines: Sequence[str], trusted: bool = False) -> RecordedImu:
    """The log of a file's messages; for `trusted` see `read_imu_log`.

    Where VNINS messages stand between, times are seconds of the first one's GPS week, to within an
    interval; otherwise they begin at zero. The first VNDTV is left out: its interval may be another
    one. Samples of VNIMU and VNYMR are taken as means over their intervals.
    """
    name = choose_message(source, lines, MESSAGES)
    gyros, accelerometers, places = MESSAGES[name]
    fields = [f"{kind.name} {axis}" for kind in (gyros, accelerometers) for axis in AXES]
    fields = ["delta time", *fields] if name == INCREMENTS else fields
    rows: list[int] = []
    values, clock, frequency = array("d"), array("d"), None
    for message in read_messages(source, lines, (name, NAVIGATION, *ANSWERS)):
        if message.name == name:
            rows.append(message.row)
            values.extend(
                message.parse_number(message.body, field, place)
                for field, place in zip(fields, places, strict=True)
            )
        elif message.name == NAVIGATION:
            clock.extend([len(rows), *_read_time(message)])
        else:
            frequency = _read_frequency(message) or frequency
    if len(rows) < MIN_ROWS:
        raise LogError(f"{source}: found {len(rows)} {name}, expected at least {MIN_ROWS}")
    table = np.frombuffer(values).reshape(len(rows), -1)
    if name == INCREMENTS:
        elapsed = np.cumsum(table[:, 0])
    elif frequency:
        elapsed = np.arange(1, len(rows) + 1) / frequency
    else:
        raise LogError(
            f"{source}: found {name} without its frequency, expected what the sensor answers when "
            f"register {FREQUENCY} is read, such as $VNRRG,07,100*XX at 100 Hz, in a line besides"
        )
    time = elapsed + _find_offset(elapsed, np.frombuffer(clock).reshape(-1, 3))
    first = 1 if name == INCREMENTS else 0
    readings = np.column_stack([time, table[:, -6:]])
    return build_log(source, (gyros, accelerometers), readings[first:], rows[first:], trusted)


def _read_time(message: Message) -> tuple[float, float]:
    """GPS week, and seconds of it."""
    seconds, week = (message.parse_number(message.body, *f) for f in (("time", 0), ("week", 1)))
    return week, seconds


def _read_frequency(message: Message) -> float | None:
    """The frequency of messages, Hz, in an answer; None if it is of another register."""
    if message.parse_number(message.body, "register", 0) != FREQUENCY:
        return None
    frequency = message.parse_number(message.body, "frequency", 1)
    low, high = 1 / MAX_INTERVAL, 1 / MIN_INTERVAL
    if not low <= frequency <= high:
        found = f"found {frequency:g}, expected {low:g} to {high:g} Hz"
        raise message.refuse(f", frequency: {found}")
    return frequency


def _find_offset(elapsed: Array, clock: Array) -> float:
    """GPS time less the elapsed time, s; zero if no message tells.

    elapsed: (n,) times of the rows; clock: (m, 3) rows before a message, its GPS week and seconds
    of it; the week is zero before the receiver knows it.
    """
    known = clock[(clock[:, 0] > 0) & (clock[:, 1] > 0)]
    if not len(known):
        return 0.0
    return float(
        np.median(unroll_weeks(known[:, 1], known[:, 2]) - elapsed[known[:, 0].astype(int) - 1])
    )
