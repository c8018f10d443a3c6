"""The study's experiment, one block of triads at a time: gyros are drawn, benched and flown."""

from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import fields, replace
from functools import cache, lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from fmu_build.bundle import build_fmu
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.missions import StudyMission, plan_mission
from ins_eval.mission_model.position_errors import (
    PositionErrors,
    TriadBlock,
    compute_linear_position_errors,
)
from ins_eval.mission_model.weights_cache import load_mission_weights
from ins_eval.study import lead
from ins_eval.study.conditions import CONDITIONS, ConditionSample
from ins_eval.study.cosimulated import MissionTruth, cosimulate, sample_truth, seed_noise
from ins_eval.study.gyros.bench_plan import CALIBRATION, BenchPlan
from ins_eval.study.gyros.drawn_triad import (
    DrawnTriad,
    TriadDistribution,
    draw_triad,
    make_triad_seed,
    tabulate_triads,
)
from ins_eval.study.gyros.drift import Drift
from ins_eval.study.gyros.makers_calibration import METHODS, Method
from ins_eval.study.gyros.population import RAW, TRIMMED
from ins_eval.study.predictors.prediction_columns import select_time
from ins_eval.study.run.block import Arrays
from ins_eval.study.specification import CONDITION, MEAN, TEST, PlannedMission, Study
from ins_eval.study.witness.believed import BelievedGyro
from ins_eval.study.witness.block import believe_triad, witness_triads
from ins_eval.trajectories.catalogue import find_mission_file
from pyhrg.common.arrays import Array
from pyhrg.fmu import GyroFmu

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
COSIMULATED, NOISELESS, STEADY_LOOPS = "cosimulated", "noiseless", "steady_loops"
"""Names of nonlinear flights: with all noise; without noise; without noise, by `HRGSlow`, whose
loops are in their steady state."""
NUMBERS, FLOWN = "numbers", "flown"
LEAD = "lead"
WITNESS = "witness"
Witnessed = dict[int, tuple[DrawnTriad, list[BelievedGyro]]]
"""Triads whose channels are read, by number."""
TRUTHS_KEPT = 10
"""Number of missions whose truth a process keeps; two hours of one take 100 MB. Chosen: those of
`standard`, so that no block computes one again."""


def make_distribution(study: Study, method: Method) -> TriadDistribution:
    own = {name: replace(d, **study.settings.get(name, {})) for name, d in DEFAULT_SETTINGS.items()}
    return TriadDistribution(
        population=own[POPULATION_TABLE[method]],
        method=method,
        calibration=own["calibration"],
        bench=own["bench"],
        drift=own["drift"],
        accelerometer_bias=study.accelerometer_bias,
        mounting=study.mounting,
    )


def compute_block(study: Study, triads: range) -> Arrays:
    """Results of a block of triads by name: the fields of `TriadBlock` for each calibration; for
    each calibration and mission the fields of `PositionErrors`, by the linear model, and the errors
    of the co-simulations.
    """
    arrays: dict[str, NDArray[Any]] = {}
    drawn = {method: _draw_triads(study, method, triads) for method in list_methods(study)}
    blocks = {m: tabulate_triads(load_fmu("HRGSlow"), each) for m, each in drawn.items()}
    for method, block in blocks.items():
        arrays |= _name_arrays(block, method)
    believed = {m: _believe_triads(study, m, triads, each) for m, each in drawn.items()}
    with open_missions(study) as missions:
        for number, mission in enumerate(missions):
            weights = load_mission_weights(mission)
            for method, block in blocks.items():
                path = f"{method}/{number}"
                arrays |= _witness(study, method, number, triads, believed[method], weights)
                arrays |= _name_arrays(compute_linear_position_errors(block, weights, number), path)
                flown = _cosimulate_triads(
                    study, number, dict(zip(triads, drawn[method], strict=True))
                )
                for name, errors in flown.items():
                    arrays[f"{path}/{name}"] = _fill_block(triads, errors, len(weights.time))
    if MEAN in blocks:
        arrays |= _fly_conditions(study, dict(zip(triads, drawn[MEAN], strict=True)), blocks[MEAN])
    return arrays | _fly_lead(study, triads)


def list_methods(study: Study) -> list[Method]:
    return [method for method in METHODS if method in study.calibrations]


def select_triads(arrays: Arrays, method: Method) -> TriadBlock:
    return TriadBlock(**_select_fields(TriadBlock, arrays, method))


def select_errors(arrays: Arrays, method: Method, mission: int) -> PositionErrors:
    """Position errors of a calibration's triads in a mission of the study."""
    return PositionErrors(**_select_fields(PositionErrors, arrays, f"{method}/{mission}"))


def select_cosimulated(
    arrays: Arrays, method: Method, mission: int, name: str = COSIMULATED
) -> Array:
    """(r, k, 2) co-simulated errors, m; NaN where a triad was not co-simulated.

    Args:
        arrays, method, mission: as in `select_errors`.
        name: `COSIMULATED`, `NOISELESS` or `STEADY_LOOPS`.
    """
    return arrays[f"{method}/{mission}/{name}"]


def select_witnesses(arrays: Arrays, method: Method, mission: int) -> dict[str, Array]:
    """(r, self-tests, ...) fields of `WitnessedFlight`; NaN where a triad was not witnessed."""
    path = f"{method}/{mission}/{WITNESS}/"
    return {k.removeprefix(path): v for k, v in arrays.items() if k.startswith(path)}


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
    load_fmu("HRG")
    with open_missions(study) as missions:
        for mission in missions:
            load_mission_weights(mission)
    if study.conditions:
        for condition in CONDITIONS:
            load_mission_weights(condition.plan(study))


@lru_cache(maxsize=TRUTHS_KEPT)
def load_truth(file_name: str, content: bytes, hours: float) -> MissionTruth:
    """The truth of a mission, by its file, for these hours; kept in this process."""
    mission = PlannedMission(
        name="", mission_class="", hours=hours, file_name=file_name, content=content
    )
    with mission.as_file() as path:
        return sample_truth(plan_mission(path, hours))


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
    sample = {
        number: each
        for number, each in drawn.items()
        if study.is_in_sample(number, study.conditions)
    }
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
        errors = compute_linear_position_errors(triads, weights, len(study.missions) + place)
        arrays |= _name_arrays(triads, path) | _name_arrays(errors, f"{path}/{FLOWN}")
    return arrays


def _name_arrays(block: TriadBlock | PositionErrors, path: str) -> dict[str, NDArray[Any]]:
    return {f"{path}/{f.name}": getattr(block, f.name) for f in fields(block)}


def _cosimulate_triads(
    study: Study, number: int, drawn: dict[int, DrawnTriad]
) -> dict[str, dict[int, Array]]:
    """(k, 2) co-simulated errors, m, of triads by number, in a mission of the study: with noise of
    those that are judged, without noise of the samples for the agreement."""
    flown: dict[str, dict[int, Array]] = {COSIMULATED: {}, NOISELESS: {}, STEADY_LOOPS: {}}
    mission = study.missions[number]
    for triad, each in drawn.items():
        if study.role_of(triad) == TEST:
            noise = seed_noise(each, number)
            truth = load_truth(mission.file_name, mission.content, mission.hours)
            flown[COSIMULATED][triad] = cosimulate(load_fmu("HRG"), truth, each, noise)
            if study.is_in_sample(triad, study.agreement):
                flown[NOISELESS][triad] = cosimulate(load_fmu("HRG"), truth, each)
            if study.is_in_sample(triad, study.steady_agreement):
                flown[STEADY_LOOPS][triad] = cosimulate(load_fmu("HRGSlow"), truth, each)
    return flown


def _believe_triads(
    study: Study, method: Method, triads: range, drawn: list[DrawnTriad]
) -> Witnessed:
    """The triads of a block whose channels are read in flight, by number."""
    fmu, distribution = load_fmu("HRGSlow"), make_distribution(study, method)
    return {
        number: (each, believe_triad(fmu, distribution, each))
        for number, each in zip(triads, drawn, strict=True)
        if study.is_in_sample(number, study.witnessed)
    }


def _witness(
    study: Study, method: Method, number: int, triads: range, believed: Witnessed,
    weights: MissionWeights,
) -> dict[str, NDArray[Any]]:  # fmt: skip
    """Estimates from the channels in a mission of the study."""
    if not study.witnessed:
        return {}
    flown = study.missions[number]
    truth = load_truth(flown.file_name, flown.content, flown.hours)
    fmus, end = (load_fmu("HRG"), load_fmu("HRGSlow")), select_time(weights, -1)
    estimates = witness_triads(fmus, truth, end, number, believed, triads)
    return {f"{method}/{number}/{WITNESS}/{name}": values for name, values in estimates.items()}


def _fill_block(triads: range, errors: dict[int, Array], times: int) -> Array:
    """(r, times, 2) errors of a block's triads, NaN where there are none."""
    return np.stack([errors.get(triad, np.full((times, 2), np.nan)) for triad in triads])


def _fly_lead(study: Study, triads: range) -> dict[str, NDArray[Any]]:
    """Flights of the lead case that a block makes: those with the numbers of its triads."""
    numbers = [number for number in triads if number < study.lead]
    if not numbers:
        return {}
    slow, seed = load_fmu("HRGSlow"), study.seed
    path = find_mission_file(lead.MISSION)
    truth = load_truth(path.name, path.read_bytes(), lead.HOURS)
    errors, angles = lead.fly_lead(slow, load_fmu("HRG"), truth, seed, numbers, study.lead)
    arrays = {f"{LEAD}/{FLOWN}": errors, f"{LEAD}/angle": angles}
    if 0 in numbers:
        arrays[f"{LEAD}/bench"] = lead.bench_lead(slow, seed)[None]
    return arrays
