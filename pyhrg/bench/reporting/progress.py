"""Progress of a long run: tests on a bar, and one line for each test that is over."""

import time

from pyhrg.common.progress import Progress, Show


class BenchProgress(Progress):
    """Counts tests, and power-ons within each; its methods may be called from any thread."""

    def __init__(self, show: Show) -> None:
        super().__init__(show, unit="tests")
        self._test, self._begun = "", time.monotonic()
        self._times: list[float] = []
        self._ended = self._expected = 0

    def expect(self, tests: int) -> None:
        """State how many tests there are."""
        self._expected = tests
        self.update(0, tests)

    def begin(self, test: str) -> None:
        """State that a test begins."""
        self._test, self._begun = test, time.monotonic()
        self._times = []
        self.describe(test)

    def add_power_on(self, duration: float) -> None:
        """Count a power-on that is over; its duration is the gyro's time, s."""
        self._times.append(duration)
        self.describe(f"{self._test}: {self._work}")

    def end(self) -> None:
        """State that the test is over."""
        self._ended += 1
        self.update(self._ended, self._expected)
        work = f"{self._work}, " if self._times else ""
        self.say(f"{self._test}: {work}{time.monotonic() - self._begun:.0f} s")

    @property
    def _work(self) -> str:
        count = len(self._times)
        plural = "" if count == 1 else "s"
        return f"{count} power-on{plural}, {sum(self._times) / 3600:.3g} h of the gyro"
