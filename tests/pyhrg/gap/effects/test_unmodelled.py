"""What two causes leave of a simulation are two shapes, each with a size of its own."""

from dataclasses import replace

import numpy as np

from pyhrg.common.units import DEG
from pyhrg.gap.effects.coordinates import compute_coordinates
from pyhrg.gap.effects.linear_test import LinearTest
from pyhrg.gap.replay.carrier_terms import compute_carrier_terms
from pyhrg.gap.replay.observations import observe_test
from pyhrg.gap.whitening.whitening import NoiseModel, whiten
from pyhrg.records.campaign import Test
from tests.pyhrg.gap.made_up import flat_derivatives
from tests.pyhrg.gap.soundness.conftest import NOMINAL
from tests.pyhrg.records.made_up import made_up_log

ROWS = 400
NOISE = 1e-9
WARMER = 0.9


def test_the_carrier_shows_no_lag_of_the_thermometer() -> None:
    """A fast turn, 0.9 K above the reference temperature. One size for both shapes made a damping
    that goes with the rate of what the carrier left."""
    log = made_up_log(ROWS, table_rate=100 * DEG, noise=0.0)
    log = replace(log, temperature=log.temperature + WARMER)
    device = replace(NOMINAL, thermometer_lag=20.0, frequency_split=0.0035)
    observed = observe_test(Test("test", "rate", "fit", log), device)
    simulated = {**vars(log), "quadrature": np.zeros(ROWS)}
    where = compute_coordinates(observed, simulated, device)
    part = LinearTest(observed, device, simulated, simulated, {}, where, flat_derivatives(ROWS))
    carrier = compute_carrier_terms(device, observed, where.pattern_angle)["amplitude_force"]
    shapes, steps = part.unmodelled["amplitude_force"], np.ones(ROWS)
    noise = NoiseModel(angle_white_noise=NOISE)
    assert np.abs(shapes.mean(axis=0)).max() > NOISE
    assert np.linalg.norm(whiten(carrier[:, None], steps, noise).series) > 100
    assert np.linalg.norm(whiten(carrier[:, None], steps, noise, shapes).series) < 1.01
