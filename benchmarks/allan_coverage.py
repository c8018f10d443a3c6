"""How often the 95 % intervals of the noise coefficients hold what was put in.

`python benchmarks/allan_coverage.py [REPEATS] [SAMPLES]` (default 1000 records of 4000 angles a
mixture, seed 1): for each mixture and coefficient the share of records whose interval covers, with
its 95 % binomial interval, and the share in which the coefficient is told from zero. Then the same
over HRGSlow, with a tenth of the repeats.
"""

import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.stats import binomtest
from tqdm.contrib.concurrent import process_map

sys.path.insert(0, str(Path(__file__).parents[1]))

from fmu_build.bundle import built_fmu
from fmu_build.roots import ROOTS
from pyhrg.fmu import GyroFmu
from pyhrg.noise_model import NoiseCoefficients, identify
from tests.pyhrg.noises import noisy_angle

NAMES = list(NoiseCoefficients.__dataclass_fields__)
Mixture = tuple[float, float, float, float, float]
MIXTURES: dict[str, Mixture] = {
    "Q and N": (1, 1, 0, 0, 0),
    "N and B": (0, 1, 0.3, 0, 0),
    "all": (10, 1, 0.3, 0.01, 0),
    "N and faint K": (1, 0.3, 0, 0.0003, 0),
    "Q, N, K, R": (1, 0.1, 0, 0.001, 1e-4),
}
GYRO: Mixture = (3e-7, 1e-7, 2e-8, 1e-10, 0)
"""In SI, of the gyro; angles every second."""
SEED = 1


def of_mixture(mixture: Mixture, samples: int, seed: int) -> NDArray[np.float64]:
    """One record of NumPy's noise."""
    return noisy_angle(samples, mixture, np.random.default_rng([SEED, seed]))


def of_gyro(mixture: Mixture, samples: int, seed: int) -> NDArray[np.float64]:
    """One record of HRGSlow at rest."""
    q, n, b, k, _ = mixture
    bryan = 0.277
    parameters = {
        "noise.angleRandomWalk": n**2,
        "noise.pickOff": (2 * bryan * q) ** 2 * 1e-3,
        "noise.biasInstability": b,
        "noise.rateRandomWalk": k**2,
        "samplePeriod": 1.0,
    }
    with GyroFmu(built_fmu(root=ROOTS["HRGSlow"])).power_on(parameters, seed, 0.3) as gyro:
        return gyro.drive(np.zeros(samples), 1.0)


Record = Callable[[Mixture, int, int], NDArray[np.float64]]


def judged(job: tuple[Record, Mixture, int, int]) -> list[tuple[bool, bool]]:
    """Of each coefficient: covered, present."""
    record, mixture, samples, seed = job
    found = identify(record(mixture, samples, seed), 1.0)
    coefficients = [getattr(found, name) for name in NAMES]
    return [(c.low <= x <= c.high, c.present) for c, x in zip(coefficients, mixture, strict=True)]


def report(title: str, record: Record, mixture: Mixture, repeats: int, samples: int) -> None:
    """Repeat and print."""
    began = time.perf_counter()
    jobs = [(record, mixture, samples, seed) for seed in range(repeats)]
    counts = np.sum(process_map(judged, jobs, chunksize=10, disable=True), axis=0)
    print(f"{title}: {repeats} records of {samples}, {time.perf_counter() - began:.0f} s")
    for name, value, (covered, present) in zip(NAMES, mixture, counts, strict=True):
        low, high = binomtest(int(covered), repeats).proportion_ci()
        share = f"{covered / repeats:.3f} ({low:.3f} to {high:.3f})"
        print(f"  {name:18} {value:8.2g}  covered {share}  present {present / repeats:.3f}")
    sys.stdout.flush()


def main(repeats: int, samples: int) -> None:
    """Run and print."""
    for title, mixture in MIXTURES.items():
        report(title, of_mixture, mixture, repeats, samples)
    report("HRGSlow", of_gyro, GYRO, max(1, repeats // 10), samples)


if __name__ == "__main__":
    numbers = [int(x) for x in sys.argv[1:]]
    main(*numbers, *[1000, 4000][len(numbers) :])
