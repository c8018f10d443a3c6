"""Positions in ASCII messages of NovAtel receivers, such as BESTGNSSPOSA (OEM7 Commands and Logs
Reference: message header, BESTPOS, 32-bit CRC)."""

import zlib
from pathlib import Path

from pyhrg.common.errors import HrgError, quote

MESSAGES = ("BESTGNSSPOSA", "BESTPOSA", "BESTGPSPOSA", "PPPPOSA", "PSRPOSA", "RTKPOSA")
"""Messages of one layout. A file may have others, which are left out."""
WEEK, SECONDS = 5, 6
"""Places in a message's header."""
SOLVED = "SOL_COMPUTED"
STATUS, KIND, LATITUDE, LONGITUDE, HEIGHT, UNDULATION = range(6)
SIGMAS = slice(7, 10)
"""Places in its body. The height is above the geoid, which is `UNDULATION` above the ellipsoid."""
BY_INS = "INS"
"""Kinds of position that begin so come from the receiver's own inertial navigator: they are no
fixes."""
SECONDS_PER_WEEK = 604_800.0


def is_novatel(text: str) -> bool:
    """Whether a text begins with a NovAtel message."""
    return text.startswith(("#", "%")) and ";" in text.split("\n", 1)[0]


def split_positions(source: Path, text: str) -> list[tuple[int, list[str]]]:
    """Number and fields of each solved position: seconds of the first message's week, latitude and
    longitude, deg, height above the ellipsoid, m, and its standard deviations north, east, down, m.
    A receiver that sends several kinds of position gives the first of `MESSAGES`.

    Raises:
        HrgError: a message whose checksum is another; none with a position.
    """
    lines = list(enumerate(text.splitlines(), start=1))
    sent = {line[1:].split(",", 1)[0] for _, line in lines if line.startswith("#")}
    name = next((each for each in MESSAGES if each in sent), None)
    if name is None:
        found = ", ".join(sorted(sent)) or "none"
        raise HrgError(f"{source}: messages: found {found}, expected one of {', '.join(MESSAGES)}")
    rows: list[tuple[int, list[str]]] = []
    first_week = None
    for number, line in lines:
        if not line.startswith(f"#{name},"):
            continue
        header, body = _read_message(source, number, line)
        if body[STATUS] != SOLVED or body[KIND].startswith(BY_INS):
            continue
        try:
            week, seconds = int(header[WEEK]), float(header[SECONDS])
            height = float(body[HEIGHT]) + float(body[UNDULATION])
        except ValueError:
            found = f"row {number}: found {quote(line[:80])}"
            raise HrgError(f"{source}: {found}, expected week, seconds and heights") from None
        first_week = week if first_week is None else first_week
        time = seconds + SECONDS_PER_WEEK * (week - first_week)
        place = [body[LATITUDE], body[LONGITUDE], repr(height), *body[SIGMAS]]
        rows.append((number, [repr(time), *place]))
    return rows


def _read_message(source: Path, number: int, line: str) -> tuple[list[str], list[str]]:
    """Fields of header and body of a message whose checksum is right."""
    message, _, checksum = line[1:].strip().rpartition("*")
    computed = zlib.crc32(message.encode(), 0xFFFFFFFF) ^ 0xFFFFFFFF
    if checksum.lower() != f"{computed:08x}":
        found = f"row {number}: found checksum {quote(checksum)}"
        raise HrgError(f"{source}: {found}, expected {computed:08x}: a line that is damaged")
    header, _, body = message.partition(";")
    parts = header.split(","), body.split(",")
    if len(parts[0]) <= SECONDS or len(parts[1]) < SIGMAS.stop:
        raise HrgError(f"{source}: row {number}: found too few fields, expected those of BESTPOS")
    return parts
