"""Gyros that are drawn."""

import numpy as np
import pytest

from ins_eval.mission_model.gyro_map import measure_gyro_map
from ins_eval.study.gyros.population import RAW, TRIMMED, Population
from ins_eval.study.gyros.true_maps import list_slow_parameters
from pyhrg.common.errors import HrgError
from pyhrg.common.units import DEG_PER_H
from pyhrg.fmu import GyroFmu


def test_same_seed_same_gyro() -> None:
    one, same, other = (TRIMMED.draw(np.random.default_rng(seed)) for seed in (1, 1, 2))
    assert one == same
    assert one != other


@pytest.mark.parametrize("population", [TRIMMED, RAW])
def test_maps_are_of_the_stated_size(slow_fmu: GyroFmu, population: Population) -> None:
    """Median rms of 20 gyros' maps, mean apart, within the stated range."""
    generator = np.random.default_rng(3)
    drawn = [population.draw(generator) for _ in range(20)]
    maps = [measure_gyro_map(slow_fmu, list_slow_parameters(device)).bias[1:] for device in drawn]
    sizes = [np.linalg.norm(each) / np.sqrt(2) for each in maps]
    assert population.smallest < np.median(sizes) < population.largest


def test_impossible_sizes_are_refused() -> None:
    with pytest.raises(HrgError, match=r"2 to 1 deg/h: expected above 0, the smaller first"):
        Population(2 * DEG_PER_H, DEG_PER_H)
