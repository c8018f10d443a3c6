"""Parameters known within a tolerance, against least squares with a dense covariance."""

import numpy as np
import pytest

from pyhrg.gap.effects.catalogue import EFFECTS
from pyhrg.gap.effects.known_parameters import KnownParameters
from pyhrg.gap.evidence.evidence import fit
from tests.pyhrg.gap.made_up import design_of

ROTATION, LATITUDE, RUN_OUT = (
    EFFECTS[name] for name in ("drive_frame_rotation", "site_latitude", "encoder_eccentricity")
)
ROWS = 200


@pytest.mark.parametrize("tolerance", [0.03, 3.0, 300.0])
def test_a_known_parameter_may_be_beyond_its_tolerance(tolerance: float) -> None:
    """As a group it is fitted as if nothing were known of it; all other sets face its tolerance.
    Tolerances are in sigma of these rows."""
    draws = np.random.default_rng(1).normal(size=(ROWS, 5))
    columns = {ROTATION: draws[:, :1], LATITUDE: draws[:, 1:2], RUN_OUT: draws[:, 2:4]}
    residual = 3 * draws[:, 0] - 40 * draws[:, 1] + draws[:, 4]
    known = KnownParameters(design_of(columns, residual), {LATITUDE: tolerance, RUN_OUT: 1.0})
    marginal = known.marginal
    inverse = np.linalg.inv(
        np.eye(ROWS)
        + tolerance**2 * columns[LATITUDE] @ columns[LATITUDE].T
        + columns[RUN_OUT] @ columns[RUN_OUT].T
    )
    order = [ROTATION, LATITUDE, RUN_OUT]
    dense = np.column_stack([columns[group] for group in order])
    where = np.concatenate([marginal.columns[group] for group in order])
    norms = marginal.norms[where]
    products = marginal.gram[np.ix_(where, where)] * np.outer(norms, norms)
    np.testing.assert_allclose(products, dense.T @ inverse @ dense, rtol=1e-6, atol=1e-9)
    projection = marginal.projection[where] * norms
    np.testing.assert_allclose(projection, dense.T @ inverse @ residual, rtol=1e-6, atol=1e-9)

    both = fit(marginal, [ROTATION, LATITUDE])
    assert both is not None
    beside = KnownParameters(known.whole, {RUN_OUT: 1.0})
    free = fit(beside.marginal, [ROTATION, LATITUDE])
    assert free is not None
    for group, size in free.sizes.items():
        assert both.sizes[group] == pytest.approx(size, rel=1e-6)
    assert known.estimate(both.sizes)[LATITUDE] == pytest.approx(free.sizes[LATITUDE], rel=1e-6)
    covariance = known.compute_covariances(both.groups)[LATITUDE]
    assert covariance == pytest.approx(free.covariances[free.groups.index(LATITUDE)], rel=1e-6)
