"""Progress of long computations on standard error: silent unless the caller asks for it."""

import sys
from collections.abc import Callable
from typing import Any, Self

Show = bool | Callable[[str], object] | None
"""What a caller may ask for: nothing, a bar and lines on standard error (True), or calls of a
function with each line."""
DELAY = 2.0
"""Time after which a bar appears, s. Chosen: short work shows none."""


class Progress:
    """A bar with the share that is done and the time that is left, and lines that stay. The bar
    goes to a terminal alone. The methods may be called from any thread."""

    def __init__(self, show: Show, title: str = "", unit: str = "") -> None:
        self._show, self._title = show, title
        self._layout = (
            f"{{desc}} {{percentage:3.0f}}%|{{bar}}| {{n}}/{{total}} {unit} "
            "[{elapsed}<{remaining}]"
        )
        self._bar: Any = None

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
        if self._bar is None:
            from tqdm import tqdm

            self._bar = tqdm(
                desc=self._title,
                total=total,
                bar_format=self._layout,
                delay=DELAY,
                file=sys.stderr,
                leave=False,
                disable=None,
            )
        self._bar.total = total
        self._bar.update(done - self._bar.n)

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
