"""How often 95 % intervals hold what was put into the device: `python -m benchmarks.intervals`.

Each module here repeats one procedure: `repeat(fmu, seed)` draws a device, runs the procedure, and
returns (truth, low, high) by finding; `MODEL` names the gyro. An interval is honest when it holds
the truth in 93 to 97 % of the repeats.
"""

import argparse
import importlib
import math
import os
import pkgutil
import time
from collections import Counter
from concurrent.futures import ProcessPoolExecutor
from functools import cache, partial

from scipy.stats import binomtest

import benchmarks.intervals
from fmu_build.bundle import build_fmu
from pyhrg.fmu import GyroFmu

HONEST = (0.93, 0.97)
NAMES = sorted(
    module.name
    for module in pkgutil.iter_modules(benchmarks.intervals.__path__)
    if not module.name.startswith("_")
)


@cache
def gyro(model: str) -> GyroFmu:
    """The FMU, once a process."""
    return GyroFmu(build_fmu(model))


def held(name: str, seed: int) -> dict[str, bool]:
    """By finding, whether the interval of one repeat holds the truth."""
    case = importlib.import_module(f"benchmarks.intervals.{name}")
    found = case.repeat(gyro(case.MODEL), seed)
    return {
        finding: low <= truth <= high
        for finding, (truth, low, high) in found.items()
        if not math.isnan(low)
    }


def measure(name: str, repeats: int, workers: int) -> bool:
    """Print the coverage of one procedure's findings; True when all are honest."""
    gyro(importlib.import_module(f"benchmarks.intervals.{name}").MODEL)
    inside: Counter[str] = Counter()
    total: Counter[str] = Counter()
    begin = time.perf_counter()
    with ProcessPoolExecutor(workers) as pool:
        for result in pool.map(partial(held, name), range(repeats), chunksize=10):
            total.update(result.keys())
            inside.update(finding for finding, holds in result.items() if holds)
    print(
        f"{name}: {repeats} repeats, seeds 0 to {repeats - 1}, {time.perf_counter() - begin:.0f} s"
    )
    good = True
    for finding, n in total.items():
        share = inside[finding] / n
        low, high = binomtest(inside[finding], n).proportion_ci(method="wilson")
        honest = HONEST[0] <= share <= HONEST[1]
        good &= honest
        mark = "" if honest else "   outside 93 to 97 %"
        print(f"  {finding:<34}{share:7.1%} of {n:5} ({low:.1%} to {high:.1%}){mark}", flush=True)
    return good


def main() -> None:
    """Measure all procedures, or those named."""
    parser = argparse.ArgumentParser(description=__doc__, prog="python -m benchmarks.intervals")
    parser.add_argument("procedures", nargs="*", metavar="PROCEDURE", help="default: all")
    parser.add_argument("--repeats", type=int, default=1000)
    parser.add_argument("--workers", type=int, default=len(os.sched_getaffinity(0)))
    options = parser.parse_args()
    if unknown := set(options.procedures) - set(NAMES):
        parser.error(f"{', '.join(unknown)}: expected of {', '.join(NAMES)}")
    results = [
        measure(name, options.repeats, options.workers) for name in options.procedures or NAMES
    ]
    raise SystemExit(0 if all(results) else 1)


if __name__ == "__main__":
    main()
