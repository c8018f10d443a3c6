"""Whatever fails while a file is read becomes one clear refusal."""

from collections.abc import Iterator
from contextlib import contextmanager

from pyhrg.common.errors import HrgError


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
