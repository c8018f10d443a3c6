"""Mean time to specification over seven power-ons, against that of many."""

from functools import lru_cache

import numpy as np

from pyhrg.bench.bench import Bench
from pyhrg.bench.dynamic import start_up
from pyhrg.bench.outcome import Finding
from pyhrg.fmu import GyroFmu
from pyhrg.parameters import TYPICAL

MODEL = "HRG"
MANY = 1000
DURATION = 80.0


def repeat(fmu: GyroFmu, seed: int) -> dict[str, tuple[float, float, float]]:
    """Truth, the mean over many power-ons of the same gyro, and interval."""
    found = times(fmu, seed, start_up.RUNS)
    return {
        finding.name: (truth, finding.low, finding.high)
        for finding, truth in zip(found, truths(fmu), strict=True)
    }


def times(fmu: GyroFmu, seed: int, runs: int) -> tuple[Finding, Finding]:
    """Mean times of a number of power-ons."""
    bench = Bench(fmu, TYPICAL, seed)
    tests = start_up.record(bench, runs, DURATION)
    found = [start_up.start_up(test.log, bench.device.site.latitude) for test in tests]
    return (
        start_up.times("time to valid output", [run.valid for run in found], bench.step)[0],
        start_up.times("time to specification", [run.within for run in found], bench.step)[0],
    )


@lru_cache(maxsize=1)
def truths(fmu: GyroFmu) -> tuple[float, float]:
    """Means over many power-ons, in portions."""
    parts = [[f.value for f in times(fmu, 10**6 + i, 20)] for i in range(MANY // 20)]
    valid, within = np.mean(parts, axis=0)
    return float(valid), float(within)
