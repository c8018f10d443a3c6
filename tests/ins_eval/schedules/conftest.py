"""A short mission, and a triad on its bench."""

import pytest

from ins_eval.mission_model.missions import StudyMission, plan_mission
from ins_eval.schedules.choice import Planner
from ins_eval.schedules.knowledge import KnownGyro, bench_gyro
from ins_eval.schedules.weights import compute_mission_response
from ins_eval.study.cosimulated import MissionTruth, sample_truth
from pyhrg.bench.bench import Bench
from pyhrg.bench.bias.position.full_circumference import SHORTEST
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from tests.ins_eval.schedules.triads import draw_quiet_devices


@pytest.fixture(scope="session")
def mission() -> StudyMission:
    return plan_mission("car", 0.1)


@pytest.fixture(scope="session")
def truth(mission: StudyMission) -> MissionTruth:
    return sample_truth(mission)


@pytest.fixture(scope="session")
def planner(mission: StudyMission) -> Planner:
    return Planner(compute_mission_response(mission))


@pytest.fixture(scope="session")
def benches(fmu: GyroFmu) -> list[Bench]:
    """Three gyros of one kind without noise and scatter, seed 3."""
    return [Bench(fmu, device, seed=1) for device in draw_quiet_devices(TYPICAL, 3)]


@pytest.fixture(scope="session")
def gyros(benches: list[Bench]) -> list[KnownGyro]:
    return [bench_gyro(bench, SHORTEST) for bench in benches]
