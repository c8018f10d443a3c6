"""What 6 sigma of each effect is in its own unit, and what it is worth.

    python benchmarks/six_sigma.py FOLDER...

The folders are finished challenges. A line has an effect, the number of campaigns in which it was
found, and medians over these: the size that would have a strength of 6 sigma in that campaign, and
the mean rate that a cause of this size makes in the fitted test where that is largest. Both are
proportional to the strength. Noises are left out: their strength is not proportional to the level.
"""

import sys
from collections import defaultdict
from pathlib import Path
from statistics import median

import numpy as np

from pyhrg.challenge.roster import Folder
from pyhrg.challenge.run import read_finished
from pyhrg.challenge.scoring.named import list_answered
from pyhrg.challenge.truths.truth import DETECTION_SIGMAS
from pyhrg.device import device_file
from pyhrg.gap.effects.catalogue import DETERMINISTIC, EFFECTS
from pyhrg.gap.findings.diagnosis import Diagnosis


def measure_sizes(folder: Path) -> dict[str, list[tuple[float, float]]]:
    """Size, in the unit of the effect's parameter, and rate, deg/h, of 6 sigma by effect, of each
    campaign whose diagnosis names the effect."""
    challenge, sizes = Folder(folder), defaultdict(list)
    answered = list_answered(read_finished(challenge).cases)
    for case in (case for case in answered if case.truth.effects):
        truth = case.truth
        nominal = device_file.read(challenge.diagnosis(case.name) / "before.toml")
        for name, sigmas in zip(truth.effects, truth.strengths, strict=True):
            rate = find_rate(case.diagnosis, name)
            if name not in EFFECTS or rate is None:
                continue
            effect, share = EFFECTS[name], DETECTION_SIGMAS / sigmas
            totals = {key.name: truth.parameters[key.name] for key in effect.keys}
            away = effect.vector_of(totals) - effect.vector(nominal)
            size = effect.keys[0].from_si(float(np.linalg.norm(away)))
            sizes[name].append((share * size, share * rate))
    return sizes


def find_rate(diagnosis: Diagnosis, name: str) -> float | None:
    """Rate that an effect makes, deg/h; None where it is not named."""
    worths = [cause.worth for cause in diagnosis.causes if cause.effect == name]
    return worths[0].rate_deg_h if worths and worths[0] else None


def main(folders: list[str]) -> None:
    sizes = defaultdict(list)
    for folder in folders:
        for name, own in measure_sizes(Path(folder)).items():
            sizes[name] += own
    print("| effect | campaigns | parameter | 6 sigma | deg/h |\n|---|---|---|---|---|")
    for effect in DETERMINISTIC:
        if own := sizes[effect.name]:
            size, rate = (median(values) for values in zip(*own, strict=True))
            key = effect.keys[0].name
            print(f"| `{effect.name}` | {len(own)} | `{key}` | {size:.2g} | {rate:.2g} |")


if __name__ == "__main__":
    main(sys.argv[1:])
