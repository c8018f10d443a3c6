"""Shared: a short mission, and a few triads of raw gyros calibrated by the map."""

from pathlib import Path

import pytest

from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.missions import StudyMission, plan_mission
from ins_eval.mission_model.position_errors import TriadBlock
from ins_eval.mission_model.weights_cache import load_mission_weights
from ins_eval.study.gyros.drawn_triad import (
    DrawnTriad,
    TriadDistribution,
    draw_triad,
    make_triad_seed,
    tabulate_triads,
)
from ins_eval.study.gyros.population import RAW
from pyhrg.fmu import GyroFmu

KIND = TriadDistribution(RAW, "map")
SEED = 7


@pytest.fixture(scope="session")
def short() -> StudyMission:
    """Six minutes of the car."""
    return plan_mission("car", 0.1)


@pytest.fixture(scope="session")
def weights(short: StudyMission, tmp_path_factory: pytest.TempPathFactory) -> MissionWeights:
    folder: Path = tmp_path_factory.mktemp("weights")
    return load_mission_weights(short, folder)


@pytest.fixture(scope="session")
def some(slow_fmu: GyroFmu) -> list[DrawnTriad]:
    return [draw_triad(slow_fmu, KIND, make_triad_seed(SEED, number)) for number in range(2)]


@pytest.fixture(scope="session")
def triads(slow_fmu: GyroFmu, some: list[DrawnTriad]) -> TriadBlock:
    return tabulate_triads(slow_fmu, some)
