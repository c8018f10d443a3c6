"""Fixes from files: what is read, and what is refused."""

from pathlib import Path

import numpy as np
import pytest

from ins_eval.aided.fixes import read_fixes
from pyhrg.common.errors import HrgError
from tests.ins_eval.imu.messages import make_novatel, make_vectornav

HEADER = "time_s,latitude_deg,longitude_deg,height_m,position_sigma_m"
ROWS = [f"{t},45.0,7.5,300.0,2.0" for t in range(40)]


def write(folder: Path, header: str, rows: list[str]) -> Path:
    path = folder / "fixes.csv"
    path.write_text("\n".join([header, *rows]) + "\n")
    return path


def test_groups_may_be_empty_in_a_row(tmp_path: Path) -> None:
    header = f"{HEADER},height_sigma_m,speed_m_s,speed_sigma_m_s"
    rows = [row + (",3.0,," if t % 2 else ",,1.5,0.1") for t, row in enumerate(ROWS)]
    rows.append("40,,,,,,2.0,0.1")
    fixes = read_fixes(write(tmp_path, header, rows))
    assert len(fixes) == 41
    assert fixes.has_position.sum() == 40
    np.testing.assert_allclose(fixes.position[0], [np.deg2rad(45), np.deg2rad(7.5), 300])
    np.testing.assert_allclose(fixes.position_sigma[:2], [[2, 2, 2], [2, 2, 3]])
    np.testing.assert_array_equal(np.isfinite(fixes.speed[:4]), [True, False, True, False])
    assert not np.isfinite(fixes.velocity).any()


@pytest.mark.parametrize(
    ("header", "rows", "message"),
    [
        ("", [], "column time_s is missing; found an empty file"),
        ("time_s,latitude_deg", [], "column longitude_deg is missing; found time_s, latitude_deg"),
        (HEADER + ",speed_m_s", [], "column speed_sigma_m_s is missing"),
        (HEADER + ",time_s", [], "column time_s appears more than once"),
        (HEADER, ROWS[:20], "found 20 positions, expected at least 30"),
        (HEADER, [*ROWS, "39,45,7.5,300,2"], "row 42, time_s: found 39 after 39, expected time to"),
        (HEADER, [*ROWS, "50,45,7.5,,2"], "row 42, height_m: found nothing"),
        (HEADER, [*ROWS, "50,4500,7.5,300,2"], "row 42, latitude_deg: found 4500, expected -89"),
        (HEADER, [*ROWS, "50,45,7.5,300,0"], "row 42, position_sigma_m: found 0, expected 0.0001"),
        (HEADER, [*ROWS, "50,45,7.5,300,2 m"], "row 42, position_sigma_m: found '2 m'"),
        (HEADER, [*ROWS, ",45,7.5,300,2"], "row 42, time_s: found '', expected a number"),
        (HEADER, [*ROWS, "50,nan,7.5,300,2"], "row 42, latitude_deg: found nan, expected -89"),
    ],
)
def test_bad_files_are_refused(tmp_path: Path, header: str, rows: list[str], message: str) -> None:
    with pytest.raises(HrgError, match=message):
        read_fixes(write(tmp_path, header, rows))


def test_text_of_kf_gins_is_read(tmp_path: Path) -> None:
    rows = [f"{456250 + t:.3f}   30.44 114.47 21.1   0.3 0.4  0.9 " for t in range(40)]
    fixes = read_fixes(write(tmp_path, rows[0], rows[1:]))
    assert len(fixes) == 40
    np.testing.assert_allclose(fixes.position[0], [np.deg2rad(30.44), np.deg2rad(114.47), 21.1])
    np.testing.assert_allclose(fixes.position_sigma[0], [0.125**0.5, 0.125**0.5, 0.9])
    with pytest.raises(HrgError, match="row 3, latitude_deg: found 3044, expected -89"):
        read_fixes(write(tmp_path, rows[0], [rows[1], rows[2].replace("30.44", "3044"), *rows[3:]]))
    with pytest.raises(HrgError, match="row 2: found 6 fields, expected 7"):
        read_fixes(write(tmp_path, rows[0], [rows[1].replace("0.9", ""), *rows[2:]]))


def make_message(body: str, seconds: float, week: int = 2163, name: str = "BESTGNSSPOSA") -> str:
    header = f"{name},COM1,0,83.5,FINESTEERING,{week},{seconds:.3f},02400000,b1f6,65535"
    return make_novatel(f"{header};{body}", "#")


SOLVED = 'SOL_COMPUTED,SINGLE,51.15,-114.03,1097.6,-17.0,WGS84,1.3,1.5,3.1,"",0.0,0.0,18'
PUBLISHED = (
    "#BESTPOSA,COM1,0,83.5,FINESTEERING,2163,329760.000,02400000,b1f6,65535;SOL_COMPUTED,SINGLE,"
    "51.15043874397,-114.03066788586,1097.6822,-17.0000,WGS84,1.3648,1.1806,3.1112,"
    '"",0.000,0.000,18,18,18,0,00,02,11,01*c3194e35'
)
"""Example of NovAtel's reference of commands and logs."""


def test_messages_of_novatel_are_read(tmp_path: Path) -> None:
    """Over the end of a week; others, unsolved ones and those of the receiver's INS aside. The
    height is above the ellipsoid."""
    rows = [make_message(SOLVED, 604780.0 + t) for t in range(20)]
    rows += [make_message(SOLVED, float(t), week=2164) for t in range(20)]
    rows.insert(5, make_message(SOLVED.replace("SOL_COMPUTED,SINGLE", "COLD_START,NONE"), 604784.5))
    rows.insert(9, make_message(SOLVED.replace("SINGLE", "INS_PSRSP"), 604787.5))
    fixes = read_fixes(write(tmp_path, PUBLISHED, rows))
    np.testing.assert_allclose(fixes.time, 604780.0 + np.arange(40))
    np.testing.assert_allclose(fixes.position[0], [np.deg2rad(51.15), np.deg2rad(-114.03), 1080.6])
    level = np.sqrt((1.3**2 + 1.5**2) / 2)
    np.testing.assert_allclose(fixes.position_sigma[0], [level, level, 3.1])


@pytest.mark.parametrize(
    ("rows", "message"),
    [
        ([PUBLISHED], "found 1 positions, expected at least 30"),
        ([PUBLISHED, PUBLISHED.replace("1097", "1098")], "row 2: found checksum 'c3194e35'"),
        ([make_message("0.1", 1.0, name="INSPVAA")], "found INSPVAA, expected one of BESTGNSS"),
        ([make_message("SOL_COMPUTED", 1.0)], "row 1: found too few fields"),
        (
            [make_message(SOLVED.replace("-17.0", "x"), 1.0)],
            "row 1, undulation: found 'x', expected a number",
        ),
        ([make_message(SOLVED.replace("51.15", "151.15"), 1.0)], "row 1, latitude_deg: found 151"),
    ],
)
def test_bad_messages_are_refused(tmp_path: Path, rows: list[str], message: str) -> None:
    with pytest.raises(HrgError, match=message):
        read_fixes(write(tmp_path, rows[0], rows[1:]))


def write_position(seconds: float, week: int = 1694, kind: int = 3) -> str:
    place = "+32.95,-096.71,+00169.457,-000.850,-000.580,-002.860,+005.5,+003.6,+009.7,+003.3,2E-08"
    return make_vectornav(f"VNGPS,{seconds:.6f},{week},{kind},05,{place}")


def test_messages_of_vectornav_are_read(tmp_path: Path) -> None:
    """Over the end of a week; those of the sensor's own navigator and flat fixes aside."""
    rows = [write_position(604780.0 + t) for t in range(20)]
    rows += [write_position(float(t), week=1695) for t in range(20)]
    rows.insert(5, write_position(604784.5, kind=2))
    fixes = read_fixes(write(tmp_path, make_vectornav("VNINS,604780.0,1694,0004,1,2,3"), rows))
    np.testing.assert_allclose(fixes.time, 604780.0 + np.arange(40))
    np.testing.assert_allclose(fixes.position[0], [np.deg2rad(32.95), np.deg2rad(-96.71), 169.457])
    level = np.sqrt((5.5**2 + 3.6**2) / 2)
    np.testing.assert_allclose(fixes.position_sigma[0], [level, level, 9.7])
    np.testing.assert_allclose(fixes.velocity[0], [-0.85, -0.58, -2.86])
    np.testing.assert_allclose(fixes.velocity_sigma, 3.3)


@pytest.mark.parametrize(
    ("row", "message"),
    [
        (make_vectornav("VNINS,1,2,3"), "found VNINS, expected one of VNGPS"),
        (make_vectornav("VNGPS,1,2,3,4,5"), "row 1: found too few fields, expected speed accuracy"),
        (write_position(1.0).replace("32", "33"), "row 1: found checksum"),
        (write_position(1.0), "found 1 positions, expected at least 30"),
    ],
)
def test_bad_messages_of_vectornav_are_refused(tmp_path: Path, row: str, message: str) -> None:
    with pytest.raises(HrgError, match=message):
        read_fixes(write(tmp_path, row, []))
