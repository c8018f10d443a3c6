"""IMU logs in ASCII messages of NovAtel receivers: counts of RAWIMU, axes right, forward, up.

NovAtel OEM7 Commands and Logs Reference, RAWIMU, RAWIMUS, RAWIMUX, RAWIMUSX ("Table: Raw IMU Scale
Factors") and INSCONFIG.
"""

from array import array
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pyhrg.common.errors import quote
from pyhrg.common.reading.messages import Message, choose_message, read_messages, unroll_weeks
from pyhrg.common.units import ARCSEC, DEG, MICRO_G
from pyhrg.records.columns import LogError
from pyhrg.records.imu.log import MIN_ROWS, Quantity, RecordedImu
from pyhrg.records.imu.table_log import build_log

EXTENSION = 2
"""Number of fields that extended messages have before the others': error flags and type."""
EXTENDED = ("RAWIMUSXA", "RAWIMUXA")
MESSAGES = (*EXTENDED, "RAWIMUSA", "RAWIMUA")
CONFIGURATION = "INSCONFIGA"
"""Message whose first field names the IMU."""
FIELDS = {0: "week", 1: "seconds", 3: "z accel", 4: "-y accel", 5: "x accel", 6: "z gyro",
          7: "-y gyro", 8: "x gyro"}  # fmt: skip
"""Fields that are read, by their places."""
FAILED = 1
"""Bit of the error flags that says that the IMU found an error."""
TO_BODY = np.array([[0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [-1.0, 0.0, 0.0]])
"""Matrix from counts along z, -y and x, of axes right, forward, up, to body axes."""
KINDS = (Quantity("gyro", "", 1.0, True), Quantity("accel", "", 1.0, True))
FOOT = 0.3048
"""m."""


@dataclass(frozen=True)
class Scale:
    """What a count means: `angle` in rad, `velocity` in m/s."""

    angle: float
    velocity: float


HONEYWELL = Scale(2.0**-33, 2.0**-27 * FOOT)
HONEYWELL_COARSE = Scale(2.0**-33, 2.0**-26 * FOOT)
HG4930 = Scale(2.0**-33, 2.0**-29)
LITEF = Scale(1e-9, 2e-8)
STIM300 = Scale(2.0**-21 * DEG, 2.0**-22)
KVH = Scale(0.1 / (3600 * 256), 0.05 * 2.0**-15)
SCALES = {
    (1, "HG1700_AG11"): HONEYWELL,
    (4, "HG1700_AG17"): HONEYWELL_COARSE,
    (5, "HG1900_CA29"): HONEYWELL,
    (8, "LN200"): Scale(2.0**-19, 2.0**-14),
    (11, "HG1700_AG58"): HONEYWELL,
    (12, "HG1700_AG62"): HONEYWELL_COARSE,
    (13, "IMAR_FSAS"): Scale(0.1 * 2.0**-8 * ARCSEC, 0.05 * 2.0**-15),
    (16, "KVH_COTS"): KVH,
    (20, "HG1930_AA99"): HONEYWELL,
    (26, "ISA100C"): LITEF,
    (27, "HG1900_CA50"): HONEYWELL,
    (28, "HG1930_CA50"): HONEYWELL,
    (31, "ADIS16488"): Scale(720 * 2.0**-31 * DEG, 200 * 2.0**-31),
    (32, "STIM300"): STIM300,
    (33, "KVH_1750"): KVH,
    (41, "EPSON_G320"): Scale(0.008 * 2.0**-16 * DEG / 125, 200 * 2.0**-16 * MICRO_G / 125),
    (52, "LITEF_MICROIMU"): LITEF,
    (56, "STIM300D"): STIM300,
    (58, "HG4930_AN01"): HG4930,
    (61, "EPSON_G370"): Scale(0.0151515 * 2.0**-16 * DEG / 200, 400 * 2.0**-16 * MICRO_G / 200),
    (62, "EPSON_G320_200HZ"): Scale(0.008 * 2.0**-16 * DEG / 200, 200 * 2.0**-16 * MICRO_G / 200),
    (68, "HG4930_AN04"): HG4930,
    (69, "HG4930_AN04_400HZ"): HG4930,
}
"""Scales by the IMU's type, in RAWIMUX a number and in INSCONFIG a name."""


def read_novatel(source: str, lines: Sequence[str], trusted: bool = False) -> RecordedImu:
    """The log of a file's messages; for `trusted` see `read_imu_log`.

    Times are seconds of the first message's GPS week.
    """
    name = choose_message(source, lines, MESSAGES)
    begin = EXTENSION if name in EXTENDED else 0
    rows: list[int] = []
    values, kinds = array("d"), dict[str, Message]()
    for message in read_messages(source, lines, (name,)):
        if begin:
            _check_flags(message, trusted)
            kinds.setdefault(message.require(message.body, "IMU type", 1), message)
        rows.append(message.row)
        values.extend(
            message.parse_number(message.body, field, begin + place)
            for place, field in FIELDS.items()
        )
    if len(rows) < MIN_ROWS:
        raise LogError(f"{source}: found {len(rows)} {name}, expected at least {MIN_ROWS}")
    scale = _find_scale(source, kinds if begin else _read_configuration(source, lines, name))
    table = np.frombuffer(values).reshape(-1, len(FIELDS))
    velocity, rotation = table[:, 2:5] @ TO_BODY.T, table[:, 5:8] @ TO_BODY.T
    time = unroll_weeks(table[:, 0], table[:, 1])
    values_si = np.column_stack([time, scale.angle * rotation, scale.velocity * velocity])
    return build_log(source, KINDS, values_si, rows, trusted, z="up")


def _check_flags(message: Message, trusted: bool) -> None:
    """Refuse a reading of an IMU that says that it failed."""
    text = message.require(message.body, "IMU info", 0)
    try:
        flags = int(text, 16)
    except ValueError:
        raise message.refuse(f", IMU info: found {quote(text)}, expected a hex number") from None
    if flags & FAILED and not trusted:
        raise message.refuse(f", IMU info: found {text}, which says that the IMU failed")


def _read_configuration(source: str, lines: Sequence[str], name: str) -> dict[str, Message]:
    """The names of the IMU in messages of the configuration."""
    configurations = read_messages(source, lines, (CONFIGURATION,))
    kinds = {message.require(message.body, "IMU type", 0): message for message in configurations}
    if not kinds:
        raise LogError(
            f"{source}: found {name}, which does not say of which IMU its counts are: expected "
            f"{CONFIGURATION} besides, or {EXTENDED[0]}"
        )
    return kinds


def _find_scale(source: str, kinds: dict[str, Message]) -> Scale:
    """The scale of the one type of IMU that messages state."""
    if len(kinds) > 1:
        raise LogError(f"{source}: IMU type: found {' and '.join(kinds)}, expected one")
    ((stated, message),) = kinds.items()
    for (number, name), scale in SCALES.items():
        if stated in (f"{number}", name):
            return scale
    known = ", ".join(f"{number} {name}" for number, name in SCALES)
    raise message.refuse(f", IMU type: found {quote(stated)}, expected one of {known}")
