"""Runs a challenge: simulate, publish hashes, diagnose, add next tests, score."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, partial
from pathlib import Path

from pyhrg.challenge.campaigns.laboratory import LEVELS
from pyhrg.challenge.campaigns.plans import AMOUNTS
from pyhrg.challenge.case import Case, Fmus, add_next_test, generate_case
from pyhrg.challenge.roster import MAX_CASES, STRONGEST_SIGMAS, Folder, Settings
from pyhrg.challenge.scoring.named import AnyCase, RefusedCase, ScoredCase
from pyhrg.challenge.scoring.report import Finished, Score, write
from pyhrg.challenge.truths.seal import (
    ChallengeError,
    encode_json,
    hash_truth,
    open_truth,
    seal_truth,
)
from pyhrg.challenge.truths.truth import DETECTION_SIGMAS
from pyhrg.challenge.work import share_work
from pyhrg.common.arguments import check_seed, check_whole_number, choose_workers
from pyhrg.common.errors import HrgError
from pyhrg.common.extras import require_extra
from pyhrg.common.files import replace_folder, write_whole
from pyhrg.common.toml_table import read_json_table
from pyhrg.fmu import GyroError
from pyhrg.gap.diagnose import diagnose as diagnose_campaign
from pyhrg.gap.effects.catalogue import FULL_CATALOGUE
from pyhrg.gap.findings.diagnosis import FILE
from pyhrg.gap.findings.diagnosis_reader import read_diagnosis
from pyhrg.gap.replay.simulation import Simulation, load_model, load_simulation
from pyhrg.records import campaign as campaigns

LARGEST_STRENGTH_SIGMAS = 1e6
"""Largest strength that can be asked for. Chosen: far beyond it effects leave the ranges of their
parameters."""
STRENGTHS = f"above {DETECTION_SIGMAS:g}, up to {LARGEST_STRENGTH_SIGMAS:g}"
REFUSAL = "refusal.json"
"""In the place of a diagnosis: the sentence with which the campaign was refused."""
Diagnose = Callable[[Path, Path, Sequence[str]], None]
"""Diagnoses the campaign of a folder into `diagnosis.json` of another, its catalogue without the
effects of these names; importable by name, for other processes."""


@dataclass(frozen=True)
class Challenge:
    """One challenge: its folder, its settings, the diagnosis under challenge, and whether a bar is
    shown on standard error."""

    folder: Folder
    settings: Settings
    diagnose: Diagnose
    progress: bool = False

    def run(self, workers: int, others: Sequence[Folder] = ()) -> Score:
        """Do the remaining work and score it, together with others that are finished; the same
        bytes on any number of workers."""
        require_extra("build")
        known = self._read_others(others)
        cases = self.settings.list_cases()
        self.folder.begin(self.settings)
        with share_work(workers, self.progress, _load_fmus) as share:
            hashes = share("generated", partial(_generate, self), cases)
            self.folder.publish(cases, hashes)
            share("diagnosed", partial(_diagnose, self), cases)
            asked = [case for case in cases if self._is_to_be_settled(case)]
            share("tested again", partial(_diagnose_next, self), asked)
        score = Score([read_finished(self.folder), *known])
        write(score, self.folder.score)
        return score

    def _read_others(self, folders: Sequence[Folder]) -> list[Finished]:
        others = [read_finished(folder) for folder in folders]
        seeds = {self.settings.seed}
        for folder, other in zip(folders, others, strict=True):
            if other.settings.seed in seeds:
                raise ChallengeError(f"{folder.root}: seed {other.settings.seed} is scored already")
            seeds.add(other.settings.seed)
        return others

    def _is_to_be_settled(self, case: Case) -> bool:
        """Whether a next test is proposed for one or two effects of the catalogue."""
        out = self.folder.diagnosis(case.name)
        if case.kind not in ("single", "pair") or not (out / FILE).exists():
            return False
        return read_diagnosis(out).next_test is not None


def run_challenge(
    out: Path | str,
    *,
    none: int = 300,
    single: int = 150,
    pairs: int = 150,
    outside: int = 150,
    weak: int = 0,
    several: int = 0,
    left_out: int = 0,
    strongest: float = STRONGEST_SIGMAS,
    level: str = "ideal",
    data: str = "full",
    seed: int = 1,
    others: Sequence[Path | str] = (),
    workers: int | None = None,
    progress: bool = False,
    diagnose: Diagnose | None = None,
) -> Score:
    """Score the diagnosis on campaigns whose truth is sealed (docs/methods/challenge.md).

    Args:
        out: folder; a challenge that was begun there is continued.
        none: number of campaigns without a gap.
        single: number with one effect of the catalogue.
        pairs: number with two effects.
        outside: number with an effect that the catalogue lacks.
        weak: number with one effect of 1 to 6 sigma.
        several: number with three to eight effects, up to ten times as strong.
        left_out: number with an effect that is removed from the catalogue, each in turn.
        strongest: strengths are drawn from 6 sigma up to this, 1e6 at most.
        level: "ideal", "good-lab" (nominal values and bench are off within their tolerances) or
            "rough-lab" (within three times that).
        data: "full", "few" (one or two kinds of tests), "short" (a tenth as long) or "coarse".
        seed: seed of all random numbers; the same seed gives the same bytes.
        others: folders of finished challenges of other seeds, scored together with this one.
        workers: number of campaigns that are diagnosed at the same time; all cores if None.
        progress: True shows a bar on standard error.
        diagnose: diagnosis under challenge; this package's own if None.

    Raises:
        HrgError: an argument out of range, a folder of another challenge, or a diagnosis or truth
            that can't be used.
        OSError: the folder can't be written.
    """
    counts = {"none": none, "single": single, "pair": pairs, "outside": outside}
    counts |= {"weak": weak, "several": several, "left_out": left_out}
    for name, count in counts.items():
        check_whole_number("pairs" if name == "pair" else name, count, 0, MAX_CASES)
    if not DETECTION_SIGMAS < strongest <= LARGEST_STRENGTH_SIGMAS:
        raise HrgError(f"strongest: found {strongest:g}, expected {STRENGTHS}")
    for name, choice, choices in (("level", level, LEVELS), ("data", data, AMOUNTS)):
        if choice not in choices:
            raise HrgError(f"{name}: found {choice!r}, expected {', '.join(choices)}")
    settings = Settings(counts, check_seed(seed), strongest, level, data)
    challenge = Challenge(Folder(Path(out)), settings, diagnose or diagnose_folder, progress)
    try:
        return challenge.run(choose_workers(workers), [Folder(Path(other)) for other in others])
    except KeyboardInterrupt:
        raise KeyboardInterrupt("interrupted; the same command goes on from here") from None


def diagnose_folder(campaign: Path, out: Path, without: Sequence[str]) -> None:
    """Write the diagnosis of a campaign's folder into a folder that exists, the effects of these
    names removed from the catalogue."""
    catalogue, simulation = FULL_CATALOGUE.without(without), _load_simulation_once()
    diagnose_campaign(campaign, catalogue=catalogue, simulation=simulation).write_files(out)


@cache
def _load_simulation_once() -> Simulation:
    return load_simulation()


def read_finished(folder: Folder) -> Finished:
    """A finished challenge, read from its folder; its truths are checked by their hashes."""
    settings, published = folder.read_settings(), folder.read_hashes()
    cases = [
        _read_case(folder, case.name, published.get(case.name, "nothing"))
        for case in settings.list_cases()
    ]
    return Finished(settings, cases)


def _read_case(folder: Folder, name: str, published: str) -> AnyCase:
    """A case's truth, checked by its published hash, with its diagnosis or the refusal."""
    truth, out = open_truth(folder.truth(name), published), folder.diagnosis(name)
    if (out / REFUSAL).exists():
        refusal = read_json_table(out / REFUSAL).text("refused", None)
        return RefusedCase(name, truth, refusal)
    again = folder.next.diagnosis(name)
    then = read_diagnosis(again) if (again / FILE).exists() else None
    return ScoredCase(name, truth, read_diagnosis(out), then)


def _generate(challenge: Challenge, case: Case) -> str:
    """Simulate a case and seal its truth unless its files exist; return the truth's hash."""
    truth, campaign = challenge.folder.truth(case.name), challenge.folder.campaign(case.name)
    if truth.exists() and (campaign / campaigns.INDEX).exists():
        return hash_truth(truth)
    try:
        made, answer = generate_case(case, _load_fmus())
    except (ValueError, GyroError) as error:
        raise ChallengeError(f"{case.name}: {error}") from error
    with replace_folder(campaign) as aside:
        campaigns.write_campaign(made, aside)
    return seal_truth(answer, truth)


def _diagnose(challenge: Challenge, case: Case) -> None:
    folder, name = challenge.folder, case.name
    _diagnose_once(challenge, case, folder.campaign(name), folder.diagnosis(name))


def _diagnose_next(challenge: Challenge, case: Case) -> None:
    """Simulate the proposed next test and diagnose the extended campaign."""
    folder = challenge.folder
    extended = folder.next.campaign(case.name)
    test = read_diagnosis(folder.diagnosis(case.name)).next_test
    assert test is not None, "only cases with a next test are tested again"
    if not (extended / campaigns.INDEX).exists():
        before = campaigns.read_campaign(folder.campaign(case.name))
        try:
            made = add_next_test(case, before, test.kind, test.hours, _load_fmus())
        except (ValueError, GyroError) as error:
            raise ChallengeError(f"{case.name}: next_test: {error}") from error
        with replace_folder(extended) as aside:
            campaigns.write_campaign(made, aside)
    _diagnose_once(challenge, case, extended, folder.next.diagnosis(case.name))


def _diagnose_once(challenge: Challenge, case: Case, campaign: Path, out: Path) -> None:
    """Diagnose a campaign unless its diagnosis, or the sentence that refused it, exists."""
    if (out / FILE).exists() or (out / REFUSAL).exists():
        return
    with replace_folder(out) as aside:
        try:
            challenge.diagnose(campaign, aside, case.without)
        except HrgError as error:
            write_whole(aside / REFUSAL, encode_json({"refused": str(error)}))
        else:
            if not (aside / FILE).exists():
                raise ChallengeError(f"{campaign}: the diagnosis has written no {FILE}")


@cache
def _load_fmus() -> Fmus:
    """The models, loaded once in each process."""
    return Fmus(load_model("HRGCarrier"), _load_simulation_once())
