"""Blocks spread over workers by Dask: of this machine, or of any cluster."""

import logging
import os
import re
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import CancelledError
from contextlib import contextmanager
from queue import Empty, SimpleQueue
from signal import SIGINT, SIGTERM, signal
from threading import Event, current_thread, main_thread
from typing import Any

import dask
from distributed import Client, Future, KilledWorker, LocalCluster

from ins_eval.study.run.errors import StudyRunError

ADDRESS = r"(tcp|tls)://\S+:\d+"
ATTENTION = 0.2
"""Between looks at signals, s."""
PATIENCE = 10.0
"""For a scheduler or a result to arrive, s."""
ANY_PORT = "127.0.0.1:0"
"""Of a scheduler's own page: several studies may run on a machine at once."""


ONE_AT_A_TIME = {"distributed.scheduler.worker-saturation": 1.0}
"""No block waits at a worker, and is blamed for its death."""


@contextmanager
def connected(scheduler: str | None, workers: int | None) -> Iterator[Client]:
    """A Dask client.

    Args:
        scheduler: address of a cluster's; None starts workers on this machine, processes of one
            thread each.
        workers: how many then; as many as this process has cores, if not given.

    Raises:
        StudyRunError: no scheduler answers there.
    """
    if scheduler is None:
        options = {
            "n_workers": workers or len(os.sched_getaffinity(0)),
            "threads_per_worker": 1,
            "memory_limit": 0,
            "dashboard_address": ANY_PORT,
            "silence_logs": logging.CRITICAL,
        }
        with (
            dask.config.set(ONE_AT_A_TIME),
            LocalCluster(**options) as local,
            Client(local, set_as_default=False) as client,
        ):
            yield client
        return
    if not re.fullmatch(ADDRESS, scheduler):
        raise StudyRunError(f"{scheduler}: found no address, expected tcp://HOST:PORT")
    try:
        client = Client(scheduler, timeout=PATIENCE, set_as_default=False)
    except OSError as error:
        raise StudyRunError(f"{scheduler}: found no scheduler, expected one: {error}") from error
    with client:
        yield client


def spread(
    client: Client,
    work: Callable[[int], bytes],
    numbers: Sequence[int],
    name: str,
    done: Callable[[int, bytes], None],
) -> None:
    """Do blocks, in any order.

    Args:
        client: of the cluster.
        work: gives a block's file; a pure function, so that a lost worker's is done again.
        numbers: of the blocks.
        name: of the study, the same for the same work.
        done: told number and file of each block that is done.

    Raises:
        StudyRunError: a block takes its workers down; the scheduler is gone.
    """
    keys = [f"{name}-{number}" for number in numbers]
    number_of: dict[Any, int] = dict(zip(keys, numbers, strict=True))
    futures = client.map(work, numbers, key=keys, retries=0)
    with _signals() as interrupted:
        for future in _as_completed(futures, interrupted):
            number = number_of[future.key]
            try:
                file = _result(future, interrupted)
            except KilledWorker as error:
                raise StudyRunError(f"block {number}: found its workers killed: {error}") from error
            except CancelledError as error:
                raise StudyRunError(
                    f"block {number}: the scheduler is gone; the same command goes on from here"
                ) from error
            done(number, file)
            del future


def _as_completed(futures: list[Future[bytes]], interrupted: Event) -> Iterator[Future[bytes]]:
    """As they end; forgets them, since a result that is still referred to is computed again when
    its worker dies.

    Raises:
        KeyboardInterrupt: interrupted.
    """
    ended: SimpleQueue[Future[bytes]] = SimpleQueue()
    left = len(futures)
    while futures:
        futures.pop().add_done_callback(ended.put)
    while left:
        if interrupted.is_set():
            raise KeyboardInterrupt
        try:
            future = ended.get(timeout=ATTENTION)
        except Empty:
            continue
        left -= 1
        yield future
        del future


def _result(future: Future[bytes], interrupted: Event) -> bytes:
    """Of one that has ended; its worker may have died since, and it is computed again.

    Raises:
        KeyboardInterrupt: interrupted.
    """
    while not interrupted.is_set():
        try:
            return future.result(timeout=PATIENCE)
        except TimeoutError:
            continue
    raise KeyboardInterrupt


@contextmanager
def _signals() -> Iterator[Event]:
    """Set by SIGINT and SIGTERM while this lasts. Their exception could end in a destructor, of a
    future for one, which swallows it."""
    interrupted = Event()
    if current_thread() is not main_thread():
        yield interrupted
        return
    before = {number: signal(number, lambda *_: interrupted.set()) for number in (SIGINT, SIGTERM)}
    try:
        yield interrupted
    finally:
        for number, handler in before.items():
            signal(number, handler)
