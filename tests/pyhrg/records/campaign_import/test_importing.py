"""What a lab logged becomes the same campaign; what isn't as the mapping says is named."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pyhrg.common.site import Site
from pyhrg.common.units import ARCSEC, DEG
from pyhrg.records import COLUMNS, Log, LogError, campaign
from pyhrg.records.campaign import Campaign, Test
from pyhrg.records.campaign_import import import_campaign
from tests.pyhrg.records.campaign_import.labs import HEAD, entry_of, foreign
from tests.pyhrg.records.made_up import LATITUDE, made_up_log

NOMINAL = {"coriolis_factor": 0.277, "decay_time_s": 450.0, "frequency_Hz": 7000.0}


def with_holes(log: Log) -> Log:
    gyro = log.gyro_angle.copy()
    gyro[7] = np.nan
    return replace(log, gyro_angle=gyro)


def made_up_campaign() -> Campaign:
    tests = (
        Test("still", "static", "fit", made_up_log(120)),
        Test("pos", "rate", "fit", made_up_log(120, 5 * DEG)),
        Test("neg", "rate", "holdout", made_up_log(120, -100 * DEG)),
        Test("holes", "static", "fit", with_holes(made_up_log(120))),
    )
    return Campaign("made up", Site(LATITUDE, 9.8015), NOMINAL, tests)


def check_equal(found: Log, made: Log) -> None:
    assert found.interval == made.interval
    for column in COLUMNS:
        before, after = getattr(made, column.field), getattr(found, column.field)
        # 12 digits are written of most columns; frequency loses 4 beside the carrier's 7 kHz.
        scale = 7000 * 2 * np.pi if column.field == "frequency_offset" else 1.0
        np.testing.assert_allclose(after, before, rtol=1e-11, atol=1e-11 * scale)


def test_foreign_logs_become_the_campaign_that_they_were(tmp_path: Path) -> None:
    made = made_up_campaign()
    campaign.write_campaign(
        import_campaign(foreign(made, tmp_path)).campaign, tmp_path / "campaign"
    )
    found = campaign.read_campaign(tmp_path / "campaign")
    assert found.device == made.device
    assert found.nominal == made.nominal
    assert found.site.gravity == made.site.gravity
    for before, after in zip(made.tests, found.tests, strict=True):
        assert (after.id, after.kind, after.role) == (before.id, before.kind, before.role)
        check_equal(after.log, before.log)


def test_recorded_campaign_survives_foreign_logs(tmp_path: Path, recorded_campaign: Path) -> None:
    recorded = campaign.read_campaign(recorded_campaign)
    chosen = tuple(t for t in recorded.tests if t.kind in ("static", "rate", "virtual_rotation"))
    found = import_campaign(foreign(replace(recorded, tests=chosen), tmp_path))
    assert len(found.tests) == len(chosen) == 7
    for before, after in zip(chosen, found.tests, strict=True):
        check_equal(after.read, before.log)


def read_one(folder: Path, columns: str, rows: str, extra: str = "") -> Log:
    """The log of one test without header, `rows` as text."""
    text = HEAD + "[layout]\nheader = false\n" + entry_of("one", "static", "fit", "one.csv")
    (folder / "one.csv").write_text(rows)
    (folder / "mapping.toml").write_text(text + extra + "\n[tests.columns]\n" + columns)
    return import_campaign(folder / "mapping.toml").tests[0].logged


SECONDS = 'time = { column = 1, unit = "s" }\n'


def rows_of(*columns: list[float]) -> str:
    return "\n".join(",".join(map(str, row)) for row in zip(*columns, strict=True))


def test_a_wrapped_angle_is_made_continuous(tmp_path: Path) -> None:
    angle = 100.0 * np.arange(1, 41)
    wrapped = np.mod(angle + 30, 360)
    column = 'table_angle = { column = 2, unit = "deg", wraps_every = 360 }'
    log = read_one(tmp_path, SECONDS + column, rows_of(list(range(1, 41)), list(wrapped)))
    assert np.allclose(log.table_angle, (angle + 30) * DEG)


@pytest.mark.parametrize("lost", [slice(10, 11), slice(10, 14)])
def test_a_way_round_that_is_uncertain_is_refused(tmp_path: Path, lost: slice) -> None:
    time = np.delete(np.arange(1, 41), lost)
    wrapped = list(np.mod(100.0 * time, 360))
    column = 'table_angle = { column = 2, unit = "deg", wraps_every = 360 }'
    with pytest.raises(LogError, match=r"one\.csv: row 11, 2: .*way round is uncertain"):
        read_one(tmp_path, SECONDS + column, rows_of(list(time), wrapped))


@pytest.mark.parametrize(
    ("how", "unit", "values", "angle"),
    [
        ("increments", "arcsec", [1.0, 2.0, 3.0], np.array([1.0, 3.0, 6.0]) * ARCSEC),
        ("means", "deg/s", [1.0, 2.0, 3.0], np.array([0.5, 1.5, 3.0]) * DEG),
        ("samples", "deg/s", [1.0, 2.0, 3.0], np.array([0.5, 1.25, 2.5]) * DEG),
    ],
)
def test_turns_and_rates_are_added_up(
    tmp_path: Path, how: str, unit: str, values: list[float], angle: np.ndarray
) -> None:
    column = f'gyro_angle = {{ column = 2, unit = "{unit}", integrate = "{how}" }}'
    log = read_one(tmp_path, SECONDS + column, rows_of([0.5, 1.0, 1.5], values))
    assert np.allclose(log.gyro_angle, angle, rtol=1e-12)


@pytest.mark.parametrize(
    ("rows", "row", "trouble"),
    [
        ("1,1\n2,\n3,1\n", 2, "no value;"),
        ("1,1\n2,1\n3,1\n6,1\n7,1", 4, "3 s after the row before, not 1 s;"),
        ("1,1\n2,1\n,1", 3, "no time;"),
    ],
)
def test_nothing_is_added_up_over_what_is_missing(
    tmp_path: Path, rows: str, row: int, trouble: str
) -> None:
    column = 'gyro_angle = { column = 2, unit = "deg/s", integrate = "means" }'
    with pytest.raises(LogError, match=rf"row {row}, 2: {trouble}.*cut the log there"):
        read_one(tmp_path, SECONDS + column, rows)


def test_clocks_are_read(tmp_path: Path) -> None:
    rows = "2024-02-29T23:59:59.5+01:00,1\n2024-03-01T00:00:00.0+01:00,2\n\n,3\n"
    columns = 'time = { column = 1, format = "iso" }\namplitude = { column = 2 }'
    log = read_one(tmp_path, columns, rows)
    np.testing.assert_array_equal(log.time, [0.5, 1.0, np.nan])
    assert log.interval == 0.5
    rows = "28.02.24 23:59:00,1\n29.02.24 00:01:00,2\n"
    columns = columns.replace("iso", "%d.%m.%y %H:%M:%S")
    log = read_one(tmp_path, columns, rows)
    np.testing.assert_array_equal(log.time, [120.0, 240.0])


def test_rows_are_counted_where_no_time_is_logged(tmp_path: Path) -> None:
    log = read_one(tmp_path, "amplitude = { column = 1 }", "1\n1.1\n1\n", "interval_s = 0.2")
    np.testing.assert_allclose(log.time, [0.2, 0.4, 0.6])
    with pytest.raises(LogError, match="no column of times mapped and no interval_s"):
        read_one(tmp_path, "amplitude = { column = 1 }", "1\n1.1\n1\n")


@pytest.mark.parametrize(
    ("column", "rows", "message"),
    [
        ("", "1\n2\nx\n", r"one\.csv: row 3, 1: 'x'; expected a number.*tests\[0\]\.columns\.time"),
        ("", "1\n2\n3,4\n", r"one\.csv: row 3: 2 cells; expected 1"),
        ("", "1\n2\n2,5\n", r"one\.csv: row 3: 2 cells; expected 1"),
        ("", "3\n2\n1\n", r"one\.csv: row 2, time_s: 2 after 3; expected time to increase"),
        ("", "\n", r"one\.csv: found no row of values"),
        ("amplitude = { column = 2 }", "1\n2\n", r"one\.csv: column 2: not there; expected 1 to 1"),
        ("amplitude = { column = 'A' }", "1\n2\n", r"column A: found no columns.*no header"),
        (
            "amplitude = { column = 2 }",
            "1,1\n2,-1\n",
            r"row 2, amplitude: -1; expected 0 to 1e\+12",
        ),
        ("amplitude = { column = 2 }", "1,1\n2,inf\n", r"row 2, amplitude: inf; expected"),
    ],
)
def test_what_is_not_as_mapped_is_named(
    tmp_path: Path, column: str, rows: str, message: str
) -> None:
    with pytest.raises(LogError, match=message):
        read_one(tmp_path, SECONDS + column, rows)


def test_a_sign_that_the_table_contradicts_is_refused(tmp_path: Path) -> None:
    made = replace(made_up_campaign(), tests=made_up_campaign().tests[1:2])
    path = foreign(made, tmp_path)
    path.write_text(path.read_text().replace("scale = -1", "scale = 1"))
    with pytest.raises(LogError, match=r"pos\.txt: column gyro_angle_deg: .*is a sign reversed"):
        import_campaign(path)


def test_a_log_may_lack_a_column_of_all(tmp_path: Path) -> None:
    made = replace(made_up_campaign(), tests=made_up_campaign().tests[:1])
    path = foreign(made, tmp_path)
    path.write_text(path.read_text() + 'absent = ["temperature"]\n')
    found = import_campaign(path).tests[0]
    assert np.isnan(found.logged.temperature).all()
    assert found.read.exclusions == ("no column temperature_degC",)
