"""An output angle that counts from elsewhere than the pattern angle at power-on."""

from dataclasses import replace

import numpy as np

from pyhrg.common.units import DEG
from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign
from tests.pyhrg.gap.bench import recorded
from tests.pyhrg.gap.soundness.conftest import NOMINAL
from tests.pyhrg.gap.soundness.spoil import change_logs

ANISOTROPY = 2e-6
LOST_ROW = 40
OFFSETS = (0.0, 0.25 * DEG, -11 * DEG)
"""None, one within what a pick-off may be wrong, and one beyond that, rad."""


def shift_origins(campaign: Campaign) -> Campaign:
    """Each log with another offset in turn, and without a row."""
    offsets = {test.log.source: OFFSETS[i % 3] for i, test in enumerate(campaign.tests)}

    def shift(log: Log) -> Log:
        angle = log.gyro_angle + offsets[log.source]
        return replace(log, gyro_angle=np.where(np.arange(len(angle)) == LOST_ROW, np.nan, angle))

    return change_logs(campaign, shift)


def test_a_wrong_origin_is_no_gap(simulation: Simulation) -> None:
    """It was a step in each log."""
    gyro = replace(NOMINAL, damping_anisotropy=ANISOTROPY, damping_axis=0.3)
    campaign = shift_origins(recorded(simulation.sampled, gyro))
    found = diagnose(campaign, simulation=simulation).diagnosis
    (cause,) = found.causes
    assert (found.verdict, cause.effect) == ("explained", "damping_anisotropy")
    low, high = cause.interval_95["damping_anisotropy_per_s"]
    assert low < ANISOTROPY < high < 1.01 * low
    assert found.unknown_probability < 0.1

    mended = [sentence for sentence in found.excluded if "this offset is taken out" in sentence]
    assert len(mended) == len(campaign.tests) // 3
    for figure in (found.gap.fit_angle_arcsec, found.gap.holdout_angle_arcsec):
        assert figure is not None
        assert figure.after < figure.floor_95[1]
