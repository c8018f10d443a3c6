"""Gyros that are drawn."""

from dataclasses import asdict

import numpy as np
import pytest

from ins_eval.mission_model.gyro_map import TERMS, measure_gyro_map
from ins_eval.study.gyros.population import RAW, TRIMMED, Population
from ins_eval.study.gyros.true_maps import list_slow_parameters
from pyhrg.common.errors import HrgError
from pyhrg.common.units import DEG_PER_H
from pyhrg.fmu import GyroFmu

SIZES = (0.01 * DEG_PER_H, 0.1 * DEG_PER_H)


def test_same_seed_same_gyro() -> None:
    one, same, other = (TRIMMED.draw(np.random.default_rng(seed)) for seed in (1, 1, 2))
    assert one == same
    assert one != other


@pytest.mark.parametrize("population", [TRIMMED, RAW])
def test_maps_are_of_the_stated_size(slow_fmu: GyroFmu, population: Population) -> None:
    """Median rms of 20 gyros' maps, mean apart, within the stated range."""
    generator = np.random.default_rng(3)
    drawn = [population.draw(generator) for _ in range(20)]
    maps = [measure_gyro_map(slow_fmu, list_slow_parameters(device))[1:TERMS] for device in drawn]
    sizes = [np.linalg.norm(each) / np.sqrt(2) for each in maps]
    assert population.smallest < np.median(sizes) < population.largest


def test_gyros_of_one_maker_are_alike_in_shape_not_in_size() -> None:
    """A fifth of a mechanism's variance is left from gyro to gyro, four fifths are in the mean."""
    drawn = {
        common: [
            Population(*SIZES, common=common).draw(np.random.default_rng(seed))
            for seed in range(400)
        ]
        for common in (0.0, 0.8)
    }
    spread = {
        common: np.std([each.drive_frame_rotation for each in gyros])
        for common, gyros in drawn.items()
    }
    assert spread[0.8] / spread[0.0] == pytest.approx(np.sqrt(0.2), rel=0.15)
    assert len({each.bias_instability for each in drawn[0.8]}) == 400


def test_rarer_mechanisms_change_nothing_else() -> None:
    """Neither of the gyro nor of the one that is drawn next; twice as large where they are asked
    for twice."""
    generators = [np.random.default_rng(5) for _ in range(3)]
    drawn = [
        [asdict(Population(*SIZES, rarer=share).draw(each)) for _ in range(2)]
        for share, each in zip((0.0, 1.0, 2.0), generators, strict=True)
    ]
    without, once, twice = (gyros[1] for gyros in drawn)
    moved = {key for key, value in once.items() if value != without[key]}
    assert moved == {
        "electrostatic_cubic",
        "sampling_skew",
        "damping_anisotropy_flicker",
        "pickoff_gain_flicker",
        "phase_flicker",
    }
    assert all(without[key] == 0 and twice[key] == 2 * once[key] for key in moved)


def test_impossible_sizes_are_refused() -> None:
    with pytest.raises(HrgError, match=r"2 to 1 deg/h: expected above 0, the smaller first"):
        Population(2 * DEG_PER_H, DEG_PER_H)
