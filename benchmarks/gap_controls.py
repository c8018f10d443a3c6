"""How often a diagnosis raises a false alarm, and whether named effects explain what is reversed.

    python benchmarks/gap_controls.py [campaigns a case] [first seed]

Short campaigns of the gyro with sampled loops (those of the tests), all of the catalogue. Quiet:
no gap. Loops: none either, by other loops, which are believed. Full: no gap beside a believed gyro
with many effects. There anything but `no_gap` is wrong. Reversed: the output angle's residual of a
strong effect backwards in time; `explained` is wrong, not that the effect is among what takes part,
since a steady bias is the same backwards. Figures have exact binomial 95 % intervals.
"""

import sys
from collections.abc import Callable
from dataclasses import replace

import numpy as np
from scipy.stats import binomtest
from tqdm import tqdm

from pyhrg.device.device import Device
from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.findings.diagnosis import Diagnosis
from pyhrg.gap.replay.simulation import load_simulation
from pyhrg.records.campaign import Campaign
from tests.pyhrg.gap.bench import recorded
from tests.pyhrg.gap.soundness.conftest import NOMINAL

SIMULATION = load_simulation()
OTHER_LOOPS = replace(NOMINAL, amplitude_loop=3.0, quadrature_loop=12.0, phase_loop=120.0)
FULL = replace(
    NOMINAL,
    pickoff_gain_mismatch=1e-3,
    drive_gain_mismatch=-2e-3,
    phase_error=5e-3,
    residual_quadrature=1e-3,
    demodulation_offset=5e-4,
    misalignment=1e-3,
    loop_delay=5e-4,
)
STRONG = replace(NOMINAL, drive_gain_mismatch=1e-3)


def honest(device: Device) -> Callable[[int], Campaign]:
    """Campaigns of a gyro that is what it is believed to be."""
    return lambda seed: recorded(SIMULATION.sampled, device, device, seed)


def backwards(seed: int) -> Campaign:
    """The residual of a strong effect, reversed in each test."""
    given = recorded(SIMULATION.sampled, STRONG, seed=seed)
    clean = recorded(SIMULATION.sampled, NOMINAL.without_noise(), seed=seed)
    tests = []
    for test, other in zip(given.tests, clean.tests, strict=True):
        residual = test.log.gyro_angle - other.log.gyro_angle
        turned = residual[-1] - np.concatenate([[0.0], residual[:0:-1]])
        log = replace(
            test.log,
            gyro_angle=other.log.gyro_angle + turned,
            wave_angle=other.log.wave_angle - NOMINAL.bryan_factor * turned,
        )
        tests.append(replace(test, recording=log))
    return replace(given, tests=tuple(tests))


def alarm(found: Diagnosis) -> bool:
    """Anything but silence."""
    return found.verdict != "no_gap"


def explained(found: Diagnosis) -> bool:
    """Named effects for all of it."""
    return found.verdict == "explained"


CASES: dict[str, tuple[Callable[[int], Campaign], Callable[[Diagnosis], bool]]] = {
    "quiet": (honest(NOMINAL), alarm),
    "loops": (honest(OTHER_LOOPS), alarm),
    "full": (honest(FULL), alarm),
    "reversed": (backwards, explained),
}


def main(campaigns: int, first: int) -> None:
    """Run and print."""
    for name, (made, wrong) in CASES.items():
        count = 0
        for seed in tqdm(range(first, first + campaigns), desc=name, leave=False):
            found = diagnose(made(seed), simulation=SIMULATION).diagnosis
            if wrong(found):
                count += 1
                causes = [cause.effect for cause in found.causes]
                tqdm.write(f"{name}, seed {seed}: {found.verdict} {causes} {found.unnamed}")
        low, high = binomtest(count, campaigns).proportion_ci(method="exact")
        print(f"{name}: {count} of {campaigns} wrong ({low:.1%} to {high:.1%})", flush=True)


if __name__ == "__main__":
    numbers = [int(x) for x in sys.argv[1:]]
    main(*numbers, *[10, 1][len(numbers) :])
