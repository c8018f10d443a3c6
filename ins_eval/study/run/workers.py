"""Distributes blocks over Dask workers of this machine or of any cluster."""

from __future__ import annotations

import logging
import re
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import CancelledError
from contextlib import contextmanager
from queue import Empty, SimpleQueue
from signal import SIGINT, SIGTERM, signal
from threading import Event, current_thread, main_thread
from typing import TYPE_CHECKING, Any

from pyhrg.common.arguments import count_cores
from pyhrg.common.errors import HrgError
from pyhrg.common.extras import import_extra

if TYPE_CHECKING:
    from distributed import Client, Future

ADDRESS = r"(tcp|tls)://\S+:\d+"
POLL_INTERVAL = 0.2
"""Time between checks for signals, s. Chosen."""
ARRIVAL_TIMEOUT = 10.0
"""Time to wait for a scheduler or a result, s. Chosen."""
DASHBOARD_ADDRESS = "127.0.0.1:0"
"""Any free port for the scheduler's page, so that several studies can run on a machine."""
NO_PREFETCH = {"distributed.scheduler.worker-saturation": 1.0}
"""A worker gets one block at a time: a block that waits there would be blamed for its death."""


@contextmanager
def connect(scheduler: str | None, workers: int | None) -> Iterator[Client]:
    """A Dask client inside the context.

    Args:
        scheduler: address of a cluster's scheduler; None starts workers on this machine, processes
            of one thread each.
        workers: number of these processes; None for the number of cores of this process.

    Raises:
        HrgError: the address is none, or no scheduler answers there; Dask is not installed.
    """
    dask, distributed = import_extra("dask"), import_extra("distributed")
    if scheduler is None:
        options = {
            "n_workers": workers or count_cores(),
            "threads_per_worker": 1,
            "memory_limit": 0,
            "dashboard_address": DASHBOARD_ADDRESS,
            "silence_logs": logging.CRITICAL,
        }
        with (
            dask.config.set(NO_PREFETCH),
            distributed.LocalCluster(**options) as local,
            distributed.Client(local, set_as_default=False) as client,
        ):
            yield client
        return
    if not re.fullmatch(ADDRESS, scheduler):
        raise HrgError(f"{scheduler}: found no address, expected tcp://HOST:PORT")
    try:
        client = distributed.Client(scheduler, timeout=ARRIVAL_TIMEOUT, set_as_default=False)
    except OSError as error:
        raise HrgError(f"{scheduler}: found no scheduler, expected one: {error}") from error
    with client:
        yield client


def run_blocks(
    client: Client,
    work: Callable[[int], bytes],
    numbers: Sequence[int],
    name: str,
    done: Callable[[int, bytes], None],
) -> None:
    """Compute blocks, in any order.

    Args:
        work: computes a block's file; a pure function, so that a lost block is computed again.
        name: name of the study, the same for the same work.
        done: is called with number and file of each finished block.

    Raises:
        HrgError: a block kills its workers; the scheduler is gone.
        KeyboardInterrupt: interrupted by a signal.
    """
    killed = import_extra("distributed").KilledWorker
    keys = [f"{name}-{number}" for number in numbers]
    number_of: dict[Any, int] = dict(zip(keys, numbers, strict=True))
    futures = client.map(work, numbers, key=keys, retries=0)
    with _catch_signals() as interrupted:
        for future in _yield_completed(futures, interrupted):
            number = number_of[future.key]
            try:
                file = _wait_for_result(future, interrupted)
            except killed as error:
                raise HrgError(f"block {number}: found its workers killed: {error}") from error
            except CancelledError as error:
                raise HrgError(
                    f"block {number}: the scheduler is gone; the same command goes on from here"
                ) from error
            done(number, file)
            del future


def _yield_completed(futures: list[Future[bytes]], interrupted: Event) -> Iterator[Future[bytes]]:
    """Futures as they end. They are forgotten, because a result that is still referred to is
    computed again when its worker dies.

    Raises:
        KeyboardInterrupt: interrupted.
    """
    ended: SimpleQueue[Future[bytes]] = SimpleQueue()
    unfinished = len(futures)
    while futures:
        futures.pop().add_done_callback(ended.put)
    while unfinished:
        if interrupted.is_set():
            raise KeyboardInterrupt
        try:
            future = ended.get(timeout=POLL_INTERVAL)
        except Empty:
            continue
        unfinished -= 1
        yield future
        del future


def _wait_for_result(future: Future[bytes], interrupted: Event) -> bytes:
    """The result of a future that has ended. If its worker has died since, it is computed again.

    Raises:
        KeyboardInterrupt: interrupted.
    """
    while not interrupted.is_set():
        try:
            return future.result(timeout=ARRIVAL_TIMEOUT)
        except TimeoutError:
            continue
    raise KeyboardInterrupt


@contextmanager
def _catch_signals() -> Iterator[Event]:
    """An event that SIGINT and SIGTERM set inside the context. An exception instead could arise in
    a destructor, such as that of a future, and be swallowed there."""
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
