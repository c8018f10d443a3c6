"""Work on the cases of a challenge, shared among processes."""

import multiprocessing
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from typing import TypeVar

from pyhrg.challenge.case import Case
from pyhrg.challenge.truths.seal import ChallengeError
from pyhrg.common.progress import Progress

Result = TypeVar("Result")
Work = Callable[[Case], Result]


@contextmanager
def share_work(
    workers: int, progress: bool, prepare: Callable[[], object]
) -> Iterator[Callable[[str, Work[Result], Sequence[Case]], list[Result]]]:
    """A function that does work on all cases and returns the results in order, in processes that
    live while the context does.

    Args:
        workers: number of processes; one works in this process.
        progress: whether a bar is shown on standard error.
        prepare: makes what all processes share, before they begin.
    """
    if workers == 1:
        yield lambda title, work, cases: _collect(title, map(work, cases), len(cases), progress)
        return
    prepare()
    others = set(multiprocessing.active_children())
    with ProcessPoolExecutor(workers, multiprocessing.get_context("spawn")) as pool:
        try:
            yield lambda title, work, cases: _collect(
                title, _yield_results(pool, workers, title, work, cases), len(cases), progress
            )
        except BaseException:
            # a pool that is asked to end may wait for ever; what is half done is done again
            for worker in set(multiprocessing.active_children()) - others:
                worker.terminate()
            pool.shutdown(wait=False, cancel_futures=True)
            raise


def _yield_results(
    pool: ProcessPoolExecutor,
    workers: int,
    title: str,
    work: Work[Result],
    cases: Sequence[Case],
) -> Iterator[Result]:
    """Results in order; the error of a killed process names the cases that were begun."""
    names: dict[Future[Result], str] = {pool.submit(work, case): case.name for case in cases}
    for future in list(names):
        try:
            yield future.result()
        except BrokenProcessPool as error:
            lost = [n for f, n in names.items() if not f.done() or f.exception() is not None]
            raise ChallengeError(
                f"{title}: a worker was killed, perhaps for want of memory, at one of "
                f"{', '.join(lost[:workers])}; what is done is kept: go on with fewer --workers"
            ) from error


def _collect(title: str, results: Iterable[Result], count: int, progress: bool) -> list[Result]:
    """All results; with progress, a bar on a terminal, and a line that stays when all are done."""
    done: list[Result] = []
    with Progress(progress and count > 0, title, "campaigns") as bar:
        for result in results:
            done.append(result)
            bar.update(len(done), count)
        bar.say(f"{title}: {count} campaign{'' if count == 1 else 's'}")
    return done
