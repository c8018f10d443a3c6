"""Blocks spread over workers by Dask: of this machine, or of any cluster."""

import logging
import os
import re
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import CancelledError
from contextlib import contextmanager

import dask
from distributed import Client, KilledWorker, LocalCluster, as_completed

from ins_eval.study.run.errors import StudyRunError

ADDRESS = r"(tcp|tls)://\S+:\d+"
PATIENCE = 10.0
"""For a scheduler to answer, s."""


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
            "dashboard_address": None,
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
    number_of = dict(zip(keys, numbers, strict=True))
    futures = client.map(work, numbers, key=keys, retries=0)
    coming = as_completed(futures, loop=client.loop)
    del futures  # a result that is still referred to is computed again when its worker dies
    for future in coming:
        number = number_of[future.key]
        try:
            file = future.result()
        except KilledWorker as error:
            raise StudyRunError(f"block {number}: found its workers killed: {error}") from error
        except CancelledError as error:
            raise StudyRunError(
                f"block {number}: the scheduler is gone; the same command goes on from here"
            ) from error
        done(number, file)
        del future
