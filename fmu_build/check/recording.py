"""What an importer recorded, or why it didn't."""

from dataclasses import dataclass

Trace = dict[str, list[float]]
"""Recorded outputs by name, one value a communication point after the start."""


@dataclass(frozen=True)
class Recording:
    """What an importer recorded; `remark` says what had to be done for it."""

    trace: Trace
    remark: str = ""


class FailedError(Exception):
    """The importer refused the FMU, failed or crashed."""


def read_last_line(text: str) -> str:
    """What a program said last: where it failed, the reason."""
    lines = [line for line in text.splitlines() if line.strip()]
    return lines[-1] if lines else "it ended without a word"
