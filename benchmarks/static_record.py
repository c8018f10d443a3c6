"""How often a static record raises a false alarm, and how strong a noise has to be to be named.

    python benchmarks/static_record.py [records a case]

Simulated records of 4096 s at 1 s, half of them held out; the noise is that of the tests. Strengths
are in standard deviations with which the fitted half would show them if all else were known.
"""

import sys
from collections import Counter
from concurrent.futures import ProcessPoolExecutor

import numpy as np
from scipy.stats import binomtest
from tqdm import tqdm

from pyhrg.gap.static_record.belief import Belief
from pyhrg.gap.static_record.fit.diagnosis import (
    ChannelDiagnosis,
    diagnose_channel,
    transform_channel,
)
from pyhrg.gap.static_record.fit.evidence import build_problem
from pyhrg.gap.static_record.record import Channel
from pyhrg.gap.static_record.terms import GYRO
from tests.pyhrg.noises import noisy_angle

N = 4096
SEED = 20
BELIEFS = {
    "Q, N": (1.0, 0.3, 0.0, 0.0),
    "Q, N, B": (1.0, 0.3, 0.05, 0.0),
    "Q, N, K": (1.0, 0.3, 0.0, 0.003),
    "N": (0.0, 1.0, 0.0, 0.0),
}
"""Levels, SI; each is drawn about them with the tolerance that they are believed with."""
TERMS = {1: "angle random walk", 2: "bias instability", 3: "rate random walk"}
FEWER = 5
"""Of the cases in which something is missing."""
SIGMAS = (5, 10, 20, 40, 80)


def diagnosis_of(
    levels: tuple[float, ...], extra: tuple[int, float], seed: int
) -> tuple[ChannelDiagnosis, float]:
    """Of a record of the noises, one of which has a strength more, in sigmas; and its level, SI."""
    generator = np.random.default_rng([SEED, seed])
    belief = Belief(np.array(levels))
    drawn = belief.levels * np.exp(belief.tolerance * generator.standard_normal(4))
    term, sigmas = extra
    channel = Channel("gyro", GYRO, 1.0, np.zeros(N))
    half = channel.part(0, channel.half)
    unit = 2 * build_problem(transform_channel(half, belief), belief, 1.0).centres - np.log(10.0)
    drawn[term] = np.sqrt(drawn[term] ** 2 + sigmas * np.exp(unit[term]))
    angle = noisy_angle(N, (*drawn.tolist(), 0.0), generator)
    return diagnose_channel(Channel("gyro", GYRO, 1.0, angle), belief, seed=seed), float(
        drawn[term]
    )


def outcome(case: tuple[tuple[float, ...], tuple[int, float], int]) -> str:
    """no_gap, unexplained, right (its level within its interval or not), in its class, wrong."""
    levels, (term, sigmas), seed = case
    found, level = diagnosis_of(levels, (term, sigmas), seed)
    names = {cause.term.effect for cause in found.causes}
    near = {name for cause in found.causes for name in cause.equivalents}
    truth = GYRO.terms[term].effect
    if found.verdict in ("no_gap", "unexplained"):
        return found.verdict
    if names == {truth}:
        cause = found.causes[0]
        covered = cause.low < level / cause.term.factor < cause.high
        return "right" if covered else "right, level missed"
    return "in its class" if len(names) == 1 and truth in near else "wrong"


def main() -> None:
    """Print shares with exact binomial 95 % intervals."""
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 200
    cases = [(f"nothing beyond {name}", levels, (1, 0.0)) for name, levels in BELIEFS.items()]
    cases += [
        (f"{name} of {s} sigma beyond Q, N", BELIEFS["Q, N"], (term, float(s)))
        for term, name in TERMS.items()
        for s in SIGMAS
    ]
    with ProcessPoolExecutor() as pool:
        for title, levels, extra in tqdm(cases, disable=None):
            n = count if extra[1] == 0 else count // FEWER
            runs = [(levels, extra, seed) for seed in range(n)]
            found = Counter(pool.map(outcome, runs, chunksize=8))
            quiet = binomtest(n - found["no_gap"], n).proportion_ci()
            text = ", ".join(f"{name} {found[name]}" for name in sorted(found))
            print(f"{title}: {text}; alarms {quiet.low:.1%} to {quiet.high:.1%}", flush=True)


if __name__ == "__main__":
    main()
