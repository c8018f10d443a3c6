"""The one exception that users of this project catch, and how it shows what was found."""

LONGEST_MESSAGE = 1000
"""Largest number of characters of a message. Chosen: it fits on a screen."""
LONGEST_VALUE = 100
"""Largest number of characters of a value in a message. Chosen: longer than any value meant."""


class HrgError(Exception):
    """An error that the user can correct. Its message is one line that names the file, the field,
    what was found and what was expected.

    A class is derived from it where code catches that kind alone. The command `hrg` prints the
    message and ends with status 2.
    """

    def __str__(self) -> str:
        return fold_line(super().__str__())


def fold_line(text: str) -> str:
    """A text as one line of at most `LONGEST_MESSAGE` printable characters."""
    line = _shorten(" ".join(text.splitlines()), LONGEST_MESSAGE)
    shown = (c if c.isprintable() else c.encode("unicode_escape").decode("ascii") for c in line)
    return _shorten("".join(shown), LONGEST_MESSAGE)


def quote(value: object) -> str:
    """A value of a user's as it is shown in a message, shortened to `LONGEST_VALUE` characters."""
    try:
        return _shorten(repr(value), LONGEST_VALUE)
    except (ValueError, RecursionError):  # an integer of thousands of digits, or deep nesting
        return f"a value of type {type(value).__name__} that is too large to show"


def _shorten(text: str, most: int) -> str:
    half = most // 2 - 3
    return text if len(text) <= most else f"{text[:half]} ... {text[-half:]}"
