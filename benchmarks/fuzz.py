"""Millions of random calls against both shells and all models, under the sanitizers.

`python benchmarks/fuzz.py [CALLS] [SEED]`: so many calls for each FMI version of HRG (default
5 000 000), a fifth of them for HRGSlow and a hundredth for HRGCarrier, from that seed on (default
1), a new seed every million. Status 1 at the first finding, which it prints.
"""

import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from tests.fmu_build.c import native

BATCH = 1_000_000
RUNS = [(2, "HRG", 1), (3, "HRG", 1), (3, "HRGSlow", 5), (3, "HRGCarrier", 100)]


def main(calls: int, seed: int) -> None:
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


if __name__ == "__main__":
    numbers = [int(x) for x in sys.argv[1:]]
    main(*numbers, *[5_000_000, 1][len(numbers) :])
