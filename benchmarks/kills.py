"""Commands that are killed at random moments end, begun again, as if nothing had happened.

    python benchmarks/kills.py [KILLS] [SEED] [COMMAND ...]

So many kills (default 100) by SIGINT, SIGTERM and SIGKILL, spread over a validation, a study,
a whole bench, a challenge and a build with an empty cache; or over those that are named. A command
is killed at a random moment of its usual duration, alone or with its workers, begun again in the
same folder and killed again, up to five times, each time within what is left to do, then run to its
end. Status 1 where

- the folder, or what is beside it, has other files or bytes than after an undisturbed run;
- a command that was killed ends otherwise than by the signal or with status 130, or says more than
  its one line (a signal that comes before `hrg` is loaded is Python's own, and ends by itself);
- a worker outlives its command by a minute.

The usual duration is that of a second run: the first one fills the cache. A kill that came after
the command had ended isn't counted.
"""

import hashlib
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from tests import commands

COMMANDS = ("validate", "study", "bench all", "gap challenge", "build")
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGKILL)
IN_A_ROW = 5
"""Most kills of a command before it is run to its end."""
INTERRUPTED = 130
"""Status of `hrg` when it is interrupted."""
WORKERS_END_S = 60.0
"""Longest time that a worker may live without its command."""
START = 1 / 3
"""Share of a command's duration after which it goes on where it was killed. Chosen: it loads its
libraries until then."""


class Trial:
    """A command and the folder it writes to, which stands alone in a folder of its own."""

    def __init__(self, name: str, parent: Path) -> None:
        self.name = name
        self._place = Path(tempfile.mkdtemp(dir=parent))
        self._folder, self._errors = self._place / "work", self._place / "errors"
        self._out = self._folder / "out"
        self._groups: list[int] = []
        self._folder.mkdir()
        if name == "build":
            self._out.mkdir()

    def start(self) -> "subprocess.Popen[str]":
        """Start the command; a build has an empty cache."""
        environment = dict(os.environ)
        if self.name == "build":
            environment["XDG_CACHE_HOME"] = str(self._place / "cache")
        with self._errors.open("w") as errors:
            run = commands.start(
                self.name,
                *(self._out, self._folder),
                env=environment,
                stdout=subprocess.DEVNULL,
                stderr=errors,
            )
        self._groups.append(run.pid)
        return run

    def finish(self) -> dict[str, str]:
        """Run the command to its end; returns the digest of each file, by its path.

        Raises:
            AssertionError: it fails, or workers outlive a command.
        """
        status = self.start().wait()
        assert status == 0, self._describe_end(status)
        self._check_workers_end()
        files = sorted(path for path in self._folder.rglob("*") if path.is_file())
        return {
            str(path.relative_to(self._folder)): hashlib.sha256(path.read_bytes()).hexdigest()
            for path in files
        }

    def kill(self, sent: signal.Signals, moment: float, with_workers: bool) -> bool:
        """Whether the command was still running when it was killed, after so many seconds.

        Raises:
            AssertionError: it does not end as it should.
        """
        run = self.start()
        time.sleep(moment)
        if run.poll() is not None:
            assert run.returncode == 0, self._describe_end(run.returncode)
            return False
        (os.killpg if with_workers else os.kill)(run.pid, sent)
        status = run.wait()
        if status != 0:  # else it was ending
            self._check_end(status, sent)
        return status != 0

    def remove(self) -> None:
        shutil.rmtree(self._place)

    def _check_end(self, status: int, sent: signal.Signals) -> None:
        assert status in (-sent, INTERRUPTED), self._describe_end(status)
        if status == INTERRUPTED:
            assert "Traceback" not in self._errors.read_text(), self._describe_end(status)

    def _describe_end(self, status: int) -> str:
        return f"{self.name} ended with status {status}: {self._errors.read_text()[-3000:]}"

    def _check_workers_end(self) -> None:
        until = time.monotonic() + WORKERS_END_S
        for group in self._groups:
            while is_alive(group):
                assert time.monotonic() < until, f"{self.name}: workers outlive it"
                time.sleep(0.1)


def is_alive(group: int) -> bool:
    """Whether a process of a group is there."""
    try:
        os.killpg(group, 0)
    except ProcessLookupError:
        return False
    return True


def run_undisturbed(name: str, parent: Path) -> tuple[dict[str, str], float]:
    """Digests of what a command writes, and its duration with a warm cache, s."""
    for _ in range(2):
        trial = Trial(name, parent)
        begin = time.monotonic()
        expected = trial.finish()
        duration = time.monotonic() - begin
        trial.remove()
    return expected, duration


def kill_in_a_row(trial: Trial, most: int, duration: float, chance: random.Random) -> Counter[str]:
    """Kill a command that goes on in the same folder, until it ends or was killed so many times;
    returns the signals by which it was killed."""
    killed: Counter[str] = Counter()
    left = duration
    for _ in range(most):
        sent, moment = chance.choice(SIGNALS), chance.uniform(0, left)
        left = max(left - moment, START * duration)
        with_workers = chance.random() < 0.5
        shown = f"{trial.name} {sent.name}{' with workers' * with_workers} at {moment:.1f} s"
        if not trial.kill(sent, moment, with_workers):
            print(f"  {shown}: it had ended", flush=True)
            break
        print(f"  {shown}", flush=True)
        killed[sent.name] += 1
    return killed


def compare(expected: dict[str, str], found: dict[str, str]) -> str:
    """What differs between the files of two folders."""
    other = {path for path in expected | found if expected.get(path) != found.get(path)}
    return f"differs: {', '.join(sorted(other)[:9])}" if other else "same"


def main(kills: int, seed: int, names: list[str]) -> None:
    """Run and print."""
    chance, failures = random.Random(seed), 0
    killed, signals = dict.fromkeys(names, 0), Counter[str]()
    with tempfile.TemporaryDirectory() as folder_name:
        folder = Path(folder_name)
        usual = {name: run_undisturbed(name, folder) for name in names}
        print("; ".join(f"{n}: {usual[n][1]:.1f} s" for n in names), flush=True)
        while sum(killed.values()) < kills:
            name = min(names, key=lambda each: killed[each])
            expected, duration = usual[name]
            trial = Trial(name, folder)
            most = min(IN_A_ROW, kills - sum(killed.values()))
            try:
                sent = kill_in_a_row(trial, most, duration, chance)
                said = compare(expected, trial.finish())
            except AssertionError as error:
                sent, said = Counter({"trouble": 1}), str(error)
            failures += said != "same"
            killed[name] += sent.total()
            signals += sent
            print(f"{name}, {killed[name]} kills: {said}", flush=True)
            if said == "same":
                trial.remove()
    total = "; ".join(f"{name} {count}" for name, count in [*killed.items(), *signals.items()])
    print(f"seed {seed}: {total}; {failures} folders with another result")
    sys.exit(bool(failures))


if __name__ == "__main__":
    given = sys.argv[1:]
    numbers = [int(text) for text in given[:2]]
    main(*(*numbers, *(100, 1)[len(numbers) :]), names=given[2:] or list(COMMANDS))
