"""A free pattern keeps its quadrature: what turns it shows in its amplitude, and later too."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.common.units import DEG
from pyhrg.gap.effects.catalogue import EFFECTS
from pyhrg.gap.effects.linear_test import LinearTest
from pyhrg.gap.effects.sensitivities import compute_sensitivities, linearize_test
from pyhrg.gap.effects.term_columns import build_term_columns
from pyhrg.gap.replay.observations import observe_test
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.records.campaign import Test
from tests.pyhrg.gap.soundness.conftest import NOMINAL
from tests.pyhrg.records.made_up import made_up_log

ROWS, RELEASED = 300, 20
ORIGIN = 0.25 * DEG
LATITUDE = EFFECTS["site_latitude"]


@pytest.fixture(scope="module")
def part(simulation: Simulation) -> LinearTest:
    """A ring-down of a gyro with a frequency split, and what an error of the latitude changes."""
    log = replace(made_up_log(ROWS, noise=0.0), drive_on=1.0 * (np.arange(ROWS) < RELEASED))
    device = replace(NOMINAL.without_noise(), frequency_split=0.006, damping_anisotropy=1e-6)
    observed = observe_test(Test("test", "ring_down", "fit", log), device)
    simulated = simulation.simulate(device, observed)
    changes = compute_sensitivities(simulation, device, observed, [LATITUDE])
    return linearize_test(simulation, device, device, observed, simulated, changes)


def test_a_constant_rate_is_a_bias_and_leaves_nothing_at_the_measured_angle(
    part: LinearTest,
) -> None:
    """The turn that the rate makes is off by more than a percent from that of a driven pattern."""
    amplitude, angle = (part.sensitivities[LATITUDE][name] for name in ("amplitude", "gyro_angle"))
    left = part.at_measured_angle(amplitude, angle, "amplitude")
    assert np.abs(left).max() < 0.01 * np.abs(amplitude).max()
    columns = {term.function: block for term, block in build_term_columns(part.where, "gyro_angle")}
    bias = columns["bias: mean over the pattern angle"][:, 0]
    ratio = angle[RELEASED:, 0] / bias[RELEASED:]
    assert ratio == pytest.approx(np.full(ROWS - RELEASED, ratio[0]), rel=1e-3)
    time = part.test.log.time
    assert np.ptp(angle[RELEASED:, 0] / time[RELEASED:]) > 0.01 * np.abs(ratio[0])


def test_an_angle_that_counts_from_elsewhere_leaves_nothing_either(
    simulation: Simulation, part: LinearTest
) -> None:
    """The simulated pattern starts with the error that the output angle has."""
    inputs = part.test.inputs
    start = inputs.start_angle + part.bryan_factor * ORIGIN
    moved = replace(part.test, inputs=replace(inputs, start_angle=start))
    others = simulation.simulate(part.device, moved)
    amplitude = part.simulated["amplitude"] - others["amplitude"]
    angle = ORIGIN + part.simulated["gyro_angle"] - others["gyro_angle"]
    left = part.at_measured_angle(amplitude[:, None], angle[:, None], "amplitude")
    assert np.abs(left).max() < 0.02 * np.abs(amplitude).max()
