"""Estimates from the channels of a block's gyros, as arrays."""

from collections.abc import Mapping, Sequence

import numpy as np

from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.study.cosimulated import MissionTruth, seed_noise
from ins_eval.study.gyros.drawn_triad import DrawnTriad, TriadDistribution
from ins_eval.study.witness.believed import BelievedGyro, believe_gyro
from ins_eval.study.witness.flight import fly_with_channels
from ins_eval.study.witness.self_test import SELF_TEST
from ins_eval.study.witness.witnessed import WitnessedFlight, witness_flights
from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.common.arrays import Array
from pyhrg.fmu import GyroFmu

TESTS = (0.0, SELF_TEST)
"""Durations of the self-test at power-on, s: each triad flies with each."""
TOGETHER = 5
"""Number of triads that fly side by side. Derived: 15 gyros nearly fill the lanes of two vectors
of `pyhrg.fmu.WIDE`, and five flights of two hours are a GB."""
ERRORS = ("flown", "by_bench", "by_channels", "by_self_test", "estimated", "known")
"""Fields of `WitnessedFlight` that are errors, north and east."""
SHAPES = {
    **dict.fromkeys(ERRORS, (2,)),
    **dict.fromkeys(("estimated_covariance", "known_covariance"), (2, 2)),
    **dict.fromkeys(("squares", "degrees", "p_values", "followed"), (3,)),
}
"""Shapes of the fields of `WitnessedFlight`."""
BENCH_ERROR = (0, 0, 0)
"""Key, in a triad's seed, of the bench's errors."""


def believe_triad(
    slow: GyroFmu, distribution: TriadDistribution, triad: DrawnTriad
) -> list[BelievedGyro]:
    """The gyros of a triad as its bench leaves them known; slow: `HRGSlow`."""
    seed = np.random.SeedSequence(triad.seed.tolist(), spawn_key=BENCH_ERROR)
    generator = np.random.default_rng(seed)
    return [believe_gyro(slow, each, distribution, generator) for each in triad.calibrated]


def witness_triads(
    fmus: tuple[GyroFmu, GyroFmu],
    truth: MissionTruth,
    weights: MissionWeights,
    mission: int,
    triads: Mapping[int, tuple[DrawnTriad, Sequence[BelievedGyro]]],
    numbers: Sequence[int],
    disturbances: Mapping[int, Sequence[Disturbance]] | None = None,
    tests: Sequence[float] = TESTS,
) -> dict[str, Array]:
    """(r, t, ...) fields of `WitnessedFlight` in a mission, NaN for triads that are not
    witnessed.

    fmus: `HRG` and `HRGSlow`; weights: at the mission's end alone; mission: its number in the
    study, with which a triad's seed decides the noise; triads: those that are witnessed, by number;
    numbers: (r,) of the whole block; disturbances: effects outside the model, of each gyro of the
    triads, by number; tests: (t,) durations of the self-test, s.
    """
    flown = list(triads.items())
    flights: dict[int, list[WitnessedFlight]] = {number: [] for number in triads}
    for first in range(0, len(flown), TOGETHER):
        part = flown[first : first + TOGETHER]
        drawn, believed = [each for _, (each, _) in part], [each for _, (_, each) in part]
        effects = [disturbances[number] for number, _ in part] if disturbances else []
        noise = [seed_noise(each, mission) for each in drawn]
        for test in tests:
            recorded = fly_with_channels(fmus[0], truth, drawn, noise, test, effects)
            witnessed = witness_flights(fmus, weights, drawn, believed, recorded)
            for (number, _), each in zip(part, witnessed, strict=True):
                flights[number].append(each)
    return {
        name: np.stack([_stack(flights.get(number), name, len(tests)) for number in numbers])
        for name in SHAPES
    }


def _stack(flights: list[WitnessedFlight] | None, name: str, count: int) -> Array:
    if flights is None:
        return np.full((count, *SHAPES[name]), np.nan)
    return np.stack([getattr(each, name) for each in flights])
