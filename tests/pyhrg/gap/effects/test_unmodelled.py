"""What two causes leave of a simulation are two shapes, each with a size of its own."""

from dataclasses import replace

import numpy as np

from pyhrg.common.units import DEG
from pyhrg.device.device import Device
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
LAGGING = replace(NOMINAL, thermometer_lag=20.0, frequency_split=0.0035)


def linearize(device: Device) -> LinearTest:
    """A fast turn, its thermometer's readings 0.9 K above the reference temperature."""
    log = made_up_log(ROWS, table_rate=100 * DEG, noise=0.0)
    log = replace(log, temperature=log.temperature + WARMER)
    observed = observe_test(Test("test", "rate", "fit", log), NOMINAL)
    simulated = {**vars(log), "quadrature": np.zeros(ROWS)}
    where = compute_coordinates(observed, simulated, NOMINAL)
    return LinearTest(observed, device, simulated, simulated, {}, where, flat_derivatives(ROWS))


def test_the_carrier_shows_no_lag_of_the_thermometer() -> None:
    """One size for both shapes made a damping that goes with the rate of what the carrier left."""
    part = linearize(LAGGING)
    angle = part.where.pattern_angle
    carrier = compute_carrier_terms(LAGGING, part.test, angle)["amplitude_force"]
    shapes, steps = part.unmodelled["amplitude_force"], np.ones(ROWS)
    noise = NoiseModel(angle_white_noise=NOISE)
    assert np.abs(shapes.mean(axis=0)).max() > NOISE
    assert np.linalg.norm(whiten(carrier[:, None], steps, noise).series) > 100
    assert np.linalg.norm(whiten(carrier[:, None], steps, noise, shapes).series) < 1.01


def test_a_thermometer_that_reads_high_shows_no_warming() -> None:
    """The lag of a thermometer matters while the resonator warms; an offset is no warming."""
    reads_high = replace(LAGGING, thermometer_offset=WARMER)
    warming, steady = (
        linearize(device).unmodelled["amplitude_force"][:, 1] for device in (LAGGING, reads_high)
    )
    assert np.abs(warming).max() > NOISE
    assert np.abs(steady).max() < 1e-6 * np.abs(warming).max()
