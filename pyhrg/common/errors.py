"""The one exception that users of this project catch, and how values are shown in a line."""

from collections.abc import Mapping, Sized
from dataclasses import MISSING, Field, fields
from pathlib import Path
from typing import Any

LONGEST_MESSAGE = 1000
"""Largest number of characters of a message. Chosen: it fits on a screen."""
LONGEST_VALUE = 100
"""Largest number of characters of a value in a message. Chosen: longer than any value meant."""
LONGEST_FIELD = 40
"""Largest number of characters of a field's text in an object's line. Chosen."""
MOST_FIELDS = 6
"""Largest number of fields in an object's line. Chosen: about one line of a terminal."""


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


def describe_briefly(value: Any) -> str:
    """A dataclass in one line: its name, then the first fields that differ from their defaults,
    with the size of what is large. Assigned to `__repr__` of objects that users hold."""
    named_first = sorted(fields(value), key=lambda field: field.name != "name")
    parts = [
        f"{field.name}={_describe_field(getattr(value, field.name))}"
        for field in named_first
        if not _is_default(field, getattr(value, field.name))
    ]
    more = ["..."] if len(parts) > MOST_FIELDS else []
    return f"{type(value).__name__}({', '.join([*parts[:MOST_FIELDS], *more])})"


def _is_default(field: "Field[Any]", value: object) -> bool:
    default = field.default
    if default is MISSING and field.default_factory is not MISSING:
        default = field.default_factory()
    return type(default) is type(value) and repr(default) == repr(value)


def _describe_field(value: Any) -> str:
    if value is None or isinstance(value, bool | int | str | Path):
        return _shorten(repr(value), LONGEST_FIELD)
    if isinstance(value, float):
        return f"{value:.6g}"
    if hasattr(value, "shape"):
        return f"<{' x '.join(map(str, value.shape))} {type(value).__name__}>"
    if isinstance(value, Sized):
        noun = "key" if isinstance(value, Mapping) else "item"
        return f"<{len(value)} {noun}{'' if len(value) == 1 else 's'}>"
    name = getattr(value, "name", "")
    return f"<{type(value).__name__}{f' {name}' if isinstance(name, str) and name else ''}>"
