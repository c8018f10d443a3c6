"""The study's experiment, a block of triads at a time: built, benched, flown."""

from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import fields, replace
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from fmu_build.bundle import built_fmu
from fmu_build.roots import ROOTS
from ins_eval.mission_model.flown import Flown, flown
from ins_eval.mission_model.missions import StudyMission, study_mission
from ins_eval.mission_model.triads import Triads
from ins_eval.mission_model.weights_cache import kept_weights
from ins_eval.study.block import Kind, Triad, gathered, triad, triad_seed
from ins_eval.study.conditions import CONDITIONS, Sample
from ins_eval.study.cosimulated import cosimulated, truth
from ins_eval.study.gyros.bench_plan import CALIBRATION, BenchPlan
from ins_eval.study.gyros.drift import Drift
from ins_eval.study.gyros.maker import METHODS, Method
from ins_eval.study.gyros.population import RAW, TRIMMED
from ins_eval.study.run.block import Arrays
from ins_eval.study.specification import CONDITION, MEAN, Study
from pyhrg.common.units import MICRO_G
from pyhrg.fmu import GyroFmu

Array = NDArray[np.float64]

DEFAULTS: dict[str, Any] = {
    "trimmed": TRIMMED,
    "raw": RAW,
    "calibration": CALIBRATION,
    "bench": BenchPlan(),
    "drift": Drift(),
}
"""By table of a study file."""
POPULATION: dict[Method, str] = {"mean": "trimmed", "map": "raw"}
"""What a maker calibrates by its mean has been trimmed."""
COSIMULATED = "cosimulated"
NUMBERS, FLOWN = "numbers", "flown"


def kind(study: Study, method: Method) -> Kind:
    """What the triads of a calibration are drawn from."""
    own = {name: replace(d, **study.settings.get(name, {})) for name, d in DEFAULTS.items()}
    return Kind(
        population=own[POPULATION[method]],
        method=method,
        calibration=own["calibration"],
        bench=own["bench"],
        drift=own["drift"],
        accelerometer_bias=study.accelerometer_bias_micro_g * MICRO_G,
    )


def made(study: Study, triads: range) -> Arrays:
    """All of a block's triads by name: `Triads`, and `Flown` in each mission."""
    arrays: dict[str, NDArray[Any]] = {}
    with missions(study) as flying:
        for method in methods(study):
            drawn = _drawn(study, method, triads)
            block = gathered(fmu("HRGSlow"), drawn)
            arrays |= _named(block, method)
            for number, mission in enumerate(flying):
                path = f"{method}/{number}"
                arrays |= _named(flown(block, kept_weights(mission), number), path)
                arrays[f"{path}/{COSIMULATED}"] = _sample(study, mission, triads, drawn)
            if method == MEAN:
                arrays |= _in_conditions(study, dict(zip(triads, drawn, strict=True)), block)
    return arrays


def methods(study: Study) -> list[Method]:
    """Its calibrations."""
    return [method for method in METHODS if method in study.calibrations]


def triads_of(arrays: Arrays, method: Method) -> Triads:
    """Of a calibration."""
    return Triads(**{f.name: arrays[f"{method}/{f.name}"] for f in fields(Triads)})


def flown_of(arrays: Arrays, method: Method, mission: int) -> Flown:
    """Of a calibration, in a mission of the study."""
    return Flown(**{f.name: arrays[f"{method}/{mission}/{f.name}"] for f in fields(Flown)})


def cosimulated_of(arrays: Arrays, method: Method, mission: int) -> Array:
    """(r, k, 2) m; NaN where it wasn't done."""
    return arrays[f"{method}/{mission}/{COSIMULATED}"]


def in_condition(arrays: Arrays, place: int) -> tuple[list[int], Triads, Flown]:
    """Numbers of the triads that flew in a condition, by its place in `CONDITIONS`; the triads;
    their flights."""
    path = f"{CONDITION}/{place}"
    triads = Triads(**{f.name: arrays[f"{path}/{f.name}"] for f in fields(Triads)})
    flights = Flown(**{f.name: arrays[f"{path}/{FLOWN}/{f.name}"] for f in fields(Flown)})
    return arrays[f"{CONDITION}/{NUMBERS}"].tolist(), triads, flights


@contextmanager
def missions(study: Study) -> Iterator[list[StudyMission]]:
    """Of a study, as files while this lasts."""
    with ExitStack() as stack:
        yield [
            study_mission(stack.enter_context(mission.placed()), mission.hours)
            for mission in study.missions
        ]


def prepare(study: Study) -> None:
    """Build FMUs, and make weights of missions that aren't kept."""
    fmu("HRGSlow")
    if study.cosimulated:
        fmu("HRG")
    with missions(study) as flying:
        for mission in flying:
            kept_weights(mission)
    if study.conditions:
        for condition in CONDITIONS:
            kept_weights(condition.flying(study))


@cache
def fmu(root: str) -> GyroFmu:
    """Of a model, built if it isn't there."""
    return GyroFmu(built_fmu(root=ROOTS[root]))


def _drawn(study: Study, method: Method, triads: range) -> list[Triad]:
    own = kind(study, method)
    return [triad(fmu("HRGSlow"), own, triad_seed(study.seed, number)) for number in triads]


def _in_conditions(study: Study, drawn: dict[int, Triad], block: Triads) -> dict[str, NDArray[Any]]:
    """Of those of a block's triads that fly in conditions."""
    sample = {number: each for number, each in drawn.items() if study.is_in_conditions(number)}
    if not sample:
        return {}
    arrays: dict[str, NDArray[Any]] = {f"{CONDITION}/{NUMBERS}": np.array([*sample])}
    rows = [place for place, number in enumerate(drawn) if number in sample]
    whole = Sample(study, kind(study, MEAN), fmu("HRGSlow"), sample, block.chosen(rows))
    for place, condition in enumerate(CONDITIONS):
        triads, path = condition.triads(whole), f"{CONDITION}/{place}"
        weights = kept_weights(condition.flying(study))
        noise = len(study.missions) + place
        arrays |= _named(triads, path)
        arrays |= _named(flown(triads, weights, noise), f"{path}/{FLOWN}")
    return arrays


def _named(block: Triads | Flown, path: str) -> dict[str, NDArray[Any]]:
    return {f"{path}/{f.name}": getattr(block, f.name) for f in fields(block)}


def _sample(study: Study, mission: StudyMission, triads: range, drawn: list[Triad]) -> Array:
    """(r, k, 2) m; NaN but for the sample."""
    errors = np.full((len(triads), len(kept_weights(mission).time), 2), np.nan)
    chosen = [place for place, number in enumerate(triads) if study.is_cosimulated(number)]
    if chosen:
        flying = truth(mission)
        errors[chosen] = [cosimulated(fmu("HRG"), flying, drawn[place]) for place in chosen]
    return errors
