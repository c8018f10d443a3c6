"""Diagnoses of recorded campaigns, beside their truth.

    python benchmarks/recorded.py FOLDER...

Each folder holds a campaign and its `truth.json`. A block has the processor time, the verdict, the
causes and terms that were named, and the truth.
"""

import json
import sys
import time
from pathlib import Path

from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.replay.simulation import load_simulation


def main(folders: list[Path]) -> None:
    simulation = load_simulation()
    for folder in folders:
        truth = json.loads((folder / "truth.json").read_text())
        begin = time.process_time()
        found = diagnose(folder, simulation=simulation).diagnosis
        seconds = time.process_time() - begin
        causes = ", ".join(cause.effect for cause in found.causes) or "-"
        terms = ", ".join(f"{term.place} {term.function}" for term in found.terms) or "-"
        print(f"{folder.name}: {found.verdict}, {seconds:.1f} s")
        print(f"    causes  {causes}\n    terms   {terms}")
        print(f"    truth   {', '.join(truth['effects']) or '-'}; {truth.get('what', '')}")
        sys.stdout.flush()


if __name__ == "__main__":
    main([Path(each) for each in sys.argv[1:]])
