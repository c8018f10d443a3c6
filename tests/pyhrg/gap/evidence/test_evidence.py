"""Evidence against integrals by quadrature, in one and two dimensions."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import quad

from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.catalogue import EFFECTS
from pyhrg.gap.evidence.evidence import MAX_PRIOR_SIZE_SIGMA, find_equivalents, fit
from tests.pyhrg.gap.made_up import design_of

ONE, OTHER, THIRD = (
    EFFECTS[name] for name in ("drive_gain_mismatch", "pickoff_gain_mismatch", "loop_delay")
)
AXIS = EFFECTS["damping_anisotropy"]


def rng() -> np.random.Generator:
    return np.random.default_rng(8)


@pytest.mark.parametrize("size", [4.0, 8.0, 40.0])
def test_one_dimension(size: float) -> None:
    """Mean likelihood ratio over sizes of both signs, flat in the logarithm from 1, and less beyond
    the typical size."""
    column = rng().normal(size=200) * 1e3
    unit = column / np.linalg.norm(column)
    found = fit(design_of({ONE: column[:, None]}, size * unit), [ONE])
    assert found is not None

    def integrand(x: float) -> float:
        density = 1 / (2 * abs(x) * np.log(MAX_PRIOR_SIZE_SIGMA))
        typical = 1 / (1 + abs(x) / np.linalg.norm(column) / ONE.scale)
        return float(np.exp(-((x - size) ** 2) / 2) * density * typical)

    near = quad(integrand, max(1.0, size - 12), size + 12, epsabs=0)[0]
    # Laplace's next order of a density that falls with the square of the size is 3 / size^2
    expected = size**2 / 2 + np.log(near)
    assert found.log_evidence == pytest.approx(expected, abs=4 / size**2)
    assert found.values[0][0] == pytest.approx(size / np.linalg.norm(column))
    assert found.covariances[0][0, 0] == pytest.approx(1 / np.linalg.norm(column) ** 2)


@pytest.mark.parametrize("size", [6.0, 30.0])
def test_two_dimensions(size: float) -> None:
    """Flat in direction in the effect's own unit. Laplace's next order of a density that falls with
    the cube of the length is at most 4.5 variances of the widest direction over its square."""
    columns = rng().normal(size=(300, 2)) @ np.array([[1.0, 0.6], [0.0, 0.5]])
    basis, triangle = np.linalg.qr(columns)
    found = fit(design_of({AXIS: columns}, size * basis[:, 0]), [AXIS])
    assert found is not None
    edge = np.arange(-12, 12, 0.05) + 0.025
    x, y = np.meshgrid(edge + size, edge)
    lengths = np.linalg.norm(np.linalg.solve(triangle, [x.ravel(), y.ravel()]), axis=0)
    typical = 1 / (1 + lengths.reshape(x.shape) / AXIS.scale)
    flat = 1 / (2 * np.pi * lengths.reshape(x.shape) ** 2 * np.log(MAX_PRIOR_SIZE_SIGMA))
    density = np.where(np.hypot(x, y) > 1, flat * typical, 0.0) / abs(np.linalg.det(triangle))
    integral = (np.exp(-((x - size) ** 2 + y**2) / 2) * density).sum() * 0.05**2
    expected = size**2 / 2 + np.log(integral)
    widest = np.linalg.norm(np.linalg.inv(triangle), 2) / np.linalg.norm(found.values[0])
    assert found.log_evidence == pytest.approx(expected, abs=4.5 * widest**2)
    np.testing.assert_allclose(found.values[0], np.linalg.solve(triangle, [size, 0.0]), atol=1e-9)


def test_units_do_not_matter() -> None:
    columns, residual = rng().normal(size=(100, 3)), rng().normal(size=100) * 3
    logs = []
    for scale in (1.0, 1e-7):
        same = replace(ONE, scale=ONE.scale / scale)
        design = design_of({same: columns[:, :1] * scale, AXIS: columns[:, 1:]}, residual)
        found = fit(design, [same, AXIS])
        assert found is not None
        logs.append(found.log_evidence)
    assert logs[0] == pytest.approx(logs[1], rel=1e-9)


def test_the_same_column_twice_is_not_fitted() -> None:
    column = rng().normal(size=(100, 1))
    design = design_of({ONE: column, OTHER: 3 * column}, column[:, 0])
    assert fit(design, [ONE, OTHER]) is None


def test_a_small_difference_of_two_candidate_terms_is_not_fitted() -> None:
    column, other = rng().normal(size=(2, 400, 1))
    near = column + 0.02 * other
    rough = CandidateTerm("gyro_angle", "rate", "rate")
    residual = 10 * (column - near)[:, 0]
    assert fit(design_of({ONE: column, OTHER: near}, residual), [ONE, OTHER]) is not None
    assert fit(design_of({ONE: column, rough: near}, residual), [rough, ONE]) is None


def test_equivalents_are_columns_that_are_collinear() -> None:
    column, other = rng().normal(size=(2, 400, 1))
    design = design_of({ONE: column, OTHER: -5 * column, THIRD: other}, 2 * column[:, 0])
    best = fit(design, [ONE])
    assert best is not None
    assert list(find_equivalents(design, best, ONE, [ONE, OTHER, THIRD])) == [OTHER]
    nothing = design_of({ONE: column, OTHER: other, THIRD: column[::-1]}, 2 * column[:, 0])
    best = fit(nothing, [ONE])
    assert best is not None
    assert not find_equivalents(nothing, best, ONE, [ONE, OTHER, THIRD])
