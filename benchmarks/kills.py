"""Commands that are killed at random moments end, begun again, as if nothing had happened.

    python benchmarks/kills.py [KILLS] [SEED] [COMMAND ...]

So many kills (default 100) by SIGINT, SIGTERM and SIGKILL, spread over a validation, a study,
a whole bench, a challenge and a build with an empty cache; or over those that are named. A command
is killed at a random moment of its usual duration, begun again in the same folder and killed again,
up to five times, then run to its end. The folder's files must have the bytes of an undisturbed run,
with nothing beside them. Status 1 where they differ.

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
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from tests import commands

COMMANDS = ("validate", "study", "bench all", "gap challenge", "build")
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGKILL)
IN_A_ROW = 5
"""Most kills of a command before it is run to its end."""


def start(name: str, out: Path) -> "subprocess.Popen[str]":
    """A command without output; a build has an empty cache."""
    environment = dict(os.environ)
    if name == "build":
        out.mkdir(exist_ok=True)
        environment["XDG_CACHE_HOME"] = str(out.parent / f"cache-{out.name}")
    nowhere = subprocess.DEVNULL
    return commands.start(name, out, out.parent, env=environment, stdout=nowhere, stderr=nowhere)


def clear(out: Path) -> None:
    """Remove a command's output folder, and its cache where it has one of its own."""
    shutil.rmtree(out, ignore_errors=True)
    shutil.rmtree(out.parent / f"cache-{out.name}", ignore_errors=True)


def digest_files(out: Path) -> dict[str, str]:
    """SHA-256 of every file in a folder."""
    files = sorted(path for path in out.rglob("*") if path.is_file())
    return {str(p.relative_to(out)): hashlib.sha256(p.read_bytes()).hexdigest() for p in files}


def run_undisturbed(name: str, folder: Path) -> tuple[dict[str, str], float]:
    """Digests of what a command writes, and its duration with a warm cache, s."""
    for number in range(2):
        out = folder / f"{name}-whole-{number}"
        begin = time.monotonic()
        assert start(name, out).wait() == 0, name
        duration, expected = time.monotonic() - begin, digest_files(out)
        clear(out)
    return expected, duration


def kill_once(name: str, out: Path, sent: signal.Signals, moment: float) -> bool:
    """Whether a command was still running when it was killed, after so many seconds."""
    run = start(name, out)
    time.sleep(moment)
    run.send_signal(sent)  # to a command that has ended: nothing
    return run.wait() != 0


def kill_in_a_row(name: str, out: Path, most: int, duration: float, chance: random.Random) -> int:
    """Kill a command that goes on in the same folder, until it ends or was killed so many times;
    returns how many times it was killed."""
    for number in range(most):
        sent, moment = chance.choice(SIGNALS), chance.uniform(0, duration)
        if not kill_once(name, out, sent, moment):
            print(f"  {name} had ended by {moment:.1f} s", flush=True)
            return number
        print(f"  {name} {sent.name} at {moment:.1f} s", flush=True)
    return most


def main(kills: int, seed: int, names: list[str]) -> None:
    """Run and print."""
    chance, failures = random.Random(seed), 0
    killed = dict.fromkeys(names, 0)
    with tempfile.TemporaryDirectory() as folder_name:
        folder = Path(folder_name)
        usual = {name: run_undisturbed(name, folder) for name in names}
        print("; ".join(f"{n}: {usual[n][1]:.1f} s" for n in names), flush=True)
        while sum(killed.values()) < kills:
            name = min(names, key=lambda each: killed[each])
            expected, duration = usual[name]
            out = folder / f"{name}-{killed[name]}"
            most = min(IN_A_ROW, kills - sum(killed.values()))
            killed[name] += kill_in_a_row(name, out, most, duration, chance)
            status = start(name, out).wait()
            same = status == 0 and digest_files(out) == expected
            failures += not same
            said = "same" if same else f"differs (status {status})"
            print(f"{name}, {killed[name]} kills: {said}", flush=True)
            clear(out)
    total = "; ".join(f"{name} {count}" for name, count in killed.items())
    print(f"seed {seed}: {total} kills; {failures} folders with another result")
    sys.exit(bool(failures))


if __name__ == "__main__":
    given = sys.argv[1:]
    numbers = [int(text) for text in given[:2]]
    main(*(*numbers, *(100, 1)[len(numbers) :]), names=given[2:] or list(COMMANDS))
