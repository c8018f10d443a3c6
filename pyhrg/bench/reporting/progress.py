"""What a long run tells on standard error: a bar on a terminal, and a line for each test done."""

import sys
import time
from types import TracebackType

from tqdm import tqdm


class Progress:
    """Counts tests, and power-ons within each; may be told from any thread."""

    def __init__(self, tests: int) -> None:
        self._bar = tqdm(
            total=tests, bar_format="{n}/{total} tests, {desc} [{elapsed}]", disable=None
        )
        self._begin("")

    def __enter__(self) -> "Progress":
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._bar.leave = False
        self._bar.close()

    def begin(self, test: str) -> None:
        """A test begins."""
        self._begin(test)
        self._bar.set_description_str(test)

    def _begin(self, test: str) -> None:
        self._test, self._begun = test, time.monotonic()
        self._times: list[float] = []

    def power_on(self, duration: float) -> None:
        """A power-on of a length in s is over."""
        self._times.append(duration)
        self._bar.set_description_str(f"{self._test}: {self._work}")

    def end(self) -> None:
        """The test is over."""
        self._bar.update()
        work = f"{self._work}, " if self._times else ""
        self.say(f"{self._test}: {work}{time.monotonic() - self._begun:.0f} s")

    def say(self, text: str) -> None:
        """A line that stays."""
        self._bar.write(text, file=sys.stderr)

    @property
    def _work(self) -> str:
        count = len(self._times)
        plural = "" if count == 1 else "s"
        return f"{count} power-on{plural}, {sum(self._times) / 3600:.3g} h of the gyro"
