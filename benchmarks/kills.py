"""Commands that are killed at random moments end, begun again, as if nothing had happened.

    python benchmarks/kills.py [KILLS] [SEED]

So many kills (default 100) by SIGINT, SIGTERM and SIGKILL, over a bench run, a challenge and a
build with an empty cache; tests/ins_eval/study/run kills studies. A command is killed at a random
moment of its usual duration, then run to its end in the same folder, whose files must have the
bytes of an undisturbed run. Status 1 where they differ.
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

HRG = [sys.executable, "-c", "import sys; from pyhrg.common.cli import main; sys.exit(main())"]
COMMANDS = {
    "bench": "bench amplitude-sweep --seed 1 --out {out}",
    "challenge": "gap challenge --none 0 --single 1 --pairs 0 --outside 0 --data short --seed 1"
    " --workers 1 --out {out}",
    "build": "build --out {out}/HRG.fmu",
}
"""What is killed; {out} is the output folder."""
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGKILL)


def start(name: str, out: Path) -> subprocess.Popen[bytes]:
    """A command in a session of its own; a build has an empty cache."""
    environment = dict(os.environ)
    if name == "build":
        out.mkdir(exist_ok=True)
        environment["XDG_CACHE_HOME"] = str(out.parent / f"cache-{out.name}")
    return subprocess.Popen(
        [*HRG, *COMMANDS[name].format(out=out).split()],
        env=environment,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )


def digest_files(out: Path) -> dict[str, str]:
    """SHA-256 of every file in a folder."""
    files = sorted(path for path in out.rglob("*") if path.is_file())
    return {str(p.relative_to(out)): hashlib.sha256(p.read_bytes()).hexdigest() for p in files}


def main(kills: int = 100, seed: int = 1) -> None:
    """Run and print."""
    chance, failures = random.Random(seed), 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        expected, durations = {}, {}
        for command in COMMANDS:
            begin = time.monotonic()
            assert start(command, folder / command).wait() == 0, command
            durations[command] = time.monotonic() - begin
            expected[command] = digest_files(folder / command)
        for number in range(kills):
            command, sent = chance.choice(list(COMMANDS)), chance.choice(SIGNALS)
            out = folder / f"{command}-{number}"
            run = start(command, out)
            time.sleep(chance.uniform(0, durations[command]))
            run.send_signal(sent)
            run.wait()
            status = start(command, out).wait()
            same = status == 0 and digest_files(out) == expected[command]
            failures += not same
            print(f"{number} {command} {sent.name}: {'same' if same else f'differs ({status})'}",
                  flush=True)  # fmt: skip
            shutil.rmtree(out, ignore_errors=True)
            shutil.rmtree(folder / f"cache-{out.name}", ignore_errors=True)
    print(f"seed {seed}: {kills} kills, {failures} with another result")
    sys.exit(bool(failures))


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
