"""The experiment: reproducible, better than its controls, and as predicted."""

import numpy as np
import pytest

from ins_eval.common.metrics import compute_paired_ratio
from ins_eval.mission_model.missions import StudyMission
from ins_eval.schedules.choice import Planner
from ins_eval.schedules.comparison import CASES, Comparison, Experiment, compare
from ins_eval.study.cosimulated import MissionTruth
from pyhrg.bench.bias.position.full_circumference import SHORTEST
from pyhrg.fmu import GyroFmu

TRIADS, SEED = 2, 4


@pytest.fixture(scope="module")
def experiment(fmu: GyroFmu, planner: Planner, truth: MissionTruth) -> Experiment:
    return Experiment(fmu, planner, truth, plan=SHORTEST)


@pytest.fixture(scope="module")
def flown(experiment: Experiment, mission: StudyMission) -> Comparison:
    """Two triads, 0.1 h."""
    return compare(experiment, mission, TRIADS, SEED, workers=2)


def test_flights_are_as_predicted(flown: Comparison) -> None:
    """Over all triads and cases, whose errors go from 0.3 m to 50 m."""
    ratio = compute_paired_ratio(flown.rms.ravel(), flown.predicted.ravel())
    assert 0.5 < ratio.value < 1.2
    assert np.corrcoef(np.log(flown.rms.ravel()), np.log(flown.predicted.ravel()))[0, 1] > 0.85


def test_the_choice_is_predicted_better_than_its_controls(flown: Comparison) -> None:
    names = [case.name for case in CASES]
    predicted = dict(zip(names, flown.predicted, strict=True))
    for family in ("parking", "indexing", "virtual_rotation"):
        chosen = predicted[f"{family}_chosen"]
        assert np.all(chosen <= predicted[f"{family}_other"])
        assert np.all(chosen <= predicted[f"{family}_random"])
        assert np.all(chosen <= predicted["unscheduled"])
    assert flown.compare("mean", "unscheduled").value > 3


def test_same_seed_same_result_on_any_number_of_workers(
    experiment: Experiment, flown: Comparison
) -> None:
    """The first triad by itself; the control that needs another one aside."""
    alone = experiment.prepare(np.random.SeedSequence(SEED).spawn(1)[0])
    error, predicted, schedules = experiment.fly(alone, alone)
    own = [number for number, case in enumerate(CASES) if not case.name.endswith("other")]
    assert np.array_equal(error[own], flown.error[own, 0])
    assert np.array_equal(predicted[own], flown.predicted[own, 0])
    assert [schedules[number] for number in own] == [flown.schedules[number][0] for number in own]
