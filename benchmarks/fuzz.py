"""Millions of random calls against both shells, under the sanitizers.

`python benchmarks/fuzz.py [CALLS] [SEED]`: so many calls for each FMI version (default 5 000 000)
from that seed on (default 1), a new seed every million. Status 1 at the first finding, which it
prints.
"""

import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from tests.fmu_build import native

BATCH = 1_000_000


def main(calls: int, seed: int) -> None:
    """Run and print."""
    for fmi in (2, 3):
        with tempfile.TemporaryDirectory() as name:
            fuzzer = native.fuzzer(Path(name), fmi)
            for first in range(0, calls, BATCH):
                part = [str(seed + first // BATCH), str(min(BATCH, calls - first))]
                try:
                    said = native.run([fuzzer, *part], seconds=3600)
                except AssertionError as finding:
                    sys.exit(f"FMI {fmi}, seed {part[0]}: {finding}")
                print(f"FMI {fmi}, seed {part[0]}: {said.strip()}", flush=True)


if __name__ == "__main__":
    numbers = [int(x) for x in sys.argv[1:]]
    main(*numbers, *[5_000_000, 1][len(numbers) :])
