"""A challenge from its settings to its score: generate, publish, diagnose, test again, score."""

import multiprocessing
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache, partial
from pathlib import Path
from typing import TypeVar

from tqdm import tqdm

from pyhrg.challenge.case import Case, Fmus, generated, with_next_test
from pyhrg.challenge.roster import ChallengeError, Folder, Settings
from pyhrg.challenge.scoring import diagnosis
from pyhrg.challenge.scoring.diagnosis import Diagnosis
from pyhrg.challenge.scoring.report import Finished, Score, write
from pyhrg.challenge.scoring.score import Judged
from pyhrg.challenge.truths import seal
from pyhrg.common.files import replaced_folder
from pyhrg.fmu import GyroError
from pyhrg.gap.replay.models import model, simulation
from pyhrg.records import campaign as campaigns
from pyhrg.records.campaign_index import CampaignError

Diagnose = Callable[[Path, Path, Sequence[str]], None]
"""Diagnoses the campaign of a folder into `diagnosis.json` of another, its catalogue without the
effects of these names; importable by name, for other processes."""
Result = TypeVar("Result")
Work = Callable[[Case], Result]


@dataclass(frozen=True)
class Challenge:
    """One challenge."""

    folder: Folder
    settings: Settings
    diagnose: Diagnose

    def run(self, workers: int, others: Sequence[Folder] = ()) -> Score:
        """Do what is not done yet, and score; the same bytes on any number of workers.

        Args:
            workers: processes.
            others: challenges that are finished, to be scored together with this one.

        Raises:
            ChallengeError: the folder is another challenge's or other code's, a truth or a
                diagnosis can't be used, a worker was killed, or another challenge is not finished
                or has a seed that is there already.
            OSError: it can't be written.
        """
        known = self._others(others)
        cases = self.settings.cases()
        self.folder.begin(self.settings)
        with _shared(workers) as share:
            hashes = share("generated", partial(_generate, self), cases)
            self.folder.publish(cases, list(hashes))
            list(share("diagnosed", partial(_diagnose, self), cases))
            asked = [case for case in cases if self._is_to_be_settled(case)]
            list(share("tested again", partial(_diagnose_next, self), asked))
        score = Score([finished(self.folder), *known])
        write(score, self.folder.score)
        return score

    def _others(self, folders: Sequence[Folder]) -> list[Finished]:
        others = [finished(folder) for folder in folders]
        seeds = {self.settings.seed}
        for folder, other in zip(folders, others, strict=True):
            if other.settings.seed in seeds:
                raise ChallengeError(f"{folder.root}: seed {other.settings.seed} is scored already")
            seeds.add(other.settings.seed)
        return others

    def _is_to_be_settled(self, case: Case) -> bool:
        """Whether something is confounded, and a test is suggested that can be made here."""
        said = _said(self.folder.diagnosis(case.name))
        return case.kind in ("single", "pair") and said.next_test is not None


def finished(folder: Folder) -> Finished:
    """A challenge all of whose cases are diagnosed.

    Raises:
        ChallengeError: it isn't, or a truth is not the one that was published.
    """
    settings, published = folder.begun(), folder.published()
    names = [case.name for case in settings.cases()]
    cases = [_judged(folder, name, published.get(name, "nothing")) for name in names]
    return Finished(settings, cases)


def _judged(folder: Folder, name: str, published: str) -> Judged:
    try:
        truth = seal.opened(folder.truth(name), published)
    except seal.SealError as error:
        raise ChallengeError(str(error)) from error
    again = folder.next_diagnosis(name)
    then = _said(again) if (again / diagnosis.FILE).exists() else None
    return Judged(name, truth, _said(folder.diagnosis(name)), then)


def _said(folder: Path) -> Diagnosis:
    """What a diagnosis says.

    Raises:
        ChallengeError: it can't be used.
    """
    try:
        return diagnosis.read(folder / diagnosis.FILE)
    except CampaignError as error:
        raise ChallengeError(str(error)) from error


def _generate(challenge: Challenge, case: Case) -> str:
    """Make a case's campaign and seal its truth, unless that is done; its hash."""
    truth, campaign = challenge.folder.truth(case.name), challenge.folder.campaign(case.name)
    if truth.exists() and (campaign / campaigns.INDEX).exists():
        try:
            return seal.hash_of(truth)
        except seal.SealError as error:
            raise ChallengeError(str(error)) from error
    try:
        made, answer = generated(case, _fmus())
    except (ValueError, GyroError) as error:
        raise ChallengeError(f"{case.name}: {error}") from error
    with replaced_folder(campaign) as aside:
        campaigns.write(made, aside)
    return seal.sealed(answer, truth)


def _diagnose(challenge: Challenge, case: Case) -> None:
    folder = challenge.folder
    _said_of(challenge, case, folder.campaign(case.name), folder.diagnosis(case.name))


def _diagnose_next(challenge: Challenge, case: Case) -> None:
    """Make the test that was suggested, and diagnose again."""
    folder = challenge.folder
    said = _said(folder.diagnosis(case.name))
    kind, hours = str(said.next_test), said.next_hours
    extended = folder.next_campaign(case.name)
    if not (extended / campaigns.INDEX).exists():
        before = campaigns.read(folder.campaign(case.name))
        try:
            made = with_next_test(case, before, kind, hours, _fmus())
        except (ValueError, GyroError) as error:
            raise ChallengeError(f"{case.name}: next_test: {error}") from error
        with replaced_folder(extended) as aside:
            campaigns.write(made, aside)
    _said_of(challenge, case, extended, folder.next_diagnosis(case.name))


def _said_of(challenge: Challenge, case: Case, campaign: Path, out: Path) -> None:
    """Diagnose, unless that is done."""
    if (out / diagnosis.FILE).exists():
        return
    with replaced_folder(out) as aside:
        challenge.diagnose(campaign, aside, case.without)
        if not (aside / diagnosis.FILE).exists():
            raise ChallengeError(f"{campaign}: the diagnosis has written no {diagnosis.FILE}")


@cache
def _fmus() -> Fmus:
    """The models, once a process."""
    return Fmus(model("HRGCarrier"), simulation())


@contextmanager
def _shared(
    workers: int,
) -> Iterator[Callable[[str, Work[Result], Sequence[Case]], list[Result]]]:
    """Work shared among processes, one after the other in this one where there is one worker."""
    if workers == 1:
        yield lambda title, work, cases: _told(title, map(work, cases), len(cases))
        return
    _fmus()  # built before others ask for it
    others = set(multiprocessing.active_children())
    with ProcessPoolExecutor(workers, multiprocessing.get_context("spawn")) as pool:
        try:
            yield lambda title, work, cases: _told(
                title, _results(pool, workers, title, work, cases), len(cases)
            )
        except BaseException:
            # a pool that is asked to end may wait for ever; what is half done is done again
            for worker in set(multiprocessing.active_children()) - others:
                worker.terminate()
            pool.shutdown(wait=False, cancel_futures=True)
            raise


def _results(
    pool: ProcessPoolExecutor,
    workers: int,
    title: str,
    work: Work[Result],
    cases: Sequence[Case],
) -> Iterator[Result]:
    """In order; a process that was killed is told with the cases that were begun."""
    names: dict[Future[Result], str] = {pool.submit(work, case): case.name for case in cases}
    for future in list(names):
        try:
            yield future.result()
        except BrokenProcessPool as error:
            lost = [name for each, name in names.items() if not _has_result(each)]
            raise ChallengeError(
                f"{title}: a worker was killed, perhaps for want of memory, at one of "
                f"{', '.join(lost[:workers])}; what is done is kept: go on with fewer --workers"
            ) from error


def _has_result(future: Future[Result]) -> bool:
    return future.done() and future.exception() is None


def _told(title: str, results: Iterable[Result], count: int) -> list[Result]:
    """With a bar on a terminal, and a line that stays when all are done."""
    done = list(tqdm(results, title, count, leave=False, disable=None if count else True))
    if count:
        print(f"{title}: {count} campaign{'' if count == 1 else 's'}", file=sys.stderr)
    return done
