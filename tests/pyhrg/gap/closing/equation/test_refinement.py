"""What the linear response to a term misses, beside an exact solution."""

from dataclasses import replace

import numpy as np

from pyhrg.gap.closing.equation.refinement import estimate_missed
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.coordinates import compute_coordinates
from pyhrg.gap.effects.linear_test import LinearTest
from pyhrg.gap.effects.term_columns import compute_response
from pyhrg.gap.replay.observations import CHANNELS, observe_test
from pyhrg.records.campaign import Test
from tests.pyhrg.gap.made_up import flat_derivatives
from tests.pyhrg.gap.soundness.conftest import NOMINAL
from tests.pyhrg.records.made_up import made_up_log

ROWS = 800
DAMPING = 3e-5
"""Damping that goes with the square of the amplitude less that at the nominal one, 1/s."""


def test_a_ring_down_that_damps_itself_is_foreseen() -> None:
    """With g = 1/tau - c the free amplitude is a = [(1 + c/g) exp(2 g t) - c/g]^(-1/2)."""
    log = replace(made_up_log(ROWS, noise=0.0), drive_on=np.zeros(ROWS))
    observed = observe_test(Test("test", "ring_down", "fit", log), NOMINAL)
    nothing = np.zeros(ROWS)
    rate = 1 / NOMINAL.decay_time - DAMPING
    simulated = dict.fromkeys(CHANNELS, nothing) | {
        "wave_angle": nothing,
        "amplitude": np.exp(-log.time / NOMINAL.decay_time),
    }
    where = compute_coordinates(observed, simulated, NOMINAL)
    by_angle = flat_derivatives(ROWS)
    part = LinearTest(observed, NOMINAL, simulated, simulated, {}, where, by_angle)
    term = CandidateTerm("amplitude_force", "amplitude", "amplitude squared")
    sizes = {term: np.array([DAMPING])}
    linear = compute_response(where, "amplitude", sizes)
    share = DAMPING / rate
    exact = ((1 + share) * np.exp(2 * rate * log.time) - share) ** -0.5
    missed = exact - simulated["amplitude"] - linear
    foreseen = estimate_missed(part, sizes)["amplitude"]
    assert np.abs(linear).max() > 3e-3
    assert np.linalg.norm(foreseen - missed) < 0.1 * np.linalg.norm(missed)
