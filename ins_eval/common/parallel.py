"""Work shared among threads, the same result on any number of them."""

import os
import threading
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

Item = TypeVar("Item")
Result = TypeVar("Result")


def in_parallel(
    work: Callable[[Item], Result],
    items: Sequence[Item],
    stop: threading.Event,
    workers: int | None = None,
    done: Callable[[Result], None] = lambda result: None,
) -> list[Result]:
    """Results in the items' order.

    Args:
        work: done once an item; releases the interpreter where it takes long.
        items: what is worked on.
        stop: set when anything fails or interrupts, so that work under way can end.
        workers: threads; as many as this process has cores, if not given.
        done: told each result, in order.
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
