"""Progress of long computations: silent unless the caller asks for it."""

import sys
from collections.abc import Callable
from functools import partial

Progress = bool | Callable[[str], None] | None
"""What a caller may ask for: nothing, lines on standard error (True), or calls of a function."""


def make_progress_reporter(progress: Progress) -> Callable[[str], None]:
    """A function that is called with a line of text at each step."""
    if callable(progress):
        return progress
    return partial(print, file=sys.stderr, flush=True) if progress else lambda text: None
