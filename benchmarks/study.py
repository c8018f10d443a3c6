"""What triads and their flights cost in the study.

`python benchmarks/study.py [FLIGHTS]` (default 10,000 triad missions of 2 h) prints the time of a
triad (three gyros built, calibrated, benched, drifted and read off), of a mission's weights, made
and read again, and of the flights. The flights are those of the triads made, repeated, each with
noise of its own.
"""

import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import numpy as np

from fmu_build.bundle import build_fmu
from ins_eval.mission_model.missions import plan_mission
from ins_eval.mission_model.position_errors import TriadBlock, compute_linear_position_errors
from ins_eval.mission_model.weights_cache import load_mission_weights
from ins_eval.study.gyros.drawn_triad import (
    TriadDistribution,
    draw_triad,
    make_triad_seed,
    tabulate_triads,
)
from pyhrg.fmu import GyroFmu

MADE = 4
BLOCK = 1000
"""Triads flown at once."""


@contextmanager
def timed(what: str, count: int = 1) -> Iterator[None]:
    """Print the time, whole and per piece, of this process too."""
    wall, cpu = time.perf_counter(), time.process_time()
    yield
    wall, cpu = time.perf_counter() - wall, time.process_time() - cpu
    print(f"{what:44s} {wall:8.2f} s, {cpu:8.2f} s of a core; each {1e3 * cpu / count:.3g} ms")


def repeated(triads: TriadBlock, count: int) -> TriadBlock:
    """As many, with seeds of their own."""
    many = triads.select(list(range(len(triads))) * -(-count // len(triads)))
    seeds = np.random.SeedSequence(1).generate_state(2 * len(many), np.uint64)
    return replace(many, seeds=seeds.reshape(-1, 2))


def main(flights: int) -> None:
    """Print the costs."""
    fmu = GyroFmu(build_fmu("HRGSlow"))
    fmu.prepare()
    draw_triad(fmu, TriadDistribution(), make_triad_seed(0, 0))
    with timed("triads: built, calibrated, benched, drifted", MADE):
        drawn = [draw_triad(fmu, TriadDistribution(), make_triad_seed(1, n)) for n in range(MADE)]
        triads = tabulate_triads(fmu, drawn)
    mission = plan_mission("car", 2.0)
    with tempfile.TemporaryDirectory() as folder:
        with timed("weights of two hours of the car, made"):
            load_mission_weights(mission, Path(folder))
        with timed("weights, read again"):
            weights = load_mission_weights(mission, Path(folder))
    many = repeated(triads, min(flights, BLOCK))
    with timed(f"{flights} flights of two hours", flights):
        for _ in range(-(-flights // len(many))):
            compute_linear_position_errors(many, weights, 0)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 10_000)
