"""Channels that a recorder scales wrongly."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.common.units import DEG
from pyhrg.gap.replay.observations import CHANNELS, observe_test
from pyhrg.gap.replay.recorder import SCALES
from pyhrg.gap.replay.simulation import Simulation
from tests.pyhrg.gap.replay.test_simulation import QUIET, programme, record_log

PROGRAMMES = {
    "settled": programme().rest(60).command(amplitude_setpoint=0.9).rest(140),
    "short": programme(0.1).rest(5).spin(100 * DEG, 2).rest(5),
}


@pytest.mark.parametrize("kind", PROGRAMMES)
@pytest.mark.parametrize("channel", SCALES)
def test_a_wrong_scale_multiplies_one_channel(
    simulation: Simulation, channel: str, kind: str
) -> None:
    observed = observe_test(record_log(simulation, QUIET, PROGRAMMES[kind], angle=0.3), QUIET)
    other = replace(QUIET, **{SCALES[channel]: 0.02})
    before, after = (simulation.simulate(device, observed) for device in (QUIET, other))
    change = simulation.compute_difference(QUIET, other, observed)
    for name in CHANNELS:
        share = 0.02 if name == channel else 0.0
        np.testing.assert_allclose(after[name], (1 + share) * before[name], rtol=1e-12)
        rows = observed.rows[name]
        moved = change[name][rows]
        expected = share * before[name][rows]
        largest = np.abs(expected).max()
        np.testing.assert_allclose(moved, expected, atol=1e-3 * largest + 1e-15, err_msg=name)
