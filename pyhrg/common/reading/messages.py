"""ASCII messages of NovAtel receivers and VectorNav sensors, with their checksums.

NovAtel OEM7 Commands and Logs Reference, "ASCII", "Description of ASCII and Binary Logs with Short
Headers", "32-Bit CRC"; VectorNav VN-100 User Manual (UM001), section 3.8 "Checksum / CRC".
"""

import binascii
import re
import zlib
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from functools import reduce
from operator import xor

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError, quote
from pyhrg.common.reading.limits import LARGEST_NUMBER

NOVATEL = re.compile(r"[#%][A-Z][A-Z0-9_]*A,[^;\n]*;")
"""Beginning of a message of NovAtel's, with a long (#) or a short (%) header."""
VECTORNAV = "$VN"
"""Beginning of a message of VectorNav's."""
UNCHECKED = "XX"
"""Checksum of a VectorNav message that is not to be checked."""
SECONDS_PER_WEEK = 604_800.0


@dataclass(frozen=True)
class Message:
    """A message whose checksum is right.

    Attributes:
        source, row: the file, and the line in it, from 1.
        name: such as RAWIMUSXA or VNIMU.
        header: fields of NovAtel's header, the name first; empty for VectorNav's.
        body: its other fields.
    """

    source: str
    row: int
    name: str
    header: list[str]
    body: list[str]

    def require(self, fields: Sequence[str], name: str, place: int) -> str:
        """A field of the header or the body; without it, the message is refused."""
        if place >= len(fields):
            raise self.refuse(f": found too few fields, expected {name} after them")
        return fields[place].strip()

    def parse_number(self, fields: Sequence[str], name: str, place: int) -> float:
        """The number in a field, which is finite and not larger than anything measured."""
        text = self.require(fields, name, place)
        try:
            value = float(text)
        except ValueError:
            found = quote(text) if text else "nothing"
            raise self.refuse(f", {name}: found {found}, expected a number") from None
        if not abs(value) <= LARGEST_NUMBER:
            expected = f"a finite number of at most {LARGEST_NUMBER:g} in size"
            raise self.refuse(f", {name}: found {text}, expected {expected}")
        return value

    def refuse(self, trouble: str) -> HrgError:
        """Make the error about this message."""
        return HrgError(f"{self.source}: row {self.row}{trouble}")


def is_novatel(text: str) -> bool:
    """Whether a text begins with a message of NovAtel's."""
    return NOVATEL.match(text) is not None


def is_vectornav(text: str) -> bool:
    """Whether a text begins with a message of VectorNav's."""
    return text.startswith(VECTORNAV)


def choose_message(source: str, lines: Sequence[str], names: Collection[str]) -> str:
    """The first of `names` that is among the messages.

    Raises:
        HrgError: none of them.
    """
    sent = {_read_name(line) for line in lines} - {""}
    chosen = next((name for name in names if name in sent), None)
    if chosen is None:
        found, expected = ", ".join(sorted(sent)), ", ".join(names)
        raise HrgError(f"{source}: messages: found {found}, expected one of {expected}")
    return chosen


def read_messages(source: str, lines: Sequence[str], names: Collection[str]) -> Iterator[Message]:
    """The messages that have one of these names; all other lines are passed over.

    Raises:
        HrgError: a checksum is not the message's.
    """
    for row, line in enumerate(lines, start=1):
        name = _read_name(line)
        if name not in names:
            continue
        text, _, checksum = line[1:].strip().rpartition("*")
        computed = _compute_checksum(line[0], text, len(checksum))
        if checksum.lower() != computed and (line[0], checksum) != ("$", UNCHECKED):
            found = f"row {row}: found checksum {quote(checksum)}"
            raise HrgError(f"{source}: {found}, expected {computed}: a line that is damaged")
        if line[0] == "$":
            yield Message(source, row, name, [], text.split(",")[1:])
        else:
            header, _, body = text.partition(";")
            yield Message(source, row, name, header.split(","), body.split(","))


def unroll_weeks(week: Array, seconds: Array) -> Array:
    """Times (n,) in seconds of the first GPS week, from weeks (n,) and seconds of them (n,)."""
    return np.asarray(seconds + SECONDS_PER_WEEK * (week - week[:1]))


def _read_name(line: str) -> str:
    """Name of the message that a line is; empty if it is none."""
    return line[1:].split(",", 1)[0] if line.startswith(("#", "%", VECTORNAV)) else ""


def _compute_checksum(sign: str, text: str, length: int) -> str:
    """A message's checksum: NovAtel's is a 32-bit CRC; VectorNav's is the exclusive or of all bytes
    if it has two digits, and CRC16-CCITT if it has four."""
    data = text.encode()
    if sign != "$":
        return f"{zlib.crc32(data, 0xFFFFFFFF) ^ 0xFFFFFFFF:08x}"
    return f"{binascii.crc_hqx(data, 0):04x}" if length == 4 else f"{reduce(xor, data, 0):02x}"
