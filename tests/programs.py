"""Programs that pip can't bring: a test that needs one is marked, and is listed where it can't run.

`@pytest.mark.needs("wine")` marks a test; `pytestmark` and `pytest.param(marks=...)` work too.
`conftest.py` loads the hooks below.
"""

import ctypes
import os
import shutil
import subprocess
from collections import Counter
from collections.abc import Callable
from functools import lru_cache
from pathlib import Path

import pytest

REQUIRE_VARIABLE = "HRG_REQUIRE_PROGRAMS"
"""Environment variable. Where it is set, a missing program fails its tests; `.ci/run` sets it."""

SANITIZER_LIBRARIES = ("libasan.so", "libubsan.so")


def find_chromium() -> str | None:
    """Path of a Chromium, under whichever name it is installed; None where it is not."""
    names = ("chromium", "chromium-browser", "google-chrome")
    return next(filter(None, map(shutil.which, names)), None)


def _has_sanitizers() -> bool:
    """Whether gcc comes with the libraries of its sanitizers."""
    if shutil.which("gcc") is None:
        return False
    commands = (["gcc", f"-print-file-name={library}"] for library in SANITIZER_LIBRARIES)
    answers = (subprocess.run(c, capture_output=True, text=True, check=True) for c in commands)
    return all(Path(answer.stdout.strip()).is_absolute() for answer in answers)


def _has_tbb() -> bool:
    try:
        ctypes.CDLL("libtbb.so.12")
    except OSError:
        return False
    return True


SEARCHES: dict[str, Callable[[], bool]] = {
    "chromium": lambda: find_chromium() is not None,
    "gcc with sanitizers": _has_sanitizers,
    "libc6-arm64-cross": Path("/usr/aarch64-linux-gnu/lib/ld-linux-aarch64.so.1").exists,
    "libtbb12": _has_tbb,
}
"""How to find what is more, or other, than one program of that name on the PATH."""


@lru_cache
def is_installed(name: str) -> bool:
    """Whether a test that needs this program can run here."""
    return SEARCHES[name]() if name in SEARCHES else shutil.which(name) is not None


def pytest_configure(config: pytest.Config) -> None:
    """Make the marker known."""
    text = "needs(*programs): the test runs only where these programs are installed"
    config.addinivalue_line("markers", text)


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_setup(item: pytest.Item) -> None:
    """Skip a test whose program is missing, or fail it, before any of its fixtures is made."""
    names = dict.fromkeys(name for mark in item.iter_markers("needs") for name in mark.args)
    missing = ", ".join(name for name in names if not is_installed(name))
    if missing and os.environ.get(REQUIRE_VARIABLE):
        pytest.fail(f"{missing} is missing: CONTRIBUTING.md says how to install it", pytrace=False)
    if missing:
        pytest.skip(f"needs {missing}")


@pytest.hookimpl(trylast=True)
def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """List at the end how many tests did not run, by the program that they need."""
    counts: Counter[str] = Counter()
    for report in terminalreporter.stats.get("skipped", []):
        reason = str(report.longrepr[2]).removeprefix("Skipped: ")
        if reason.startswith("needs "):
            counts[reason] += 1
    for reason, count in sorted(counts.items()):
        terminalreporter.write_line(f"not run: {reason}: {count} test{'s' * (count > 1)}")
