"""What is written is read back; the logs of a real campaign are whole."""

import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pyhrg.common.units import DEG
from pyhrg.records import COLUMNS, read_log, write_log
from tests.pyhrg.records.made_up import made_up_log


def test_written_log_is_read_back(tmp_path: Path) -> None:
    """To 1e-12 rad even after ten turns, and to the twelfth digit elsewhere."""
    log = made_up_log(table_rate=15 * DEG)
    write_log(log, tmp_path / "log.csv.gz")
    again = read_log(tmp_path / "log.csv.gz")
    assert again.source == "log.csv.gz"
    assert again.interval == 1.0
    assert again.exclusions == ()
    for column in COLUMNS:
        expected, found = getattr(log, column.field), getattr(again, column.field)
        angle = column.unit == "deg"
        np.testing.assert_allclose(
            found,
            expected,
            rtol=0 if angle else 1e-11,
            atol=1e-12 if angle else 0,
            err_msg=column.name,
        )


def test_same_log_gives_the_same_bytes(tmp_path: Path) -> None:
    write_log(made_up_log(), tmp_path / "a.csv.gz")
    write_log(made_up_log(), tmp_path / "b.csv.gz")
    assert (tmp_path / "a.csv.gz").read_bytes() == (tmp_path / "b.csv.gz").read_bytes()
    assert sorted(path.name for path in tmp_path.iterdir()) == ["a.csv.gz", "b.csv.gz"]


def test_columns_without_values_stay_missing(tmp_path: Path) -> None:
    write_log(replace(made_up_log(), temperature=np.full(600, np.nan)), tmp_path / "log.csv")
    assert "temperature" not in (tmp_path / "log.csv").read_text()
    assert read_log(tmp_path / "log.csv").exclusions == ("no column temperature_degC",)


def test_long_log_is_read_in_less_than_a_second(tmp_path: Path) -> None:
    path = tmp_path / "long.csv.gz"
    write_log(made_up_log(100_000), path)
    start = time.process_time()
    read_log(path)
    assert time.process_time() - start < 1.0


def test_recorded_logs_are_whole(recorded_campaign: Path) -> None:
    """None of 14 is refused, and nothing is left out."""
    paths = sorted(recorded_campaign.glob("*.csv.gz"))
    assert paths
    for path in paths:
        log = read_log(path)
        assert log.exclusions == (), path.name
        assert log.stretches(*(c.field for c in COLUMNS if not c.optional)) == [
            slice(0, len(log.time))
        ]


@pytest.mark.parametrize("field", ["gyro_angle", "wave_angle", "amplitude", "frequency_offset"])
def test_stretch_in_a_recorded_log_is_found(
    recorded_campaign: Path, tmp_path: Path, field: str
) -> None:
    """Each of the logs in turn, held for 40 rows; the next one may happen to be equal."""
    for path in sorted(recorded_campaign.glob("*.csv.gz")):
        log = read_log(path)
        values = getattr(log, field).copy()
        values[100:140] = values[100]
        write_log(replace(log, **{field: values}), tmp_path / "log.csv")
        found = np.flatnonzero(np.isnan(getattr(read_log(tmp_path / "log.csv"), field)))
        assert list(found[:40]) == list(range(100, 140)), path.name
        assert len(found) < 43, path.name


def test_a_log_as_a_frame_has_si_columns_and_units() -> None:
    log = made_up_log()
    frame = log.to_frame()
    assert list(frame.columns) == [column.field for column in COLUMNS]
    np.testing.assert_array_equal(frame["gyro_angle"], log.gyro_angle)
    units = frame.attrs["units"]
    assert (units["gyro_angle"], units["temperature"], units["axis_up"]) == ("rad", "K", "1")
