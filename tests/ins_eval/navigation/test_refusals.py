"""Inputs that the navigator refuses, and its messages."""

from dataclasses import replace

import numpy as np
import pytest

from benchmarks.navigation.weave import Weave
from ins_eval.common.state import State
from ins_eval.navigation.height import Clamped, Free
from ins_eval.navigation.strapdown import check_rotation, navigate
from pyhrg.common.errors import HrgError
from pyhrg.records.imu.log import Increments
from tests.ins_eval.cases import at_rest

START = State(0.5, 0.0, 0.0, np.zeros(3), np.eye(3))
CLAMP = Clamped(np.zeros(5))


def make_four_increments() -> Increments:
    return at_rest(0.5, 0.0, 0.04, np.zeros(3))


@pytest.mark.parametrize("latitude_deg", [90.0, -90.0, 89.6, -95.0, np.nan])
def test_start_at_a_pole(latitude_deg: float) -> None:
    start = replace(START, latitude=np.deg2rad(latitude_deg))
    with pytest.raises(HrgError, match=r"start at latitude .* expected within 89.5 deg"):
        navigate(start, make_four_increments(), CLAMP, 2)


def test_latitude_in_degrees_is_named() -> None:
    with pytest.raises(HrgError, match="is it in degrees where radians are meant"):
        navigate(replace(START, latitude=45.0), make_four_increments(), CLAMP, 2)


def test_velocity_of_another_shape() -> None:
    with pytest.raises(HrgError, match=r"velocity of shape \(2,\): expected \(3,\)"):
        navigate(replace(START, velocity=np.zeros(2)), make_four_increments(), CLAMP, 2)


def test_no_row_to_keep() -> None:
    with pytest.raises(HrgError, match="4 increments and keep_every 6"):
        navigate(START, make_four_increments(), CLAMP, 6)


def test_start_that_is_not_finite() -> None:
    with pytest.raises(HrgError, match=r"start at .*nan.*: expected finite"):
        navigate(
            replace(START, velocity=np.array([0, np.nan, 0])), make_four_increments(), CLAMP, 2
        )


@pytest.mark.parametrize(
    ("matrix", "what"),
    [
        (np.diag([1.0, 1.0, -1.0]), "not a rotation matrix.*determinant -1"),
        (1.01 * np.eye(3), "not a rotation matrix.*differs from 1 by 2.0e-02"),
        (np.full((3, 3), np.nan), "expected a finite 3 x 3"),
        (np.eye(2), "shape .2, 2.*expected a finite 3 x 3"),
    ],
)
def test_attitude_that_is_not_a_rotation_matrix(matrix: np.ndarray, what: str) -> None:
    with pytest.raises(HrgError, match=what):
        navigate(replace(START, mat_nb=matrix), make_four_increments(), CLAMP, 2)


def test_attitude_may_be_a_list() -> None:
    check_rotation(np.eye(3).tolist())  # type: ignore[arg-type]
    with pytest.raises(HrgError, match=r"not a rotation matrix.*determinant -1"):
        check_rotation(np.diag([1.0, 1.0, -1.0]).tolist())  # type: ignore[arg-type]


@pytest.mark.parametrize("value", [np.nan, np.inf])
@pytest.mark.parametrize("sensor", ["rotation", "velocity"])
def test_increment_that_is_not_finite_is_named(sensor: str, value: float) -> None:
    record = make_four_increments()
    getattr(record, sensor)[3, 1] = value
    with pytest.raises(HrgError, match=rf"interval from 0.03 s are .*{value}.*rad and m/s"):
        navigate(START, record, CLAMP, 2)


@pytest.mark.parametrize("interval", [0.0, -0.01, np.nan, np.inf])
def test_interval(interval: float) -> None:
    with pytest.raises(HrgError, match="expected longer than 0 s"):
        navigate(START, replace(make_four_increments(), interval=interval), CLAMP, 2)


def test_increments_of_different_numbers() -> None:
    record = replace(make_four_increments(), velocity=np.zeros((3, 3)))
    with pytest.raises(HrgError, match=r"\(4, 3\) and \(3, 3\): expected \(n, 3\) both"):
        navigate(START, record, CLAMP, 2)


def test_flight_over_the_pole_stops_short_of_it() -> None:
    trajectory = Weave(latitude=np.deg2rad(89.4), swing=0.0).trajectory(120)
    record = trajectory.increments(0.0, 0.1, 1200)
    clamp = Clamped(np.full(1201, 1000.0))
    with pytest.raises(HrgError, match=r"latitude 89.5\d* deg.*too near a pole"):
        navigate(trajectory.state(0.0), record, clamp, 1200)


def test_divergence_asks_for_the_units() -> None:
    """Specific force a million times too large."""
    record = at_rest(0.5, 0.0, 600.0, np.zeros(3))
    record = replace(record, velocity=1e6 * record.velocity)
    with pytest.raises(HrgError, match="diverged; are the increments in rad and m/s"):
        navigate(START, record, Free(), 2)


def test_lists_and_slices_do() -> None:
    """Layout and type of the arrays change nothing."""
    record = at_rest(0.5, 0.0, 0.08, np.array([0.1, 0.2, 0.3]))
    plain = navigate(START, record, Clamped(np.zeros(9)), 2)
    other = replace(
        record,
        rotation=np.asfortranarray(record.rotation),
        velocity=np.repeat(record.velocity, 2, axis=0)[::2],
    )
    again = navigate(START, other, Clamped(np.zeros(9, dtype=int)), 2)
    assert np.array_equal(plain.position, again.position)
    assert np.array_equal(plain.mat_nb, again.mat_nb)


def test_a_start_is_left_as_it_is() -> None:
    """No state leaks from one run to the next."""
    record = at_rest(0.5, 0.0, 1.0, np.array([0.1, 0.2, 0.3]))
    before = record.rotation.copy()
    first, second = (navigate(START, record, Free(), 10) for _ in range(2))
    assert np.array_equal(first.position, second.position)
    assert np.array_equal(record.rotation, before)
    assert np.array_equal(START.mat_nb, np.eye(3))
