"""Effects that records can't see beside the set that they name, and that shift its sizes."""

import numpy as np
import pytest

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.catalogue import EFFECTS
from pyhrg.gap.evidence.equivalence.hidden_effects import find_hidden_effects
from pyhrg.gap.evidence.evidence import fit
from tests.pyhrg.gap.made_up import design_of

AXIS, GAIN = EFFECTS["damping_anisotropy"], EFFECTS["drive_gain_mismatch"]
SIGMAS = 1000.0
"""Length of an effect of typical size, in sigma."""


def columns(visible: float) -> tuple[Array, Array]:
    """Two harmonics for the anisotropy, and for the mismatch the first of them with a share of a
    third shape."""
    basis, _ = np.linalg.qr(np.random.default_rng(1).normal(size=(300, 3)))
    mismatch = np.sqrt(1 - visible**2) * basis[:, 0] + visible * basis[:, 2]
    return SIGMAS / AXIS.scale * basis[:, :2], SIGMAS / GAIN.scale * mismatch[:, None]


@pytest.mark.parametrize(("visible", "is_hidden"), [(0.015, True), (0.025, False)])
def test_a_mismatch_hides_beside_an_anisotropy_until_it_is_seen(
    visible: float, is_hidden: bool
) -> None:
    """A tenth of a typical mismatch is seen with 1.5 and 2.5 sigma."""
    own, other = columns(visible)
    truth = own @ (AXIS.scale * np.array([0.8, 0.6]))
    design = design_of({AXIS: own, GAIN: other}, truth)
    best = fit(design, [AXIS])
    assert best is not None
    hidden = find_hidden_effects(design, best, [AXIS, GAIN])
    assert [found.effect for found in hidden] == [GAIN] * is_hidden
    if is_hidden:
        assert hidden[0].shifted == (AXIS,)
        left = truth - own @ hidden[0].fit.sizes[AXIS] - other @ hidden[0].fit.sizes[GAIN]
        assert np.linalg.norm(left) == pytest.approx(0.1 * visible * SIGMAS)


def test_what_shifts_no_size_beyond_its_interval_is_not_hidden() -> None:
    own, _ = columns(0.0)
    basis, _ = np.linalg.qr(np.column_stack([own, np.random.default_rng(2).normal(size=300)]))
    faint = (10.0 / GAIN.scale) * (basis[:, 2] + basis[:, 0])[:, None]
    design = design_of({AXIS: own, GAIN: faint}, own @ np.array([AXIS.scale, 0.0]))
    best = fit(design, [AXIS])
    assert best is not None
    assert find_hidden_effects(design, best, [GAIN]) == []
