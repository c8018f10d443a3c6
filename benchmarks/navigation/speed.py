"""Samples per second, one core; each figure is the best of several runs."""

import subprocess
import sys
import time
from collections.abc import Callable
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from benchmarks.navigation import peer
from benchmarks.navigation.motions import KEPT_EACH, Flight
from ins_eval.navigation import kernel
from ins_eval.navigation.coefficients import derive_coefficients
from ins_eval.navigation.strapdown import navigate

REPEATS = 7

FRESH = """
import time
begin = time.perf_counter()
import numpy as np
from ins_eval.increments import Increments
from ins_eval.navigation.height import Clamped
from ins_eval.navigation.strapdown import navigate
from ins_eval.state import State
imported = time.perf_counter()
still = np.zeros((2, 3))
start = State(0.7, 0.0, 0.0, np.zeros(3), np.eye(3))
navigate(start, Increments(0.01, still, still), Clamped(np.zeros(3)), 2)
print(imported - begin, time.perf_counter() - imported)
"""


def best(call: Callable[[], object]) -> float:
    """Seconds of the quickest of several calls, after one that is not counted."""
    call()
    times = []
    for _ in range(REPEATS):
        begin = time.perf_counter()
        call()
        times.append(time.perf_counter() - begin)
    return min(times)


def end_to_end(flight: Flight, samples: int) -> float:
    """Samples/s, increments in, track out."""
    increments, clamp, start = flight.increments, flight.clamp(), flight.start()
    keep = round(KEPT_EACH / increments.interval)
    seconds = best(lambda: navigate(start, increments, clamp, keep, samples))
    return len(increments) / seconds


def bare_loop(flight: Flight, samples: int) -> float:
    """Samples/s of the compiled loop alone, its arguments ready."""
    increments, start = flight.increments, flight.start()
    count, interval = len(increments), increments.interval
    keep = round(KEPT_EACH / interval) // samples
    arguments = (
        (start.latitude, start.longitude, start.height),
        tuple(map(float, start.velocity)),
        tuple(map(float, Rotation.from_matrix(start.mat_nb).as_quat(scalar_first=True))),
        interval,
        increments.rotation,
        increments.velocity,
        derive_coefficients(samples),
        flight.clamp().make_channel(count, samples, interval),
        (0.0, 0.0),
        keep,
        np.empty((count // samples // keep, kernel.STATE_SIZE)),
    )
    return count / best(lambda: kernel.run_steps(*arguments))


def peers(strapdown: Any, flight: Flight) -> float:
    """Samples/s of pyins, table of increments in, table of states out."""
    table, start = peer.table(flight.record), flight.start()
    return len(flight.increments) / best(lambda: peer.navigated(strapdown, start, table))


def first_call() -> tuple[float, float]:
    """Seconds of the import and of the first call in a fresh process, compiled code on disk."""
    for _ in range(2):
        run = subprocess.run(
            [sys.executable, "-c", FRESH], check=True, capture_output=True, text=True
        )
    imported, called = map(float, run.stdout.split())
    return imported, called
