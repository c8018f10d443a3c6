"""From a diagnosis to metres: how far the belief's position is from the closed simulation's."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.missions import StudyMission, file_of, study_mission
from ins_eval.mission_model.weights_cache import kept_weights
from ins_eval.position.diagnosis import Diagnosis
from ins_eval.position.errors import errors, noise_rms, power_on_angles
from ins_eval.position.gyro import Gyro, gyro
from ins_eval.position.leftover import Leftover, leftover
from ins_eval.study.block import Triad
from ins_eval.study.cosimulated import Agreement, agreement, cosimulated, truth
from ins_eval.study.scores.resampling import Estimate, bootstrapped
from ins_eval.trajectories import catalogue
from ins_eval.trajectories.errors import TrajectoryError
from pyhrg.fmu import GyroFmu

Array = NDArray[np.float64]
Say = Callable[[str], None]

MISSIONS = ("car", "aircraft", "ship")
HOURS, TRIADS, SEED = 2.0, 500, 1
"""Unless asked otherwise."""
SAMPLE = 2
"""Triads that are flown for real, in the first mission."""
INTERVAL = 0.02
"""Of their increments, s."""


@dataclass(frozen=True)
class Asked:
    """missions: names or files; hours: of navigation; triads: drawn; seed: of their power-on
    angles and of the intervals."""

    missions: Sequence[str] = MISSIONS
    hours: float = HOURS
    triads: int = TRIADS
    seed: int = SEED


USUAL = Asked()


@dataclass(frozen=True)
class InMission:
    """What a gap is worth in a mission, horizontal, m.

    time: (k,) s since alignment; missed: (k,) rms over power-on angles of what the belief's
    position is from the closed simulation's; at_end: the last of it with its interval;
    before, after: rms of each part of the error at the end, by name, of either gyro;
    leftover: what the rest of the gap could do; None where no held-out test says.
    """

    name: str
    time: Array
    missed: Array
    at_end: Estimate
    before: dict[str, float]
    after: dict[str, float]
    leftover: Leftover | None


@dataclass(frozen=True)
class Position:
    """All missions. sample: what was missed, linear against co-simulated, in the first mission;
    None where nothing was missed."""

    asked: Asked
    diagnosis: Diagnosis
    missions: tuple[InMission, ...]
    sample: Agreement | None


def position(
    fmu: GyroFmu, diagnosis: Diagnosis, asked: Asked = USUAL, say: Say = lambda text: None
) -> Position:
    """Fly the gyros of a diagnosis.

    Args:
        fmu: `HRGSlow`.
        diagnosis: of one gyro.
        asked: missions and numbers.
        say: told how far it is.

    Raises:
        TrajectoryError: no such mission, or hours out of range.
        GyroError: values that the FMU refuses.
    """
    missions = [study_mission(_there(name), asked.hours) for name in asked.missions]
    gyros = gyro(fmu, diagnosis.before), gyro(fmu, diagnosis.after)
    angles = power_on_angles(asked.triads, asked.seed)
    flying = [each.in_flight(angles) for each in gyros]
    found = []
    for mission in missions:
        say(f"position: {mission.name}")
        weights = kept_weights(mission)
        parts = [errors(weights, in_flight) for in_flight in flying]
        found.append(_in_mission(weights, gyros, parts, asked.seed, diagnosis))
    sample = None
    if diagnosis.moved:
        say(f"position: {missions[0].name}, co-simulated")
        sample = _sampled(fmu, missions[0], gyros, angles[:SAMPLE])
    return Position(asked, diagnosis, tuple(found), sample)


def _there(name: str) -> str:
    if not file_of(name).is_file():
        raise TrajectoryError(
            f"{name}: found no such mission, expected {', '.join(catalogue.names())}, or a file"
        )
    return name


def _in_mission(
    weights: MissionWeights,
    gyros: tuple[Gyro, Gyro],
    parts: Sequence[dict[str, Array]],
    seed: int,
    diagnosis: Diagnosis,
) -> InMission:
    missed = _total(parts[1]) - _total(parts[0])
    rest = diagnosis.rest
    return InMission(
        name=weights.name,
        time=weights.time,
        missed=np.array([_rms(missed[:, k]) for k in range(missed.shape[1])]),
        at_end=bootstrapped(_rms, [missed[:, -1]], seed),
        before=_budget(parts[0], noise_rms(weights, gyros[0])),
        after=_budget(parts[1], noise_rms(weights, gyros[1])),
        leftover=None if rest is None else leftover(weights, rest.beyond_noise),
    )


def _budget(parts: dict[str, Array], noise: dict[str, Array]) -> dict[str, float]:
    """Rms at the end, by part."""
    return {
        **{name: float(_rms(part[:, -1])) for name, part in parts.items()},
        **{name: float(rms[-1]) for name, rms in noise.items()},
    }


def _sampled(
    fmu: GyroFmu, mission: StudyMission, gyros: tuple[Gyro, Gyro], angles: Array
) -> Agreement:
    flying, weights = truth(mission, INTERVAL), kept_weights(mission)

    def flown(each: Gyro, start: Array) -> Array:
        triad = Triad((), (), each.flights(start), np.zeros(3), np.zeros(2, dtype=np.uint64))
        return cosimulated(fmu, flying, triad)

    before, after = (np.stack([flown(each, start) for start in angles]) for each in gyros)
    expected = [_total(errors(weights, each.in_flight(angles))) for each in gyros]
    return agreement(expected[1] - expected[0], after - before)


def _total(parts: dict[str, Array]) -> Array:
    return np.asarray(sum(parts.values()))


def _rms(error: Array) -> Array:
    """Over triads, of errors (..., r, 2)."""
    return np.asarray(np.sqrt(np.sum(error**2, axis=-1).mean(axis=-1)))
