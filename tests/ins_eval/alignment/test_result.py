"""The result in readable form."""

from dataclasses import replace

import numpy as np
import pytest

from ins_eval.alignment.align import align
from ins_eval.alignment.result import Alignment, History, euler_from_rotation_vector
from ins_eval.common.rotation import euler_from_mat, mat_from_euler
from ins_eval.common.sensor_errors import SensorErrors
from pyhrg.common.errors import HrgError
from pyhrg.common.units import DEG, DEG_PER_H
from tests.ins_eval.cases import at_rest


def make_alignment(mat_nb: np.ndarray, covariance: np.ndarray) -> Alignment:
    history = History(np.array([300.0]), mat_nb[None], covariance[None], np.zeros((1, 2)))
    return Alignment(300.0, mat_nb, covariance, history, 0.0)


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_euler_angles_change_as_the_matrix_says(axis: int) -> None:
    mat_nb = mat_from_euler(*map(np.array, (0.3, -0.4, 2.0)))
    turn = np.zeros(3)
    turn[axis] = 1e-6
    x, y, z = turn
    turned = (np.eye(3) + np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])) @ mat_nb
    change = np.subtract(euler_from_mat(turned), euler_from_mat(mat_nb))
    assert change == pytest.approx(euler_from_rotation_vector(mat_nb) @ turn, abs=1e-11)


def test_readable_form_is_in_degrees_with_heading_from_0_to_360() -> None:
    mat_nb = mat_from_euler(*map(np.array, (1 * DEG, 2 * DEG, -90 * DEG)))
    result = make_alignment(mat_nb, np.diag([0.01, 0.01, 0.1]) ** 2 * DEG**2)
    assert str(result).startswith("heading 270.0000 +- 0.1000 deg, pitch 2.0000 +- 0.0100 deg")


def test_a_still_vehicle_is_aligned_with_the_sigma_of_its_east_gyro() -> None:
    errors = SensorErrors(gyro_bias=0.01 * DEG_PER_H)
    record = at_rest(40 * DEG, 0.0, 60, np.zeros(3), yaw=1.0)
    result = align(record, np.array([40 * DEG, 0.0, 0.0]), errors)
    assert result.heading_deg == pytest.approx(1.0 / DEG, abs=1e-3)
    assert result.euler_sigma_deg[2] == pytest.approx(
        0.01 / 15.041 / np.cos(40 * DEG) / DEG, rel=1e-3
    )


@pytest.mark.parametrize("side", [-1, 1])
def test_heading_and_roll_of_a_nose_along_the_vertical_are_refused(side: int) -> None:
    """89.5 deg; at 88.5 deg they are stated."""

    def pitched(pitch_deg: float) -> Alignment:
        mat_nb = mat_from_euler(*map(np.array, (0.1, side * pitch_deg * DEG, 0.5)))
        return make_alignment(mat_nb, 1e-8 * np.eye(3))

    vertical = pitched(89.5)
    assert vertical.pitch_deg == pytest.approx(side * 89.5)
    for name in ("heading_deg", "roll_deg", "euler_sigma_deg", "__str__"):
        with pytest.raises(HrgError, match=r"pitch -?89.5 deg: heading and roll are one rotation"):
            getattr(vertical, name)()
    assert pitched(88.5).heading_deg == pytest.approx(0.5 / DEG)


def test_a_nose_along_the_vertical_is_aligned_all_the_same() -> None:
    errors = SensorErrors(gyro_bias=0.01 * DEG_PER_H)
    level = at_rest(40 * DEG, 0.0, 60, np.zeros(3), yaw=1.0)
    upward = mat_from_euler(*map(np.array, (0.0, 90 * DEG, 0.0)))
    record = replace(level, rotation=level.rotation @ upward, velocity=level.velocity @ upward)
    place = np.array([40 * DEG, 0.0, 0.0])
    result = align(record, place, errors)
    assert result.mat_nb == pytest.approx(align(level, place, errors).mat_nb @ upward, abs=1e-6)
    with pytest.raises(HrgError, match="are one rotation"):
        str(result)
