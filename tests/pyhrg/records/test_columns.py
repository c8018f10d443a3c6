"""The columns are those of the record format and of `Log`."""

from dataclasses import fields

import pytest

from pyhrg.records import COLUMNS, Log
from pyhrg.records.columns import find_mislabelled_column

HEADER = (
    "time_s,table_angle_deg,axis_up,accel_x_m_s2,accel_y_m_s2,accel_z_m_s2,temperature_degC,"
    "virtual_rotation_deg_s,amplitude_setpoint,phase_offset_rad,drive_on,gyro_angle_deg,"
    "wave_angle_deg,amplitude,amplitude_force_per_s,quadrature_force_per_s,frequency_offset_Hz"
)


def test_columns_are_those_of_the_record_format() -> None:
    assert ",".join(column.name for column in COLUMNS if not column.optional) == HEADER


def test_each_column_is_a_field_of_the_log() -> None:
    names = [field.name for field in fields(Log)]
    assert [column.field for column in COLUMNS] == names[2:-1]


@pytest.mark.parametrize(
    ("name", "meant"),
    [
        ("gyro_angle_rad", "gyro_angle_deg"),
        ("gyro_angle", "gyro_angle_deg"),
        ("temperature_K", "temperature_degC"),
        ("time_ms", "time_s"),
        ("virtual_rotation_rad_s", "virtual_rotation_deg_s"),
        ("accel_z_g", "accel_z_m_s2"),
        ("amplitude_um", "amplitude"),
        ("frequency_offset_rad_s", "frequency_offset_Hz"),
    ],
)
def test_wrong_unit_is_seen_through(name: str, meant: str) -> None:
    column = find_mislabelled_column(name)
    assert column is not None
    assert column.name == meant


@pytest.mark.parametrize("name", [*HEADER.split(","), "amplitude_raw", "time_utc", "pressure_Pa"])
def test_right_units_and_other_columns_pass(name: str) -> None:
    assert find_mislabelled_column(name) is None
