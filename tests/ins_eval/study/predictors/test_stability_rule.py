"""The rule in its own words."""

import numpy as np
import pytest

from ins_eval.study.predictors import stability_rule
from pyhrg.common.units import DEG_PER_H, HOUR, NAUTICAL_MILE


def test_a_hundredth_of_a_degree_an_hour_is_a_mile_an_hour() -> None:
    found = stability_rule.predict(np.full((1, 3), 0.01 * DEG_PER_H), HOUR * np.array([1.0, 2.0]))
    np.testing.assert_allclose(found.radius(0.5), NAUTICAL_MILE * np.array([[1.0, 2.0]]))


def test_a_triad_counts_with_its_root_mean_square() -> None:
    stability = np.array([[1.0, 2.0, 2.0]]) * DEG_PER_H
    same = np.full((1, 3), np.sqrt(3.0)) * DEG_PER_H
    radii = [stability_rule.predict(s, np.array([HOUR])).radius(0.9) for s in (stability, same)]
    assert radii[0] == pytest.approx(radii[1])
