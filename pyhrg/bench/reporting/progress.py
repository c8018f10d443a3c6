"""Progress of a long run: a bar on a terminal, and one line for each test that is over."""

import sys
import time
from collections.abc import Callable

from tqdm import tqdm

Show = bool | Callable[[str], object] | None
"""How progress is shown: True for a bar (on a terminal only) and lines on standard error, a
function that is called with each line, None or False for nothing."""


class Progress:
    """Counts tests, and power-ons within each; its methods may be called from any thread."""

    def __init__(self, show: Show) -> None:
        self._write = show if callable(show) else None
        shape = "{n}/{total} tests, {desc} [{elapsed}<{remaining}]"
        self._bar = tqdm(total=0, bar_format=shape, disable=None) if show is True else None
        self._test, self._begun = "", time.monotonic()
        self._times: list[float] = []

    def close(self) -> None:
        """Remove the bar."""
        if self._bar is not None:
            self._bar.leave = False
            self._bar.close()

    def expect(self, tests: int) -> None:
        """State how many tests there are."""
        if self._bar is not None:
            self._bar.total = tests
            self._bar.refresh()

    def begin(self, test: str) -> None:
        """State that a test begins."""
        self._test, self._begun = test, time.monotonic()
        self._times = []
        self._describe(test)

    def add_power_on(self, duration: float) -> None:
        """Count a power-on that is over; its duration is the gyro's time, s."""
        self._times.append(duration)
        self._describe(f"{self._test}: {self._work}")

    def end(self) -> None:
        """State that the test is over."""
        if self._bar is not None:
            self._bar.update()
        work = f"{self._work}, " if self._times else ""
        self.say(f"{self._test}: {work}{time.monotonic() - self._begun:.0f} s")

    def say(self, text: str) -> None:
        """Write a line that stays."""
        if self._bar is not None:
            self._bar.write(text, file=sys.stderr)
        elif self._write is not None:
            self._write(text)

    def _describe(self, text: str) -> None:
        if self._bar is not None:
            self._bar.set_description_str(text)

    @property
    def _work(self) -> str:
        count = len(self._times)
        plural = "" if count == 1 else "s"
        return f"{count} power-on{plural}, {sum(self._times) / 3600:.3g} h of the gyro"
