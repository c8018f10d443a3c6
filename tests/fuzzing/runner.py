"""Runs cases, each in a process of its own, and says what must not happen."""

import os
import random
import resource
import signal
import sys
import tempfile
import time
import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

from pyhrg.common.errors import LONGEST_MESSAGE, HrgError

MOST_SECONDS = 10
"""Largest processor time of a case."""
MOST_GROWTH = 2**30
"""Largest memory that a case may take beyond that of this process, bytes."""
REFUSED, READ, WRONG = 2, 0, 70


@dataclass(frozen=True)
class Case:
    """Something to be read; prepare: makes it in an empty folder; read: reads it there."""

    name: str
    prepare: Callable[[Path], object]
    read: Callable[[Path], object]


@dataclass(frozen=True)
class Outcome:
    """How a case ended. trouble: what must not happen, empty where nothing of it did."""

    status: int
    message: str
    trouble: str


def run_case(case: Case) -> Outcome:
    """Prepare a case and read it in another process."""
    with tempfile.TemporaryDirectory(prefix="hrg-fuzz-") as name:
        folder = Path(name)
        case.prepare(folder)
        before = _list_content(folder)
        out, into = os.pipe()
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", DeprecationWarning)  # from Python 3.12 on, of threads
            child = os.fork()
        if not child:
            os.close(out)
            _read(case, folder, into)
        os.close(into)
        with os.fdopen(out, errors="replace") as pipe:
            message = pipe.read()
        _, status, usage = os.wait4(child, 0)
        resident, _, message = message.partition("\n")
        growth = 1024 * usage.ru_maxrss - int(resident or 0)
        trouble = _judge(status, message, growth)
        if not trouble and _list_content(folder) != before:
            trouble = "something was written"
        return Outcome(os.waitstatus_to_exitcode(status), message, trouble)


def _read(case: Case, folder: Path, into: int) -> None:
    """Read a case and end the process."""
    status = WRONG
    try:
        pages = int(Path("/proc/self/statm").read_text().split()[1])
        os.write(into, f"{pages * resource.getpagesize()}\n".encode())
        resource.setrlimit(resource.RLIMIT_CPU, (MOST_SECONDS, MOST_SECONDS + 1))
        signal.alarm(20 * MOST_SECONDS)
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        os.dup2(into, 2)
        sys.stderr = os.fdopen(2, "w", closefd=False)
        sys.stdout = os.fdopen(1, "w", closefd=False)
        os.chdir(folder)
        warnings.simplefilter("ignore")
        case.read(folder)
        status = READ
    except (HrgError, OSError) as error:
        text = str(error)
        status = REFUSED if "\n" not in text and len(text) <= LONGEST_MESSAGE else WRONG
        print(text, file=sys.stderr)
    except SystemExit as end:
        status = int(end.code or 0)
    except BaseException:
        sys.excepthook(*sys.exc_info())  # type: ignore[arg-type]
    finally:
        sys.stderr.flush()
        os._exit(status)


def _judge(status: int, message: str, growth: int) -> str:
    if os.WIFSIGNALED(status):
        number = os.WTERMSIG(status)
        hang = number in (signal.SIGXCPU, signal.SIGALRM, signal.SIGKILL)
        return "it hangs" if hang else f"it crashes by signal {number}"
    if growth > MOST_GROWTH:
        return f"it takes {growth / 2**30:.1f} GiB"
    if "Traceback (most recent call last)" in message or os.WEXITSTATUS(status) == WRONG:
        return "a traceback, or more than a line"
    return ""


def _list_content(folder: Path) -> dict[str, float]:
    return {str(p.relative_to(folder)): p.lstat().st_mtime for p in sorted(folder.rglob("*"))}


def find_troubles(cases: Iterator[Case], say: Callable[[str], None]) -> tuple[int, int, int]:
    """Run cases; returns how many were read, refused, and in trouble, which is said."""
    counts = {READ: 0, REFUSED: 0, WRONG: 0}
    begin = time.monotonic()
    for case in cases:
        outcome = run_case(case)
        if outcome.trouble:
            counts[WRONG] += 1
            say(f"{case.name}: {outcome.trouble}\n{outcome.message[-3000:]}")
        else:
            counts[REFUSED if outcome.status == REFUSED else READ] += 1
        if sum(counts.values()) % 500 == 0:
            say(f"{sum(counts.values())} cases, {time.monotonic() - begin:.0f} s")
    return counts[READ], counts[REFUSED], counts[WRONG]


def choose(seed: int, number: int) -> random.Random:
    """The source of chance of a case: of its seed and number alone."""
    return random.Random(f"{seed} {number}")
