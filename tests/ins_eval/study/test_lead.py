"""The lead case: the paper's promises, and start angles that are spread."""

import numpy as np

from ins_eval.mission_model.missions import StudyMission
from ins_eval.study.cosimulated import sample_truth
from ins_eval.study.lead import bench_lead, fly_lead, spread_angles
from pyhrg.common.units import DEG_PER_H
from pyhrg.fmu import GyroFmu


def test_bench_shows_the_papers_figures(slow_fmu: GyroFmu) -> None:
    """Table 2: 0.0009 and 0.1 deg/h, within 10 %."""
    fixed, circumference = bench_lead(slow_fmu, seed=1) / DEG_PER_H
    np.testing.assert_allclose([fixed, circumference], [0.0009, 0.1], rtol=0.1)


def test_start_angles_are_spread_over_half_a_turn() -> None:
    """Each sixteenth has one, for each axis; axes are apart."""
    angles = spread_angles(seed=1, count=16)
    for axis in angles.T:
        assert sorted((16 * axis / np.pi).astype(int)) == list(range(16))
    assert not np.allclose(angles[:, 0], angles[:, 1])


def test_flight_is_its_number(fmu: GyroFmu, slow_fmu: GyroFmu, short: StudyMission) -> None:
    """In whatever block it is flown."""
    truth = sample_truth(short)
    both, angles = fly_lead(slow_fmu, fmu, truth, 1, [0, 1], 4)
    alone, _ = fly_lead(slow_fmu, fmu, truth, 1, [1], 4)
    np.testing.assert_array_equal(both[1:], alone)
    assert angles.shape == (2, 3)
    assert not np.allclose(both[0], both[1])
