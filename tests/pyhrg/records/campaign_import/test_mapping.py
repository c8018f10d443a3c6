"""Every key of a mapping is checked, and named where it is wrong."""

from pathlib import Path

import pytest

from pyhrg.common.errors import HrgError
from pyhrg.records.campaign_import.mapping import read_mapping
from tests.pyhrg.records.campaign_import.labs import HEAD, entry_of

GOOD = HEAD + "[layout]\nseparator = 'tab'\n" + entry_of("one", "static", "fit", "one.csv")
COLUMNS = GOOD + "[tests.columns]\n"


def read(folder: Path, text: str) -> None:
    (folder / "mapping.toml").write_text(text)
    read_mapping(folder / "mapping.toml")


def test_a_good_mapping_is_read(tmp_path: Path) -> None:
    read(tmp_path, COLUMNS + 'time = { column = 1, unit = "s" }')


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (("[site]", "[place]"), "place: found an unknown key, expected .*"),
        (('device = "made up"', ""), "device: found no such key, expected the gyro's name"),
        (('"made up"', "7"), "device: found 7, expected the gyro's name"),
        (("latitude_deg = 40.0", ""), r"site\.latitude_deg: found no such key"),
        (("40.0", "400.0"), r"site\.latitude_deg: found 400.0, expected -90 to 90"),
        (("9.8015", "1.0"), r"site\.gravity_m_s2: found 1.0, expected 9\.7 to 9\.9"),
        (("decay_time_s = 450.0", ""), r"nominal\.decay_time_s: found no such key"),
        (("450.0", "0.1"), r"nominal: decay_time_s: found 0\.1, expected 1 to 100000"),
        (("450.0", "'long'"), r"nominal\.decay_time_s: found 'long', expected a number"),
        (("decay_time_s", "decay_time_s = 9\ndecay_time_ms"), "nominal: decay_time_ms: .*unknown"),
        (("'tab'", "'dot'"), r"layout\.separator: found 'dot', expected comma or"),
        (("'tab'", "'comma'\ndecimal = 'comma'"), r"layout\.decimal: found 'comma', expected anot"),
        (("'tab'", "'tab'\nencoding = 'x'"), r"layout\.encoding: found 'x', expected a text"),
        (
            ("'tab'", "'tab'\nlines_before_header = 0.5"),
            r"layout\.lines_before_header: found 0\.5, expected a whole",
        ),
        (("'tab'", "'tab'\nmissing = '-'"), r"layout\.missing: found '-', expected texts"),
        (('role = "fit"', 'role = "train"'), r"tests\[0\]\.role: found 'train', expected fit or"),
        (('kind = "static"', ""), r"tests\[0\]\.kind: found no such key"),
        (('"one"', '"a/b"'), r"tests\[0\]\.id: found 'a/b', expected a file name, each once"),
        (("[[tests]]", "[tests]"), r"tests: found .*, expected tables, \[\[tests\]\]"),
        (("[[tests]]", "interval_s = 1\n[[tests]]"), r"layout\.interval_s: found an unknown key"),
        (('"one.csv"', '"one.csv"\ninterval_s = 0'), r"tests\[0\]\.interval_s: found 0, expected"),
        (
            ('file = "one.csv"', 'file = "one.csv"\nabsent = ["x"]'),
            r"tests\[0\]\.absent: found \['x'\], exp",
        ),
    ],
)
def test_a_wrong_key_is_named(tmp_path: Path, change: tuple[str, str], message: str) -> None:
    assert change[0] in GOOD
    with pytest.raises(HrgError, match=rf"mapping\.toml: {message}"):
        read(tmp_path, GOOD.replace(*change))


@pytest.mark.parametrize(
    ("column", "message"),
    [
        (
            "gyro_angel = 1",
            r"gyro_angel: found an unknown key, expected tests\[0\]\.columns\.gyro_angle",
        ),
        ("gyro_angle = 1", "gyro_angle: found 1, expected a table"),
        ("gyro_angle = { column = 1 }", r"gyro_angle\.unit: found no such key, expected rad or"),
        ("gyro_angle = { column = 1, unit = 'm' }", r"gyro_angle\.unit: found 'm', expected rad"),
        ("gyro_angle = { column = 1, unit = 'deg/s' }", r"unit: found 'deg/s', expected rad or"),
        (
            "gyro_angle = { column = 1, unit = 'deg', integrate = 'means' }",
            r"unit: found 'deg', expected rad/s or",
        ),
        (
            "gyro_angle = { column = 1, unit = 'deg', integrate = 'increments', wraps_every = 9 }",
            "wraps_every: found 9, expected it or integrate",
        ),
        ("gyro_angle = { column = 1, unit = 'deg', integrate = 'yes' }", "integrate: found 'yes'"),
        (
            "gyro_angle = { unit = 'deg' }",
            r"gyro_angle\.column: found no such key, expected the na",
        ),
        ("gyro_angle = { column = true, unit = 'deg' }", "column: found True, expected the name"),
        (
            "gyro_angle = { column = 1, unit = 'deg', scale = 0 }",
            r"scale: found 0\.0, expected a n",
        ),
        ("gyro_angle = { column = 1, unit = 'deg', sign = -1 }", "sign: found an unknown key"),
        ("amplitude = { column = 1, integrate = 'means' }", "integrate: found an unknown key"),
        ("axis_up = 2", "axis_up: found 2, expected -1 to 1"),
        ("accel_z = { constant = 9.8 }", r"accel_z\.unit: found no such key, expected m/s2 or g"),
    ],
)
def test_a_wrong_column_is_named(tmp_path: Path, column: str, message: str) -> None:
    with pytest.raises(
        HrgError, match=rf"tests\[0\]\.columns\.(gyro_angle\.|amplitude\.)?{message}"
    ):
        read(tmp_path, COLUMNS + column)


def test_ids_are_there_once(tmp_path: Path) -> None:
    with pytest.raises(HrgError, match=r"tests\[0\]\.id: found 'one', expected a file"):
        read(tmp_path, GOOD + entry_of("one", "rate", "fit", "two.csv"))


def test_no_mapping_at_all(tmp_path: Path) -> None:
    with pytest.raises(HrgError, match=r"tests: found no such key, expected \[\[tests\]\]"):
        read(tmp_path, HEAD)
    with pytest.raises(HrgError, match="found what is no TOML"):
        read(tmp_path, "device = ")
    with pytest.raises(HrgError, match="can't be read"):
        read_mapping(tmp_path / "other.toml")
