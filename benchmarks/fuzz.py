"""Random attacks from outside, seeded. Status 1 where something is found, which is printed.

`python benchmarks/fuzz.py inputs [CASES] [SEED]`: so many spoilt inputs (default 10 000) of every
format, hostile paths and hostile values of options, each in a process of its own (seed default 1).
No traceback, no crash, at most 10 s of processor time and 1 GiB, nothing written.

`python benchmarks/fuzz.py calls [CALLS] [SEED]`: so many random calls under the sanitizers for each
FMI version of HRG (default 5 000 000), a fifth of them for HRGSlow and a hundredth for HRGCarrier,
from that seed on (default 1), a new seed every million; it ends at the first finding.
"""

import sys
import tempfile
from itertools import islice
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from tests.fmu_build.c import native
from tests.fuzzing.cases import make_cases
from tests.fuzzing.runner import find_troubles
from tests.fuzzing.samples import read_all

BATCH = 1_000_000
RUNS = [
    (f, root, share)
    for root, share in (("HRG", 1), ("HRGSlow", 5), ("HRGCarrier", 100))
    for f in (2, 3)
]


def fuzz_calls(calls: int = 5_000_000, seed: int = 1) -> None:
    """Run and print."""
    for fmi, root, share in RUNS:
        with tempfile.TemporaryDirectory() as name:
            fuzzer = native.fuzzer(Path(name), fmi, root)
            for first in range(0, calls // share, BATCH):
                part = [str(seed + first // BATCH), str(min(BATCH, calls // share - first))]
                try:
                    said = native.run([fuzzer, *part], seconds=3600)
                except AssertionError as finding:
                    sys.exit(f"{root}, FMI {fmi}, seed {part[0]}: {finding}")
                print(f"{root}, FMI {fmi}, seed {part[0]}: {said.strip()}", flush=True)


def fuzz_inputs(cases: int = 10_000, seed: int = 1) -> None:
    """Run and print."""
    read_all()
    read, refused, wrong = find_troubles(islice(make_cases(seed), cases), print)
    print(f"seed {seed}: {read} read, {refused} refused, {wrong} in trouble")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    subject, *numbers = sys.argv[1:]
    {"calls": fuzz_calls, "inputs": fuzz_inputs}[subject](*map(int, numbers))
