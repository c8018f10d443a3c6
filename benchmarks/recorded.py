"""Diagnoses of recorded campaigns, beside their truth.

    python benchmarks/recorded.py [--without] FOLDER...

Each folder holds a campaign and its `truth.json`. A block has the processor time, the verdict, the
causes and terms that were named, the residual of the held-out tests, and the truth. With
`--without`, the true effects are taken out of the catalogue: how does a diagnosis end where what is
there has no name?
"""

import json
import sys
import time
from pathlib import Path

from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.effects.catalogue import FULL_CATALOGUE
from pyhrg.gap.replay.simulation import load_simulation


def main(folders: list[Path], is_without: bool) -> None:
    simulation = load_simulation()
    for folder in folders:
        truth = json.loads((folder / "truth.json").read_text())
        catalogue = FULL_CATALOGUE.without(truth["effects"] if is_without else ())
        begin = time.process_time()
        found = diagnose(folder, catalogue=catalogue, simulation=simulation).diagnosis
        seconds = time.process_time() - begin
        causes = ", ".join(cause.effect for cause in found.causes) or "-"
        terms = ", ".join(f"{term.place} {term.function}" for term in found.terms) or "-"
        settled = "" if found.settled else ", not settled"
        print(f"{folder.name}: {found.verdict}{settled}, {seconds:.1f} s")
        print(f"    causes  {causes}\n    terms   {terms}")
        if gap := found.gap.holdout_angle_arcsec:
            print(f"    held-out tests {gap.before:.3g} -> {gap.after:.3g} arcsec")
        print(f"    truth   {', '.join(truth['effects']) or '-'}; {truth.get('what', '')}")
        sys.stdout.flush()


if __name__ == "__main__":
    arguments = sys.argv[1:]
    main([Path(each) for each in arguments if each != "--without"], "--without" in arguments)
