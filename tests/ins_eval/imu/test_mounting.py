"""The mounting of three gyros."""

import numpy as np
import pytest

from ins_eval.imu.mounting import ORTHOGONAL, MountingError, make_mounting

SKEWED = make_mounting([[1, 0, 1], [-1, 2, 1], [-1, -2, 1.5]])
VECTORS = np.random.default_rng(1).normal(size=(50, 3))


def test_decoding_undoes_sensing() -> None:
    np.testing.assert_allclose(SKEWED.decode(SKEWED.project(VECTORS)), VECTORS, atol=1e-14)
    np.testing.assert_array_equal(ORTHOGONAL.decode(ORTHOGONAL.project(VECTORS)), VECTORS)


def test_a_gyro_feels_the_component_along_its_axis() -> None:
    np.testing.assert_allclose(SKEWED.project(np.array([[1.0, 0, 1]]))[0, 0], np.sqrt(2))


def test_a_mounting_error_tilts_what_is_decoded() -> None:
    """2000 draws of 1 mrad in two directions: the deviation of each cross coupling, 3.5 sigma."""
    generator = np.random.default_rng(1)
    decode = np.array(
        [
            (lambda m: m.decode(m.project(np.eye(3))))(ORTHOGONAL.disturb(1e-3, generator))
            for _ in range(2000)
        ]
    )
    across = decode[:, ~np.eye(3, dtype=bool)]
    np.testing.assert_allclose(across.std(axis=0), 1e-3, rtol=3.5 / np.sqrt(4000))
    along = decode[:, np.eye(3, dtype=bool)] - 1
    assert np.max(np.abs(along)) < 1e-5


@pytest.mark.parametrize(
    ("axes", "message"),
    [
        ([[1, 0, 0], [0, 1, 0], [1, 1, 0.01]], "condition number .*, expected at most 20"),
        ([[1, 0, 0], [0, 1, 0], [1, 1, 0]], "are they in a plane"),
        ([[1, 0, 0], [0, 0, 0], [0, 0, 1]], "without direction"),
        ([[1, 0, 0], [0, np.nan, 0], [0, 0, 1]], "without direction"),
        ([[1, 0, 0], [0, 1, 0]], r"shape \(2, 3\), expected \(3, 3\)"),
    ],
)
def test_axes_that_span_nothing_are_refused(axes: list[list[float]], message: str) -> None:
    with pytest.raises(MountingError, match=message):
        make_mounting(axes)
