"""The study's experiment, one block of triads at a time: gyros are drawn, benched and flown."""

from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import fields, replace
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from fmu_build.bundle import build_fmu
from ins_eval.mission_model.missions import StudyMission, plan_mission
from ins_eval.mission_model.position_errors import PositionErrors, compute_position_errors
from ins_eval.mission_model.triad_block import TriadBlock
from ins_eval.mission_model.weights_cache import load_mission_weights
from ins_eval.study.conditions import CONDITIONS, ConditionSample
from ins_eval.study.cosimulated import cosimulate, sample_truth
from ins_eval.study.gyros.bench_plan import CALIBRATION, BenchPlan
from ins_eval.study.gyros.drawn_triad import (
    DrawnTriad,
    TriadDistribution,
    draw_triad,
    make_triad_seed,
    tabulate_triads,
)
from ins_eval.study.gyros.drift import Drift
from ins_eval.study.gyros.maker import METHODS, Method
from ins_eval.study.gyros.population import RAW, TRIMMED
from ins_eval.study.run.block import Arrays
from ins_eval.study.specification import CONDITION, MEAN, Study
from pyhrg.common.units import MICRO_G
from pyhrg.fmu import GyroFmu

Array = NDArray[np.float64]

DEFAULT_SETTINGS: dict[str, Any] = {
    "trimmed": TRIMMED,
    "raw": RAW,
    "calibration": CALIBRATION,
    "bench": BenchPlan(),
    "drift": Drift(),
}
"""Defaults of the tables of a study file."""
POPULATION_TABLE: dict[Method, str] = {"mean": "trimmed", "map": "raw"}
"""Table of the population that is calibrated by each method: a gyro that is calibrated at the mean
has been trimmed before."""
COSIMULATED = "cosimulated"
NUMBERS, FLOWN = "numbers", "flown"


def make_distribution(study: Study, method: Method) -> TriadDistribution:
    """The distribution from which the triads of a calibration are drawn."""
    own = {name: replace(d, **study.settings.get(name, {})) for name, d in DEFAULT_SETTINGS.items()}
    return TriadDistribution(
        population=own[POPULATION_TABLE[method]],
        method=method,
        calibration=own["calibration"],
        bench=own["bench"],
        drift=own["drift"],
        accelerometer_bias=study.accelerometer_bias_micro_g * MICRO_G,
    )


def compute_block(study: Study, triads: range) -> Arrays:
    """Results of a block of triads by name: the fields of `TriadBlock` for each calibration, and of
    `PositionErrors` for each calibration and mission.

    Args:
        study: the study.
        triads: numbers of the block's triads.
    """
    arrays: dict[str, NDArray[Any]] = {}
    with open_missions(study) as missions:
        for method in list_methods(study):
            drawn = _draw_triads(study, method, triads)
            block = tabulate_triads(load_fmu("HRGSlow"), drawn)
            arrays |= _name_arrays(block, method)
            for number, mission in enumerate(missions):
                path = f"{method}/{number}"
                errors = compute_position_errors(block, load_mission_weights(mission), number)
                arrays |= _name_arrays(errors, path)
                arrays[f"{path}/{COSIMULATED}"] = _cosimulate_sample(study, mission, triads, drawn)
            if method == MEAN:
                arrays |= _fly_conditions(study, dict(zip(triads, drawn, strict=True)), block)
    return arrays


def list_methods(study: Study) -> list[Method]:
    """The calibrations of a study, in the order of `METHODS`."""
    return [method for method in METHODS if method in study.calibrations]


def select_triads(arrays: Arrays, method: Method) -> TriadBlock:
    """The triads of a calibration."""
    return TriadBlock(**_select_fields(TriadBlock, arrays, method))


def select_errors(arrays: Arrays, method: Method, mission: int) -> PositionErrors:
    """Position errors of a calibration's triads in a mission of the study."""
    return PositionErrors(**_select_fields(PositionErrors, arrays, f"{method}/{mission}"))


def select_cosimulated(arrays: Arrays, method: Method, mission: int) -> Array:
    """(r, k, 2) co-simulated errors, m; NaN where a triad was not co-simulated."""
    return arrays[f"{method}/{mission}/{COSIMULATED}"]


def select_condition(arrays: Arrays, place: int) -> tuple[list[int], TriadBlock, PositionErrors]:
    """What flew in a condition of `CONDITIONS`, by its place there: numbers of the triads, the
    triads, their position errors."""
    path = f"{CONDITION}/{place}"
    triads = TriadBlock(**_select_fields(TriadBlock, arrays, path))
    errors = PositionErrors(**_select_fields(PositionErrors, arrays, f"{path}/{FLOWN}"))
    return arrays[f"{CONDITION}/{NUMBERS}"].tolist(), triads, errors


def _select_fields(
    kind: type[TriadBlock | PositionErrors], arrays: Arrays, path: str
) -> dict[str, NDArray[Any]]:
    """Arrays below a path, by the names of a dataclass's fields."""
    return {f.name: arrays[f"{path}/{f.name}"] for f in fields(kind)}


@contextmanager
def open_missions(study: Study) -> Iterator[list[StudyMission]]:
    """Missions of a study; their files exist inside the context."""
    with ExitStack() as stack:
        yield [
            plan_mission(stack.enter_context(mission.as_file()), mission.hours)
            for mission in study.missions
        ]


def prepare(study: Study) -> None:
    """Check the settings, build FMUs, and compute weights that are not in the cache, before workers
    need them.

    Raises:
        HrgError: settings of the study that do not fit together.
    """
    for method in list_methods(study):
        make_distribution(study, method)
    load_fmu("HRGSlow")
    if study.cosimulated:
        load_fmu("HRG")
    with open_missions(study) as missions:
        for mission in missions:
            load_mission_weights(mission)
    if study.conditions:
        for condition in CONDITIONS:
            load_mission_weights(condition.plan(study))


@cache
def load_fmu(root: str) -> GyroFmu:
    """The FMU of a model, built where it does not exist."""
    return GyroFmu(build_fmu(root))


def _draw_triads(study: Study, method: Method, triads: range) -> list[DrawnTriad]:
    fmu, distribution = load_fmu("HRGSlow"), make_distribution(study, method)
    return [draw_triad(fmu, distribution, make_triad_seed(study.seed, n)) for n in triads]


def _fly_conditions(
    study: Study, drawn: dict[int, DrawnTriad], block: TriadBlock
) -> dict[str, NDArray[Any]]:
    """Results of a block's triads that also fly in conditions."""
    sample = {number: each for number, each in drawn.items() if study.is_in_conditions(number)}
    if not sample:
        return {}
    arrays: dict[str, NDArray[Any]] = {f"{CONDITION}/{NUMBERS}": np.array([*sample])}
    rows = [place for place, number in enumerate(drawn) if number in sample]
    whole = ConditionSample(
        study, make_distribution(study, MEAN), load_fmu("HRGSlow"), sample, block.select(rows)
    )
    for place, condition in enumerate(CONDITIONS):
        triads, path = condition.triads(whole), f"{CONDITION}/{place}"
        weights = load_mission_weights(condition.plan(study))
        errors = compute_position_errors(triads, weights, len(study.missions) + place)
        arrays |= _name_arrays(triads, path) | _name_arrays(errors, f"{path}/{FLOWN}")
    return arrays


def _name_arrays(block: TriadBlock | PositionErrors, path: str) -> dict[str, NDArray[Any]]:
    return {f"{path}/{f.name}": getattr(block, f.name) for f in fields(block)}


def _cosimulate_sample(
    study: Study, mission: StudyMission, triads: range, drawn: list[DrawnTriad]
) -> Array:
    """(r, k, 2) co-simulated errors, m; NaN for triads that are not in the sample."""
    errors = np.full((len(triads), len(load_mission_weights(mission).time), 2), np.nan)
    sample = [place for place, number in enumerate(triads) if study.is_cosimulated(number)]
    if sample:
        truth = sample_truth(mission)
        errors[sample] = [cosimulate(load_fmu("HRG"), truth, drawn[place]) for place in sample]
    return errors
