"""All predictors of a block as columns."""

import numpy as np
import pytest

from ins_eval.mission_model.gyro_map import TERMS
from ins_eval.study.predictors import prediction_columns as block
from ins_eval.study.predictors.prediction import SampledPrediction
from ins_eval.study.tables import columns
from tests.ins_eval.study.predictors import cases

TRIADS = cases.triads(seed=2, count=6)
TRAINING = cases.triads(seed=1, count=20)
LEARNT = block.train(TRAINING, *cases.SHEETS)


@pytest.mark.parametrize("k", [0, 1, 2, -1, -3])
def test_one_time_is_that_of_all(k: int) -> None:
    """Flown parts without noise, and predictions, of a time alone and among others."""
    weights = cases.mission(seed=1, times=3)
    one = block.select_time(weights, k)
    assert one.time == weights.time[[k]]
    rules = cases.class_ratios(TRAINING, weights)
    every = block.predict_all(weights, TRIADS, LEARNT, rules, seed=1)
    alone = block.predict_all(one, TRIADS, LEARNT, rules, seed=1)
    assert set(every) == {p.key for p in columns.PREDICTORS}
    for key, prediction in every.items():
        radius = prediction.radius(0.5)[:, [k]]
        np.testing.assert_allclose(alone[key].radius(0.5), radius, rtol=1e-6)


def test_no_such_time() -> None:
    with pytest.raises(IndexError):
        block.select_time(cases.mission(seed=1, times=3), 3)


def test_columns_are_those_of_the_table() -> None:
    weights = cases.mission(seed=1)
    rules = cases.class_ratios(TRAINING, weights)
    predicted = block.predict_all(weights, TRIADS, LEARNT, rules, seed=1)
    table = {
        **block.tabulate_predictions(predicted, 0.9),
        **block.tabulate_rankings(weights, TRIADS),
    }
    kinds = {column.name: column.kind for column in columns.COLUMNS}
    for name, values in table.items():
        assert values.shape == ((6, 3) if kinds[name] == "numbers" else (6,)), name
        assert np.all(np.isfinite(values))


def test_intervals_are_of_the_level_asked() -> None:
    """Half of what is drawn inside 50 %, as much outside on either side."""
    weights = cases.mission(seed=1)
    rules = cases.class_ratios(TRAINING, weights)
    predicted = block.predict_all(weights, TRIADS, LEARNT, rules, seed=1)
    wide, narrow = (block.tabulate_predictions(predicted, inside) for inside in (0.9, 0.5))
    for p in columns.PREDICTORS:
        assert np.all(wide[p.low] < narrow[p.low])
        assert np.all(narrow[p.high] < wide[p.high])
    fitted = predicted["fitted_map"]
    assert isinstance(fitted, SampledPrediction)
    draws = np.linalg.norm(fitted.samples[:, :, 0], axis=-1)
    for name, share in (("fitted_map_low_m", 0.25), ("fitted_map_high_m", 0.75)):
        found = np.mean(draws <= narrow[name][:, None], axis=1)
        np.testing.assert_allclose(found, share, atol=0.001)


def test_turn_ons_that_start_anywhere_show_the_map() -> None:
    """2000 triads, seven turn-ons each: the mean variance is that of the map's harmonics."""
    many = cases.triads(seed=3, count=2000)
    found = np.mean(block.compute_turn_on_scatter(many) ** 2)
    harmonics = np.sum(many.fitted_map[:, 1:TERMS] ** 2, axis=1) / 2
    expected = np.mean(harmonics + many.fixed_repeatability**2)
    assert found == pytest.approx(expected, rel=0.05)
