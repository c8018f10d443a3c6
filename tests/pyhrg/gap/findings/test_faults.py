"""Faults of bench and record are causes beyond their tolerance, and listed within it."""

from dataclasses import replace

import pytest

from pyhrg.device.device import Device
from pyhrg.gap.closing.closing import read_identified_device
from pyhrg.gap.findings.faults import list_fault_causes, list_tolerated_faults
from pyhrg.gap.soundness.fault import AXIS_SIGN, ENCODER_NOISE, LOST_ROWS, TABLE_SIGN, Fault
from tests.pyhrg.gap.findings.test_diagnosis import GIVEN

FAULTS = (
    Fault(TABLE_SIGN, -1.0, 1e-4),
    Fault(AXIS_SIGN, -1.01, 0.01),
    Fault(LOST_ROWS, 0.4, 0.0),
    Fault(ENCODER_NOISE, 3.0, 0.1),
)


def test_both_signs_make_one_cause() -> None:
    mounting, encoder = list_fault_causes(FAULTS)
    assert (mounting.effect, mounting.family) == ("mounting_sign", "bench")
    assert mounting.parameters == {"table_angle_sign": -1.0, "axis_up_sign": -1.01}
    assert mounting.interval_95["axis_up_sign"] == pytest.approx((-1.0296, -0.9904), abs=1e-4)
    assert encoder.effect == "encoder_noise"
    assert encoder.probability > 0.999


def test_what_is_within_its_tolerance_is_listed() -> None:
    (lost,) = list_tolerated_faults(FAULTS)
    assert (lost.name, lost.family, lost.parameter) == ("lost_rows", "record", "lost_rows_percent")
    assert (lost.value, lost.stated, lost.interval_95, lost.tolerance) == (
        0.4,
        0.0,
        (0.4, 0.4),
        1.0,
    )


def test_what_is_uncertain_is_no_cause() -> None:
    assert list_fault_causes([Fault(ENCODER_NOISE, 1.1, 0.1)]) == ()


def test_faults_do_not_change_the_gyro() -> None:
    found = replace(
        GIVEN,
        causes=list_fault_causes(FAULTS),
        within_tolerance=list_tolerated_faults(FAULTS),
    )
    assert read_identified_device(Device(), found) == Device()
