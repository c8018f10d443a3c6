"""Devices of a kind."""

import numpy as np
import pytest

from pyhrg import theory
from pyhrg.parameters import TYPICAL
from pyhrg.units import DEG_PER_H


def test_the_benched_gyro_is_typical_of_its_kind() -> None:
    """Its map's amplitude is the kind's rms (4000 devices), its stability the paper's 0.1 deg/h."""
    generator = np.random.default_rng(3)
    kind = [abs(theory.static_bias_phasor(TYPICAL.another(generator))) for _ in range(4000)]
    rms = np.sqrt(np.mean(np.square(kind)))
    assert abs(theory.static_bias_phasor(TYPICAL)) == pytest.approx(rms, rel=0.02)
    assert theory.circumferential_bias_stability(TYPICAL) / DEG_PER_H == pytest.approx(
        0.1, rel=0.05
    )


def test_another_keeps_magnitudes() -> None:
    other = TYPICAL.another(np.random.default_rng(1))
    assert other != TYPICAL
    assert other.damping_anisotropy == TYPICAL.damping_anisotropy
    for kind in ("pickoff", "drive"):
        vector = [
            getattr(other, f"{kind}_{part}") for part in ("gain_mismatch", "nonorthogonality")
        ]
        original = [
            getattr(TYPICAL, f"{kind}_{part}") for part in ("gain_mismatch", "nonorthogonality")
        ]
        assert np.hypot(*vector) == pytest.approx(np.hypot(*original))
