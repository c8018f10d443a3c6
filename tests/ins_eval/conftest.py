"""Shared: a short mission, and a few triads of raw gyros calibrated by the map."""

from pathlib import Path

import pytest

from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.missions import StudyMission, study_mission
from ins_eval.mission_model.triads import Triads
from ins_eval.mission_model.weights_cache import kept_weights
from ins_eval.study.block import Kind, Triad, gathered, triad, triad_seed
from ins_eval.study.gyros.population import RAW
from pyhrg.fmu import GyroFmu

KIND = Kind(RAW, "map")
SEED = 7


@pytest.fixture(scope="session")
def short() -> StudyMission:
    """Six minutes of the car."""
    return study_mission("car", 0.1)


@pytest.fixture(scope="session")
def weights(short: StudyMission, tmp_path_factory: pytest.TempPathFactory) -> MissionWeights:
    folder: Path = tmp_path_factory.mktemp("weights")
    return kept_weights(short, folder)


@pytest.fixture(scope="session")
def some(slow_fmu: GyroFmu) -> list[Triad]:
    return [triad(slow_fmu, KIND, triad_seed(SEED, number)) for number in range(2)]


@pytest.fixture(scope="session")
def triads(slow_fmu: GyroFmu, some: list[Triad]) -> Triads:
    return gathered(slow_fmu, some)
