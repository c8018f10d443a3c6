"""Inputs are complete in every row, or the log is cut; outputs are never filled in."""

import re
from dataclasses import replace

import numpy as np
import pytest

from pyhrg.common.units import DEG
from pyhrg.gap.soundness import screen_campaign
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign
from tests.pyhrg.gap.soundness.spoil import (
    Change,
    at,
    change_logs,
    removed,
    scaled,
    shifted,
    swapped,
    without_rows,
)


def log_of(given: Campaign, name: str) -> Log:
    return next(test.log for test in given.tests if test.id == name)


def screen_changed(given: Campaign, change: Change, name: str) -> tuple[Log, list[str]]:
    """The screened log of a test after a change, and the sentences about it."""
    screened, exclusions, _ = screen_campaign(change_logs(given, change, name))
    return log_of(screened, name), list(exclusions)


INPUTS = (
    *("table_angle", "axis_up", "acceleration_z", "temperature", "virtual_rotation"),
    *("amplitude_setpoint", "phase_offset", "drive_on"),
)


@pytest.mark.parametrize("name", ["still", "neg", "warm", "virtual"])
def test_missing_rows_are_filled_while_nothing_changes(error_free: Campaign, name: str) -> None:
    rows = slice(60, 65)
    log, sentences = screen_changed(error_free, without_rows(rows), name)
    before = log_of(error_free, name)
    assert sentences == [f"{name}: 5 missing rows: inputs filled in, outputs not"]
    for field in (*INPUTS, "time"):
        np.testing.assert_allclose(getattr(log, field), getattr(before, field), rtol=1e-9)
    for field in ("gyro_angle", "wave_angle", "amplitude", "amplitude_force"):
        assert np.flatnonzero(np.isnan(getattr(log, field))).tolist() == [60, 61, 62, 63, 64]


def test_a_log_is_cut_where_its_inputs_are_unknown(error_free: Campaign) -> None:
    log, sentences = screen_changed(error_free, without_rows(slice(18, 22)), "pos")
    assert sentences == ["pos: inputs missing from time_s 9.5 on, while they changed: cut there"]
    assert len(log.time) == 17  # the turn in the last row before a change is not sure
    assert np.isfinite(log.gyro_angle).all()
    gaps = [*range(14, 17), *range(18, 22)]
    log, _ = screen_changed(error_free, without_rows(gaps), "pos")
    assert len(log.time) == 14  # the turn in a row that is missing is not sure either
    assert np.isfinite(log.gyro_angle).all()
    log, sentences = screen_changed(
        error_free, at(slice(80, 200), np.nan, "virtual_rotation"), "virtual"
    )
    assert len(log.time) == 80


@pytest.mark.parametrize("field", ["table_angle", "temperature", "drive_on"])
def test_missing_values_of_inputs_are_filled(error_free: Campaign, field: str) -> None:
    log, sentences = screen_changed(error_free, at(slice(30, 33), np.nan, field), "neg")
    np.testing.assert_allclose(getattr(log, field), getattr(log_of(error_free, "neg"), field))
    assert np.isfinite(log.gyro_angle).all()
    assert sentences == ["neg: 3 missing rows: inputs filled in, outputs not"]


def test_a_row_is_filled_while_the_table_changes_its_rate(error_free: Campaign) -> None:
    """The cubic is nearer to it than a straight line, which is off by 0.6 deg."""
    log, sentences = screen_changed(error_free, without_rows([19]), "pos")
    whole = log_of(error_free, "pos").table_angle
    assert sentences == ["pos: 1 missing rows: inputs filled in, outputs not"]
    assert len(log.table_angle) == len(whole)
    off = np.abs(log.table_angle - whole)
    assert 0 < off[19] < np.abs((whole[18] + whole[20]) / 2 - whole[19])
    assert not np.delete(off, 19).any()


def test_a_missing_temperature_cuts_no_turn(error_free: Campaign) -> None:
    log, _ = screen_changed(error_free, at(slice(10, 30), np.nan, "temperature"), "pos")
    np.testing.assert_array_equal(log.table_angle, log_of(error_free, "pos").table_angle)
    assert np.isfinite(log.temperature).all()


def test_a_known_row_between_two_missing_ones_cuts_nothing(error_free: Campaign) -> None:
    """Nothing is known of the rate in the row that is known alone."""
    log, sentences = screen_changed(error_free, without_rows([100, 102, 104]), "still")
    assert len(log.time) == 600
    assert sentences == ["still: 3 missing rows: inputs filled in, outputs not"]
    log, _ = screen_changed(error_free, without_rows([100, 102]), "neg")
    np.testing.assert_allclose(log.table_angle, log_of(error_free, "neg").table_angle)


def test_the_start_must_be_there(error_free: Campaign) -> None:
    log, sentences = screen_changed(error_free, without_rows(slice(0, 2)), "still")
    assert len(log.time) == 600
    assert sentences == ["still: 2 missing rows: inputs filled in, outputs not"]
    _, exclusions, _ = screen_campaign(change_logs(error_free, without_rows(slice(0, 9)), "still"))
    assert exclusions == ("still: not used: still: 9 rows are missing before the first one",)


def test_too_many_missing_rows_are_not_filled(error_free: Campaign) -> None:
    spoiled = change_logs(error_free, without_rows(slice(100, 300)), "still")
    sentences = screen_campaign(spoiled).sentences
    assert re.match(
        r"still: not used: still: .* 1 to 600 in 400 rows; expected 1 to 400", sentences[0]
    )


def test_missing_columns_are_those_of_a_gyro_at_rest(error_free: Campaign) -> None:
    log, sentences = screen_changed(error_free, removed(*INPUTS[2:]), "still")
    assert sentences == [
        "still: virtual_rotation_deg_s, amplitude_setpoint, phase_offset_rad, drive_on, "
        "temperature_degC, accel_z_m_s2: missing, taken as on a gyro at rest"
    ]
    for field in INPUTS:
        np.testing.assert_allclose(getattr(log, field), getattr(log_of(error_free, "still"), field))


def test_attitude_is_taken_from_the_accelerometer(error_free: Campaign) -> None:
    log, sentences = screen_changed(error_free, removed("axis_up"), "tumble")
    assert sentences == ["tumble: axis_up: missing, taken from accel_z_m_s2"]
    np.testing.assert_array_equal(log.axis_up, log_of(error_free, "tumble").axis_up)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (swapped("acceleration_x", "acceleration_z"), "are accel_x and accel_z swapped"),
        (scaled(-1, "acceleration_z"), "is a sign reversed"),
        (scaled(0.5, "acceleration_z"), r"4\.9\d* m/s2 in all; expected 9\.8"),
    ],
)
def test_specific_force_that_is_not_gravity_is_replaced(
    error_free: Campaign, change: Change, message: str
) -> None:
    log, sentences = screen_changed(error_free, change, "still")
    assert re.search(message, sentences[0])
    assert sentences[1].endswith("missing, taken as on a gyro at rest")
    np.testing.assert_allclose(log.acceleration_z, log_of(error_free, "still").acceleration_z)


def test_an_attitude_that_the_accelerometers_contradict_is_not_used(error_free: Campaign) -> None:
    _, sentences, _ = screen_campaign(
        change_logs(error_free, at(slice(None), 1.0, "axis_up"), "tumble")
    )
    assert sentences[0].startswith("tumble: not used: ")
    assert "m/s2 along z; expected axis_up times gravity" in sentences[0]


@pytest.mark.parametrize("change", [shifted(273.15, "temperature"), shifted(52.0, "temperature")])
def test_a_temperature_that_the_frequency_contradicts_is_excluded(
    error_free: Campaign, change: Change
) -> None:
    log, sentences = screen_changed(error_free, change, "still")
    assert re.search(r"from the reference, .*: is the unit degC\?", sentences[0])
    np.testing.assert_allclose(log.temperature, 298.15)


def test_stray_values_exclude_their_rows_only(error_free: Campaign) -> None:
    log, sentences = screen_changed(error_free, at(slice(40, 42), 500 * DEG, "wave_angle"), "neg")
    assert re.search("from time_s 20.5 on, gyro is not .*; 2 rows left out", sentences[0])
    assert np.flatnonzero(np.isnan(log.wave_angle)).tolist() == [40, 41]
    assert np.flatnonzero(np.isnan(log.gyro_angle)).tolist() == [40, 41]


def test_a_wrapped_wave_angle_is_excluded(error_free: Campaign) -> None:
    def wrap(log: Log) -> Log:
        return replace(log, wave_angle=np.mod(log.wave_angle, 90 * DEG))

    log, sentences = screen_changed(error_free, wrap, "neg")
    assert re.search("it jumps by 90 deg, is it wrapped", sentences[0])
    assert np.isnan(log.wave_angle).all()
    assert np.isfinite(log.gyro_angle).all()
