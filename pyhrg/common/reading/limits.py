"""The limits of all readers, and whatever fails while a file is read as one clear refusal. Sizes
are computed and refused before memory is taken.
"""

from collections.abc import Iterator
from contextlib import contextmanager

from pyhrg.common.errors import HrgError

MEBIBYTE = 2**20

DOCUMENT_BYTES = 16 * MEBIBYTE
"""Largest TOML or JSON document. Chosen: a hundred times those of a study of 1000 triads; as
objects of Python it takes up to thirty times as much memory."""
XML_BYTES = 32 * MEBIBYTE
"""Largest XML document. Chosen: the description of an FMU with 150 000 variables."""
LOG_BYTES = 512 * MEBIBYTE
"""Largest log, FMU or mission file, unpacked. Chosen: 12 h of an IMU at 200 Hz as text; parsed it
takes about eight times as much memory. Longer records are split, or stored as Parquet."""
LINE_BYTES = 2**17
"""Largest mean length of a text's lines. Chosen: that of a field of Python's CSV reader; a log has
about a hundred bytes a line."""
EXPANSION = 100
"""Largest ratio of unpacked to packed bytes. Chosen: logs of constant columns reach about 50, data
made to fill a memory 1000."""
FREE_EXPANSION = 64 * MEBIBYTE
"""Unpacked size below which the ratio is not looked at. Chosen: it fills no memory."""
ARCHIVE_ENTRIES = 10_000
"""Largest number of files in an archive. Chosen: FMUs have tens to hundreds."""
LARGEST_NUMBER = 1e12
"""Largest size of a number in a log. Chosen: beyond any reading in any unit, and any time in s; its
square and the sum of all squares are still numbers."""


def compute_expanded_limit(size: int) -> int:
    """Largest number of bytes that `size` packed bytes may unpack to."""
    return max(FREE_EXPANSION, EXPANSION * size)


def check_size(source: object, size: int, most: int) -> None:
    """Refuse a size in bytes above the most."""
    if size > most:
        raise HrgError(
            f"{source}: found {size / MEBIBYTE:.1f} MiB or more, expected at most "
            f"{most / MEBIBYTE:g} MiB"
        )


@contextmanager
def refuse_unreadable(source: object, expected: str) -> Iterator[None]:
    """Turn every failure of the block into an `HrgError`.

    Parsers raise more kinds of errors than they document: of recursion, overflow, memory, lookup.

    source: the file, and the place in it, for the message; expected: what it should be.
    """
    try:
        yield
    except HrgError:
        raise
    except Exception as error:
        if isinstance(error, OSError) and error.strerror:
            raise HrgError(f"{source}: can't be read: {error.strerror}") from error
        reason = str(error) or type(error).__name__
        raise HrgError(f"{source}: found what is no {expected}: {reason}") from error
