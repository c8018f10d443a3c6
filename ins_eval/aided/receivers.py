"""Positions in ASCII messages of receivers.

NovAtel: BESTGNSSPOSA and others of its layout (OEM7 Commands and Logs Reference, BESTPOS).
VectorNav: VNGPS (register 58; Safran VersaSync User Manual, section 5.3.4.12).
"""

from collections.abc import Iterable, Iterator
from pathlib import Path

from pyhrg.common.reading.messages import SECONDS_PER_WEEK, Message, choose_message, read_messages

NOVATEL = ("BESTGNSSPOSA", "BESTPOSA", "BESTGPSPOSA", "PPPPOSA", "PSRPOSA", "RTKPOSA")
"""Messages of one layout. A file may have others, which are left out."""
WEEK, SECONDS = 5, 6
"""Places in a NovAtel message's header."""
SOLVED = "SOL_COMPUTED"
STATUS, KIND, LATITUDE, LONGITUDE, HEIGHT, UNDULATION = range(6)
SIGMAS = slice(7, 10)
"""Places in its body. The height is above the geoid, which is `UNDULATION` above the ellipsoid."""
BY_INS = "INS"
"""Kinds of position that begin so come from the receiver's own inertial navigator: they are no
fixes."""
VECTORNAV = ("VNGPS",)
"""VNINS comes from the sensor's own inertial navigator: it is no fix."""
VN_SECONDS, VN_WEEK, VN_FIX = range(3)
VN_POSITION, VN_VELOCITY, VN_SIGMAS, VN_SPEED_SIGMA = slice(4, 7), slice(7, 10), slice(10, 13), 13
"""Places in the body of VNGPS. The height is above the ellipsoid."""
WITH_HEIGHT = 3
"""Kind of a VectorNav fix in three dimensions."""


def split_novatel(source: Path, text: str) -> list[tuple[int, list[str]]]:
    """Row and fields of each solved position: seconds of the first message's week, latitude and
    longitude, deg, height above the ellipsoid, m, and its standard deviations north, east, down, m.
    A receiver that sends several kinds of position gives the first of `NOVATEL`.

    Raises:
        HrgError: a message whose checksum is another, or that is too short; none with a position.
    """
    return list(_add_times(_split_novatel(source, text)))


def _split_novatel(source: Path, text: str) -> Iterator[tuple[Message, float, float, list[str]]]:
    lines = text.splitlines()
    name = choose_message(str(source), lines, NOVATEL)
    for message in read_messages(str(source), lines, (name,)):
        body = message.body
        message.require(body, "standard deviations", SIGMAS.stop - 1)
        if body[STATUS] != SOLVED or body[KIND].startswith(BY_INS):
            continue
        week = message.parse_number(message.header, "week", WEEK)
        seconds = message.parse_number(message.header, "seconds", SECONDS)
        height = sum(
            message.parse_number(body, name, place)
            for name, place in (("height", HEIGHT), ("undulation", UNDULATION))
        )
        place = [body[LATITUDE], body[LONGITUDE], repr(height), *body[SIGMAS]]
        yield message, week, seconds, place


def split_vectornav(source: Path, text: str) -> list[tuple[int, list[str]]]:
    """Row and fields of each position: as of `split_novatel`, then the velocity north, east, down
    and its standard deviation, m/s.

    Raises:
        HrgError: a message whose checksum is another, or that is too short; none with a position.
    """
    return list(_add_times(_split_vectornav(source, text)))


def _split_vectornav(source: Path, text: str) -> Iterator[tuple[Message, float, float, list[str]]]:
    lines = text.splitlines()
    choose_message(str(source), lines, VECTORNAV)
    for message in read_messages(str(source), lines, VECTORNAV):
        body = message.body
        message.require(body, "speed accuracy", VN_SPEED_SIGMA)
        if message.parse_number(body, "fix", VN_FIX) != WITH_HEIGHT:
            continue
        week = message.parse_number(body, "week", VN_WEEK)
        seconds = message.parse_number(body, "time", VN_SECONDS)
        fields = [*body[VN_POSITION], *body[VN_SIGMAS], *body[VN_VELOCITY], body[VN_SPEED_SIGMA]]
        yield message, week, seconds, fields


def _add_times(
    positions: Iterable[tuple[Message, float, float, list[str]]],
) -> Iterator[tuple[int, list[str]]]:
    """Row, and fields with the time before them, in seconds of the first GPS week."""
    first = None
    for message, week, seconds, fields in positions:
        first = week if first is None else first
        yield message.row, [repr(seconds + SECONDS_PER_WEEK * (week - first)), *fields]
