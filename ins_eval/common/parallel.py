"""Work spread over threads; results do not depend on their number."""

import os
import threading
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

Item = TypeVar("Item")
Result = TypeVar("Result")


def map_in_threads(
    work: Callable[[Item], Result],
    items: Sequence[Item],
    stop: threading.Event,
    workers: int | None = None,
    done: Callable[[Result], None] = lambda result: None,
) -> list[Result]:
    """Apply `work` to all items on several threads, and return the results in the items' order.

    work: called once for each item; it should release the interpreter lock while it computes;
    items: arguments of `work`; stop: set when a call fails or is interrupted, so that running calls
    can end early; workers: number of threads; by default the number of cores of this process.
    """
    results = []
    with ThreadPoolExecutor(workers or len(os.sched_getaffinity(0))) as pool:
        try:
            for result in pool.map(work, items):
                results.append(result)
                done(result)
        except BaseException:
            stop.set()
            raise
    return results
