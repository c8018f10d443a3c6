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
    """Apply `work` to all items on several threads, and return the results in their order.

    `work` should release the interpreter lock; `stop` is set when a call fails, so that running
    calls can end early; `done` is called with each result, in order.
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
