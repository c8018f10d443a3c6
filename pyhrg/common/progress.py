"""Progress of long computations on standard error: silent unless the caller asks for it."""

import sys
import time
from collections.abc import Callable
from typing import Any, Self

Show = bool | Callable[[str], object] | None
"""What a caller may ask for: nothing, a bar and lines on standard error (True), or calls of a
function with each line."""
DELAY = 2.0
"""Time after which a bar appears, s. Chosen: short work shows none."""
LINE_SPACING = 30.0
"""Time between two lines of progress where no terminal shows a bar, s. Chosen: a line per 30 s
tells that the work goes on, and an hour of it fills two screens."""


class Progress:
    """A bar with the share that is done and the time that is left, and lines that stay. The bar
    goes to a terminal alone; whatever else reads gets a line of it each `LINE_SPACING`. The methods
    may be called from any thread."""

    def __init__(self, show: Show, title: str = "", unit: str = "") -> None:
        self._show, self._title = show, title
        self._layout = (
            f"{{desc}} {{percentage:3.0f}}%|{{bar}}| {{n}}/{{total}} {unit} "
            "[{elapsed}<{remaining}]"
        )
        self._unit = unit
        self._bar: Any = None
        self._last_line = time.monotonic()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        """Remove the bar."""
        if self._bar is not None:
            self._bar.close()

    def update(self, done: int, total: int) -> None:
        """State how many of how many are done."""
        if self._show is not True:
            return
        if not sys.stderr.isatty():
            self._write_line(done, total)
            return
        if self._bar is None:
            from tqdm import tqdm

            self._bar = tqdm(
                desc=self._title,
                total=total,
                bar_format=self._layout,
                delay=DELAY,
                file=sys.stderr,
                leave=False,
            )
        self._bar.total = total
        self._bar.update(done - self._bar.n)

    def _write_line(self, done: int, total: int) -> None:
        now = time.monotonic()
        if now - self._last_line >= LINE_SPACING:
            self._last_line = now
            self.say(f"{self._title}: {done} of {total} {self._unit}".rstrip())

    def describe(self, text: str) -> None:
        """Change the text before the bar."""
        self._title = text
        if self._bar is not None:
            self._bar.set_description_str(text)

    def say(self, text: str) -> None:
        """Write a line that stays."""
        if self._bar is not None:
            self._bar.write(text, file=sys.stderr)
        elif self._show is True:
            print(text, file=sys.stderr, flush=True)
        elif callable(self._show):
            self._show(text)
