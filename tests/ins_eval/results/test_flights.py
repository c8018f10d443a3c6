"""Labelled arrays of flights."""

import numpy as np
import pytest

from ins_eval.common.state import track_error
from ins_eval.results import flights, quantities
from tests.ins_eval.results.cases import covariance, dataset, track


def test_errors_are_the_tracks_errors() -> None:
    data = dataset(runs=2)
    error = track_error(track(10.0, 20.0, 0.3 + 1e-4), track(10.0, 0.0))
    second = data.sel(run=2)
    np.testing.assert_array_equal(second["north_error"], error.position[:, 0])
    np.testing.assert_array_equal(second["heading_error"], np.rad2deg(error.attitude[:, 2]))
    assert second["north_error"].values == pytest.approx(20.0, rel=1e-3)
    assert second["heading_error"].values == pytest.approx(np.rad2deg(1e-4), rel=1e-4)


def test_radial_error_joins_north_and_east() -> None:
    data = dataset()
    expected = np.hypot(data["north_error"], data["east_error"])
    np.testing.assert_array_equal(data["radial_error"], expected)


def test_sigmas_are_roots_of_variances_in_the_units_they_are_labelled_with() -> None:
    data = flights.tabulate_sigmas(track(0.0, 0.0).time, covariance())
    assert float(data["east_sigma"][0]) == pytest.approx(np.sqrt(2))
    assert float(data["heading_sigma"][0]) == pytest.approx(np.rad2deg(3.0))
    assert float(data["north_east_covariance"][1]) == pytest.approx(np.sqrt(2))
    assert data["heading_sigma"].attrs["units"] == "deg"


def test_every_variable_is_a_known_quantity_with_its_unit() -> None:
    data = dataset()
    for name, variable in data.variables.items():
        assert variable.attrs["units"] == quantities.BY_NAME[str(name)].unit
    assert set(data.variables) == set(quantities.BY_NAME)


def test_longitude_and_heading_stay_in_their_ranges() -> None:
    data = dataset(longitude_deg=177.0)
    assert data["longitude"].min() < -179
    assert data["longitude"].max() < 180
    west = flights.tabulate_navigated([track(0.0, 0.0, yaw=-0.5)])
    assert west["heading"].values == pytest.approx(360 - np.rad2deg(0.5))


def test_tracks_of_other_times_are_refused() -> None:
    truth = track(0.0, 0.0)
    later = track(0.0, 0.0)
    later.time[:] += 1.0
    with pytest.raises(ValueError, match="expected the same times"):
        flights.compare_with_truth([later], truth)
