"""Claims of `HRG.Validation`, demonstrated over the circumference, several at a time."""

import math
import multiprocessing
import os
import re
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import Future, ProcessPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass

from fmu_build.roots import ROOTS
from tests.modelica.models import Model, ModelFmu, built, models

START_ANGLES = tuple(0.1 + i * math.pi / 7 for i in range(7))
"""Around the circumference, rad: seven, so that harmonics 2, 4 and 8 are told apart."""
CLAIMS = models("Validation")
_FIXED = "redeclare final model Gyro"
_HELD_IN_BOTH = re.compile(
    r"Modes|Precession|RandomErrors|Damping\.RingDown|Drives\.Authority|PickOffs\.FullScale"
)
SLOW_CLAIMS = [
    claim.made_of(ROOTS["HRGSlow"])
    for claim in CLAIMS
    if _HELD_IN_BOTH.search(claim.name) and _FIXED not in claim.text
]
"""Claims of what `test_fidelities.py` does not compare of HRG and HRGSlow: noise, lock-in, start-up
and other modes, ring-down, and overload."""


@dataclass(frozen=True)
class Result:
    """What a model gave at its stop time, from one start angle (rad); units are the model's."""

    start_angle: float
    measured: float
    expected: float
    scale: float


@dataclass(frozen=True)
class Demonstration:
    """Results with the mechanism, and of the negative control, without it."""

    tolerance: float
    shown: Sequence[Result]
    control: Sequence[Result]


def demonstrate(claim: Model) -> Demonstration:
    """Build a model and run it from every start angle, the control from every third."""
    with built(claim) as fmu:
        shown = [_run(fmu, claim, angle, present=1) for angle in START_ANGLES]
        control = [_run(fmu, claim, angle, present=0) for angle in START_ANGLES[::3]]
        (tolerance,) = fmu.read(["tolerance"])
    return Demonstration(tolerance, shown, control)


def _run(fmu: ModelFmu, claim: Model, start_angle: float, present: int) -> Result:
    fmu.power_on({"startAngle": start_angle, "present": present})
    fmu.advance(0.0, claim.stop_time)
    return Result(start_angle, *fmu.read(["measured", "expected", "scale"]))


@contextmanager
def demonstrations(claims: Iterable[Model]) -> Iterator[dict[str, Future[Demonstration]]]:
    """Demonstrate claims on all cores: results to come, by the models' names."""
    pool = ProcessPoolExecutor(
        len(os.sched_getaffinity(0)), mp_context=multiprocessing.get_context("spawn")
    )
    try:
        yield {claim.name: pool.submit(demonstrate, claim) for claim in claims}
    finally:
        pool.shutdown(cancel_futures=True)
