"""Faults of the record are counted, and compared with their tolerances."""

import numpy as np
import pytest

from pyhrg.common.units import ARCSEC, DEG
from pyhrg.gap.replay.reading_noise import NONE, Level, ReadingNoise
from pyhrg.gap.soundness import screen_campaign
from pyhrg.gap.soundness.fault import (
    DRIVE_INTERRUPTION,
    TOLERANCE_MARGIN,
    Fault,
    LogFaults,
    list_reading_faults,
    sum_log_faults,
)
from pyhrg.records.campaign import Campaign
from tests.pyhrg.gap.soundness.spoil import added, change_logs, removed, without_rows

SOUND = LogFaults(
    rows=1000, lost_rows=0, wrong_rows=0, interruptions=0, interrupted_s=0.0, interval_s=1.0
)


def find_faults(campaign: Campaign) -> dict[str, float]:
    return {fault.kind.parameter: fault.value for fault in screen_campaign(campaign).faults}


def test_a_sound_campaign_has_none(error_free: Campaign) -> None:
    assert screen_campaign(error_free).faults == ()
    assert sum_log_faults([SOUND]) == []
    assert sum_log_faults([]) == []


def test_lost_rows_are_counted(error_free: Campaign) -> None:
    rows = sum(len(test.log.time) for test in error_free.tests)
    spoiled = change_logs(error_free, without_rows(slice(100, 112)), "still")
    assert find_faults(spoiled) == {"lost_rows_percent": pytest.approx(100 * 12 / rows)}


def test_a_missing_column_is_no_lost_row(error_free: Campaign) -> None:
    assert find_faults(change_logs(error_free, removed("virtual_rotation"), "still")) == {}


def test_wrong_readings_are_counted(error_free: Campaign) -> None:
    rows = sum(len(test.log.time) for test in error_free.tests)
    wrong = np.zeros(600)
    wrong[[100, 200, 300]] = 0.1 * DEG
    spoiled = change_logs(error_free, added(wrong, "gyro_angle"), "still")
    assert find_faults(spoiled) == {"outliers_percent": pytest.approx(100 * 3 / rows)}
    warm = change_logs(error_free, added(np.where(wrong, 5.0, 0.0), "temperature"), "still")
    assert find_faults(warm) == {"outliers_percent": pytest.approx(100 * 3 / rows)}


def test_a_fault_exceeds_its_tolerance_beyond_its_error() -> None:
    (short,) = sum_log_faults([SOUND, _interrupted(2.0)])
    (long,) = sum_log_faults([SOUND, _interrupted(7.0), _interrupted(9.0)])
    assert short.kind == long.kind == DRIVE_INTERRUPTION
    assert (short.value, long.value) == (2.0, 16.0)
    assert short.sigma == pytest.approx(np.sqrt(1 / 6))
    assert short.beyond_probability < 1e-6
    assert long.beyond_probability > 0.999
    limit = (1 + TOLERANCE_MARGIN) * DRIVE_INTERRUPTION.tolerance
    assert Fault(DRIVE_INTERRUPTION, limit, 1.0).beyond_probability == pytest.approx(0.5)
    assert Fault(DRIVE_INTERRUPTION, 0.999 * limit, 0.0).beyond_probability == 0
    assert Fault(DRIVE_INTERRUPTION, 1.001 * limit, 0.0).beyond_probability == 1


def _interrupted(seconds: float) -> LogFaults:
    return LogFaults(1000, 0, 0, 1, seconds, 1.0)


def test_reading_noise_is_a_fault_in_its_unit() -> None:
    assert list_reading_faults(ReadingNoise()) == []
    encoder, gyro = list_reading_faults(
        ReadingNoise(Level(3 * ARCSEC, 0.1 * ARCSEC), NONE, Level(1e-4, 1e-6))
    )
    assert (encoder.kind.name, gyro.kind.name) == ("encoder_noise", "time_jitter")
    assert encoder.value == pytest.approx(3.0)
    assert encoder.beyond_probability > 0.999
    assert gyro.beyond_probability > 0.999
    (small,) = list_reading_faults(ReadingNoise(gyro_jitter=Level(1e-5, 1e-6)))
    assert small.beyond_probability < 0.001
