"""What is said of parts of recorded campaigns: a few of their tests, or the beginning of each.

    python benchmarks/parts.py FOLDER...

The folders are campaigns with their truth. Each is diagnosed from each part of its tests, beside
the whole held-out ones, and has a line for each. Then come, by part, the campaigns without an
effect that are no gap or explained by nominal values and bench; the effects of all others, how many
of them are named, how many are in the class of another, and how many names are false.
"""

import json
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from tqdm import tqdm

from pyhrg import Campaign, diagnose, read_campaign
from pyhrg.gap.findings.diagnosis import Diagnosis
from pyhrg.gap.replay.simulation import load_simulation
from pyhrg.records.campaign import Test

SHARE, MIN_ROWS = 0.1, 60
"""Of a test that makes its beginning."""


def keep(*kinds: str) -> Callable[[Test], Test | None]:
    """Tests of these kinds alone."""
    return lambda test: test if test.kind in kinds else None


def begin(test: Test) -> Test:
    """The first tenth of a test, or its first rows."""
    rows = max(int(SHARE * len(test.log.time)), MIN_ROWS)
    return replace(test, recording=test.log.section(slice(rows)))


PARTS: dict[str, Callable[[Test], Test | None]] = {
    "rest": keep("static"),
    "rest, positions": keep("static", "positions"),
    "positions, thermal": keep("positions", "thermal"),
    "rates": keep("rate"),
    "thermal": keep("thermal"),
    "ring-down, amplitude": keep("ring_down", "amplitude"),
    "tumble, phase": keep("tumble", "phase_step"),
    "a tenth of each": begin,
}


def take_part(campaign: Campaign, choose: Callable[[Test], Test | None]) -> Campaign:
    """A campaign with part of its tests, and the held-out ones."""
    chosen = (test if test.is_holdout else choose(test) for test in campaign.tests)
    return replace(campaign, tests=tuple(test for test in chosen if test))


class Count:
    """What was said of one part of all campaigns."""

    def __init__(self) -> None:
        self.clean = self.silent = self.effects = self.named = self.held = self.false = 0

    def add(self, truth: set[str], said: Diagnosis) -> None:
        """Count a diagnosis."""
        causes = [cause for cause in said.causes if cause.family == "gyro"]
        names = {cause.effect for cause in causes}
        held = {effect for cause in causes for effect in cause.equivalents}
        self.clean += not truth
        self.silent += not (truth or names or said.verdict == "unexplained")
        self.effects += len(truth)
        self.named += len(truth & names)
        self.held += len(truth & held - names)
        self.false += sum(not cause.equivalence_class & truth for cause in causes)


def main(folders: list[str]) -> None:
    simulation = load_simulation()
    counts = {name: Count() for name in PARTS}
    for folder in tqdm(folders):
        campaign = read_campaign(folder)
        truth = set(json.loads((Path(folder) / "truth.json").read_text())["effects"])
        for name, choose in PARTS.items():
            said = diagnose(take_part(campaign, choose), simulation=simulation).diagnosis
            counts[name].add(truth, said)
            causes = [f"{c.effect} {c.probability:.2f} {list(c.equivalents)}" for c in said.causes]
            terms = [term.function for term in said.terms]
            print(Path(folder).name, name, sorted(truth), said.verdict, causes, terms, flush=True)
    print("| part | no effect, none said | effects | named | in a class | false names |")
    print("|---|---|---|---|---|---|")
    for name, count in counts.items():
        print(f"| {name} | {count.silent}/{count.clean} | {count.effects} | {count.named} "
              f"| {count.held} | {count.false} |")  # fmt: skip


if __name__ == "__main__":
    main(sys.argv[1:])
