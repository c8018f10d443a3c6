"""A free pattern keeps its quadrature: what turns it shows in its amplitude, and later too."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.gap.effects.catalogue import EFFECTS
from pyhrg.gap.effects.sensitivities import compute_sensitivities, linearize_test
from pyhrg.gap.effects.term_columns import build_term_columns
from pyhrg.gap.replay.observations import observe_test
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.records.campaign import Test
from tests.pyhrg.gap.soundness.conftest import NOMINAL
from tests.pyhrg.records.made_up import made_up_log

ROWS, RELEASED = 300, 20


def test_a_constant_rate_is_a_bias_and_leaves_nothing_at_the_measured_angle(
    simulation: Simulation,
) -> None:
    """In a ring-down of a gyro with a frequency split, after an error of the latitude. The turn
    that the rate makes is off by more than a percent from that of a driven pattern."""
    log = replace(made_up_log(ROWS, noise=0.0), drive_on=1.0 * (np.arange(ROWS) < RELEASED))
    device = replace(NOMINAL.without_noise(), frequency_split=0.006, damping_anisotropy=1e-6)
    observed = observe_test(Test("test", "ring_down", "fit", log), device)
    simulated = simulation.simulate(device, observed)
    latitude = EFFECTS["site_latitude"]
    changes = compute_sensitivities(simulation, device, observed, [latitude])
    part = linearize_test(simulation, device, device, observed, simulated, changes)
    amplitude, angle = (changes[latitude][name] for name in ("amplitude", "gyro_angle"))
    left = part.at_measured_angle(amplitude, angle, "amplitude")
    assert np.abs(left).max() < 0.01 * np.abs(amplitude).max()
    columns = {term.function: block for term, block in build_term_columns(part.where, "gyro_angle")}
    bias = columns["bias: mean over the pattern angle"][:, 0]
    ratio = angle[RELEASED:, 0] / bias[RELEASED:]
    assert ratio == pytest.approx(np.full(ROWS - RELEASED, ratio[0]), rel=1e-3)
    assert np.ptp(angle[RELEASED:, 0] / log.time[RELEASED:]) > 0.01 * np.abs(ratio[0])
