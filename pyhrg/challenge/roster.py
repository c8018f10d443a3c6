"""The cases of a challenge and its folder: published index, campaigns, sealed truths, diagnoses."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import cycle
from pathlib import Path

import numpy as np

from pyhrg.challenge.campaigns.laboratory import LEVELS
from pyhrg.challenge.campaigns.plans import AMOUNTS
from pyhrg.challenge.case import Case
from pyhrg.challenge.truths.seal import ChallengeError, encode_json
from pyhrg.challenge.truths.truth import DETECTION_SIGMAS, KINDS
from pyhrg.common.files import write_whole
from pyhrg.common.made_by import find_difference, list_versions
from pyhrg.common.reading.documents import read_json
from pyhrg.common.reading.files import read_bytes
from pyhrg.common.reading.limits import DOCUMENT_BYTES
from pyhrg.common.toml_table import read_json_table
from pyhrg.gap.effects.catalogue import EFFECT_NAMES

SCHEMA = "hrg-challenge/1"
MADE_BY = "made_by"
MAX_CASES = 1_000_000
"""Largest number of cases of a kind. Chosen."""
STRONGEST_SIGMAS = 10 * DETECTION_SIGMAS
"""Strength of the strongest effect, sigmas, where none is stated (chosen)."""
WEAK_STRENGTHS = (1.0, DETECTION_SIGMAS)
"""Range of the strengths of weak effects, sigmas (chosen)."""
STRENGTH_RANGE = 10.0
"""Strength of the strongest of several effects over that of one: real gyros have large and small
errors at once."""


@dataclass(frozen=True)
class Settings:
    """Settings that determine a challenge: number of cases by kind, seed, largest strength of
    effects (sigmas), level of realism (`LEVELS`) and amount of data (`AMOUNTS`)."""

    counts: Mapping[str, int]
    seed: int
    strongest: float = STRONGEST_SIGMAS
    level: str = "ideal"
    data: str = "full"

    def list_cases(self) -> list[Case]:
        """All cases. Neither name nor order reveals a case's kind."""
        kinds = [kind for kind in KINDS for _ in range(self.counts.get(kind, 0))]
        generator = np.random.default_rng(np.random.SeedSequence(self.seed, spawn_key=(0,)))
        order = generator.permutation(len(kinds)).tolist()
        seeds = np.random.SeedSequence(self.seed, spawn_key=(1,)).generate_state(len(kinds))
        effects = dict(zip((i for i in order if kinds[i] == "left_out"), cycle(EFFECT_NAMES)))
        return [
            Case(
                name=f"unit-{place:04d}",
                kind=kinds[i],
                seed=int(seed),
                strengths=self._get_strengths(kinds[i]),
                without=(effects[i],) if i in effects else (),
                level=self.level,
                data=self.data,
            )
            for place, (i, seed) in enumerate(zip(order, seeds.tolist(), strict=True), 1)
        ]

    def _get_strengths(self, kind: str) -> tuple[float, float]:
        if kind == "weak":
            return WEAK_STRENGTHS
        return DETECTION_SIGMAS, self.strongest * (STRENGTH_RANGE if kind == "several" else 1.0)


@dataclass(frozen=True)
class Folder:
    """A challenge's folder. Truths lie outside the campaigns; the index has their hashes."""

    root: Path

    @property
    def index(self) -> Path:
        """File that is published before anything is diagnosed."""
        return self.root / "challenge.json"

    @property
    def score(self) -> Path:
        """File of the figures."""
        return self.root / "score.json"

    @property
    def settings(self) -> Path:
        """File of the settings that the folder was begun with, and of the code."""
        return self.root / "settings.json"

    def campaign(self, name: str) -> Path:
        """Folder of a case's campaign: all that its diagnosis sees."""
        return self.root / "campaigns" / name

    def truth(self, name: str) -> Path:
        """File of a case's sealed truth."""
        return self.root / "truths" / f"{name}.json"

    def diagnosis(self, name: str) -> Path:
        """Folder of a case's diagnosis."""
        return self.root / "diagnoses" / name

    @property
    def next(self) -> "Folder":
        """Folder of the campaigns with the suggested next test, and of their diagnoses."""
        return Folder(self.root / "next")

    def begin(self, settings: Settings) -> None:
        """Begin a challenge, or continue the same one; a folder that another challenge or other
        code has begun is refused."""
        for folder in (self.root / "campaigns", self.root / "truths", self.root / "diagnoses"):
            folder.mkdir(parents=True, exist_ok=True)
        asked = {"seed": settings.seed, "counts": dict(settings.counts), "to": settings.strongest}
        asked |= {"level": settings.level, "data": settings.data}
        text = encode_json({**asked, MADE_BY: list_versions()})
        if self.settings.exists() and read_bytes(self.settings, DOCUMENT_BYTES) != text:
            begun = read_json(self.settings)
            if differs := find_difference(begun.pop(MADE_BY, None), list_versions()):
                key, was, now = differs
                raise ChallengeError(
                    f"{self.settings}: begun by another version: {key}: found {was}, expected "
                    f"{now}; results of two versions are not mixed: take an empty folder"
                )
            raise ChallengeError(
                f"{self.settings}: another challenge was begun here: found {begun}, "
                f"expected {asked}, or an empty folder"
            )
        write_whole(self.settings, text)

    def read_settings(self) -> Settings:
        """The settings that the folder was begun with."""
        table = read_json_table(self.settings)
        counts = table.table("counts")
        return Settings(
            {kind: counts.whole_number(kind, None, 0, MAX_CASES) for kind in counts.values},
            table.whole_number("seed", None, 0, 2**63 - 1),
            table.number("to", None, DETECTION_SIGMAS, math.inf),
            table.text("level", None, tuple(LEVELS)),
            table.text("data", None, AMOUNTS),
        )

    def read_hashes(self) -> dict[str, str]:
        """The published hash of each truth, by case."""
        index = read_json_table(self.index)
        if "cases" not in index.values:
            raise index.error("cases", None, "the cases of a challenge")
        cases = index.tables("cases")
        return {case.text("name", None): case.text("sha256", None) for case in cases}

    def publish(self, cases: Sequence[Case], hashes: Sequence[str]) -> None:
        """Write the index; refuse truths that are not those of an index that exists."""
        listed = [
            {"name": case.name, "sha256": digest, "without": list(case.without)}
            for case, digest in zip(cases, hashes, strict=True)
        ]
        text = encode_json({"schema": SCHEMA, "cases": listed})
        if self.index.exists() and read_bytes(self.index, DOCUMENT_BYTES) != text:
            raise ChallengeError(f"{self.index}: truths are not those that it has published")
        write_whole(self.index, text)
