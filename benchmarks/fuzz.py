"""Random attacks from outside, seeded. Status 1 where something is found, which is printed.

`python benchmarks/fuzz.py inputs [CASES] [SEED]`: so many spoilt inputs (default 10 000) of every
format, hostile paths and hostile values of options, each in a process of its own (seed default 1).
No traceback, no crash, at most 10 s of processor time and 1 GiB, nothing written.

`python benchmarks/fuzz.py calls [CALLS] [SEED] [MODEL]`: so many random calls under the sanitizers
for each FMI version of HRG (default 5 000 000), a fifth of them for HRGSlow and a hundredth for
HRGCarrier, or all of them for the model that is named; from that seed on (default 1), a new seed
every million; it ends at the first finding.
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
SHARES = {"HRG": 1, "HRGSlow": 5, "HRGCarrier": 100}
"""The part of the calls that each model gets is one in so many: the more of them, the slower."""


def fuzz_calls(calls: str = "5_000_000", seed: str = "1", model: str = "") -> None:
    """Run and print."""
    for root, share in {model: 1}.items() if model else SHARES.items():
        for fmi in (2, 3):
            fuzz_model(root, fmi, int(calls) // share, int(seed))


def fuzz_model(root: str, fmi: int, calls: int, seed: int) -> None:
    with tempfile.TemporaryDirectory() as name:
        fuzzer = native.fuzzer(Path(name), fmi, root, "-O1")
        for first in range(0, calls, BATCH):
            part = [str(seed + first // BATCH), str(min(BATCH, calls - first))]
            try:
                said = native.run([fuzzer, *part], seconds=3600)
            except AssertionError as finding:
                sys.exit(f"{root}, FMI {fmi}, seed {part[0]}: {finding}")
            print(f"{root}, FMI {fmi}, seed {part[0]}: {said.strip()}", flush=True)


def fuzz_inputs(cases: str = "10_000", seed: str = "1") -> None:
    """Run and print."""
    read_all()
    read, refused, wrong = find_troubles(islice(make_cases(int(seed)), int(cases)), print)
    print(f"seed {seed}: {read} read, {refused} refused, {wrong} in trouble")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    subject, *arguments = sys.argv[1:]
    {"calls": fuzz_calls, "inputs": fuzz_inputs}[subject](*arguments)
