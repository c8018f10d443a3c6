"""IMU logs in messages of NovAtel and VectorNav."""

from pathlib import Path

import numpy as np
import pytest

from ins_eval.flights import sources
from pyhrg.common.errors import HrgError
from pyhrg.common.reading.messages import read_messages
from pyhrg.common.units import STANDARD_GRAVITY
from pyhrg.records.imu.log import Increments
from pyhrg.records.imu.novatel import SCALES
from tests.ins_eval.imu.logs import resting
from tests.ins_eval.imu.messages import (
    SCALE,
    make_novatel,
    make_vectornav,
    write_rawimu,
    write_vectornav,
)

TRUTH = resting(5.0)
CONFIGURATION = make_novatel("INSCONFIGA,COM1,0,66.5,FINE,2209,338183.0,0,0,0;ISA100C,5,50", "#")
FREQUENCY = "$VNRRG,07,100*XX"


def write(folder: Path, lines: list[str]) -> Path:
    path = folder / "log.txt"
    path.write_text("\r\n".join(lines) + "\r\n")
    return path


@pytest.mark.parametrize("name", ["RAWIMUA", "RAWIMUSA", "RAWIMUXA", "RAWIMUSXA"])
def test_counts_of_novatel_become_forward_right_down(tmp_path: Path, name: str) -> None:
    """To a count; over the end of a GPS week, with other messages between."""
    lines = [CONFIGURATION, *write_rawimu(TRUTH, name)]
    lines.insert(7, make_novatel("INSPVAA,COM1;0", "#"))
    lines.insert(9, "[COM1]<OK")
    found = sources.read_record(write(tmp_path, lines)).increments
    np.testing.assert_allclose(found.rotation, TRUTH.rotation, atol=0.51 * SCALE.angle)
    np.testing.assert_allclose(found.velocity, TRUTH.velocity, atol=0.51 * SCALE.velocity)
    assert (found.start, found.interval) == pytest.approx((604_790.0, 0.01))


@pytest.mark.parametrize(
    ("kind", "rate", "published"),
    [
        (41, 125, [329308016, -2706935, 4508389]),
        (11, 100, [43110635, -817242, -202184]),
        (13, 200, [32068, -1612, -1320]),
    ],
)
def test_published_messages_feel_gravity(kind: int, rate: float, published: list[int]) -> None:
    """Examples of RAWIMUSX: of NovAtel's reference (an Epson G320, whose bias is some milli-g), of
    its decoder's tests (a Honeywell HG1700 AG58), of a post-processor (an iMAR FSAS)."""
    (scale,) = (scale for (number, _), scale in SCALES.items() if number == kind)
    force = rate * scale.velocity * np.linalg.norm(published)
    assert force == pytest.approx(STANDARD_GRAVITY, rel=6e-3)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda x: [*x[:5], x[5].replace("00,26,", "00,27,"), *x[6:]], "row 6: found checksum"),
        (lambda x: x[:9], "found 9 RAWIMUSXA, expected at least 10"),
        (lambda x: [*x[:5], *x[7:]], "row 6, time_s: found .*: are 2 rows missing"),
        (
            lambda x: [make_novatel("INSPVASA,1,2;3")] * 12,
            "found INSPVASA, expected one of RAWIMUSXA",
        ),
        (
            lambda x: write_rawimu(TRUTH, kind=7),
            "row 1, IMU type: found '7', expected one of 1 HG1",
        ),
        (lambda x: [*x, *write_rawimu(TRUTH, kind=8)], "IMU type: found 26 and 8, expected one"),
        (
            lambda x: write_rawimu(TRUTH, "RAWIMUSA"),
            "found RAWIMUSA, which does not say of which IMU",
        ),
        (
            lambda x: [*x, make_novatel("RAWIMUSXA,1,2;01,26,3")],
            "row 501, IMU info: found 01, which",
        ),
        (
            lambda x: [*x, make_novatel("RAWIMUSXA,1,2;g0,26,3")],
            "IMU info: found 'g0', expected a hex",
        ),
        (
            lambda x: [*x, make_novatel("RAWIMUSXA,1,2;00,26,3")],
            "row 501: .*expected seconds after",
        ),
        (
            lambda x: [*x, make_novatel("RAWIMUSXA,1,2;00,26,3,4,5,6,7,x,9,1,2")],
            "row 501, x accel: found 'x', expected a number",
        ),
        (
            lambda x: [*x, make_novatel("RAWIMUSXA,1,2;00,26,3,4,5,6,7,nan,9,1,2")],
            "row 501, x accel: found nan, expected a finite number",
        ),
    ],
)
def test_what_is_wrong_with_novatel_is_named(tmp_path: Path, change, message: str) -> None:  # type: ignore[no-untyped-def]
    with pytest.raises(HrgError, match=message):
        sources.read_record(write(tmp_path, change(write_rawimu(TRUTH))))


def test_an_imu_that_stands_on_its_head_is_named(tmp_path: Path) -> None:
    turned = Increments(TRUTH.interval, -TRUTH.rotation, -TRUTH.velocity)
    path = write(tmp_path, write_rawimu(turned))
    with pytest.raises(HrgError, match=r"column accel_x .*is z down where up is meant"):
        sources.read_record(path)
    sources.read_record(path, trusted=True)


@pytest.mark.parametrize("name", ["VNDTV", "VNIMU", "VNYMR"])
def test_messages_of_vectornav_are_read(tmp_path: Path, name: str) -> None:
    lines = [FREQUENCY, *write_vectornav(name, TRUTH)]
    found = sources.read_record(write(tmp_path, lines)).increments
    skipped = len(TRUTH) - len(found)
    np.testing.assert_allclose(found.rotation, TRUTH.rotation[skipped:], rtol=1e-11, atol=1e-18)
    np.testing.assert_allclose(found.velocity, TRUTH.velocity[skipped:], rtol=1e-11, atol=1e-18)
    assert (found.start, skipped) == pytest.approx((0.01, 1) if name == "VNDTV" else (0.0, 0))


def test_messages_of_navigation_are_the_clock(tmp_path: Path) -> None:
    """Each second one, over the end of a week; the first without a fix."""
    lines = []
    for n, line in enumerate(write_vectornav("VNIMU", TRUTH)):
        lines.append(line)
        if n % 100 == 99:
            week, seconds = divmod(604_795.0 + (n + 1) / 100, 604_800.0)
            known = f"{seconds:.6f},{2209 + week:.0f}" if n > 99 else "12.0,0"
            lines.append(make_vectornav(f"VNINS,{known},0004,1,2,3"))
    found = sources.read_record(write(tmp_path, [FREQUENCY, *lines])).increments
    assert found.start == pytest.approx(604_795.0)


def test_published_messages_of_vectornav_have_their_checksums() -> None:
    """Answers in Safran's VersaSync manual: VNYMR (register 27), VNDTV (80)."""
    lines = [
        "$VNRRG,27,+006.380,+000.023,-001.953,+1.0640,-0.2531,+3.0614,+00.005,+00.344,-09.758,"
        "-0.001222,-0.000450,-0.001218*4F",
        "$VNRRG,80,+0.665016,-000.119,-000.409,-000.025,+000.011,-000.084,-006.702*6A",
        "$VNYPR,+010.071,+000.278,-002.026*60",
        "$VNYPR,+010.071,+000.278,-002.026,T1162704*2F",
    ]
    assert len(list(read_messages("log", lines, ("VNRRG", "VNYPR")))) == 4


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda x: x[1:], r"found VNIMU without its frequency, .*\$VNRRG,07,100"),
        (lambda x: [*x[:5], x[5].replace("+1", "-1"), *x[6:]], "row 6: found checksum"),
        (lambda x: x[:6], "found 5 VNIMU, expected at least 10"),
        (
            lambda x: [FREQUENCY, make_vectornav("VNINS,1,2,3")],
            "found VNINS, VNRRG, expected one of",
        ),
        (lambda x: [*x, make_vectornav("VNIMU,1,2,3,4,5,6,7,8")], "row 502: .*expected gyro z"),
        (lambda x: [*x, make_vectornav("VNIMU,1,2,3,4,5,g,7,8,9")], "row 502, accelerometer z: "),
        (lambda x: ["$VNRRG,07,0*XX", *x[1:]], "row 1, frequency: found 0, expected 1 to"),
    ],
)
def test_what_is_wrong_with_vectornav_is_named(tmp_path: Path, change, message: str) -> None:  # type: ignore[no-untyped-def]
    with pytest.raises(HrgError, match=message):
        sources.read_record(write(tmp_path, change([FREQUENCY, *write_vectornav("VNIMU", TRUTH)])))
