"""Campaigns with one spoilt log: a clear error, or a stated exclusion and correct figures."""

import csv
import gzip
import io
import json
import math
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from pyhrg.bench.bias.position import fixed_position, full_circumference
from pyhrg.bench.outcome import BenchError, Outcome
from pyhrg.bench.procedure import Procedure, evaluate_tests
from pyhrg.bench.source import open_records
from pyhrg.common.errors import HrgError
from pyhrg.device.ready_devices import TYPICAL
from pyhrg.fmu import GyroFmu
from pyhrg.records import campaign as campaigns
from tests.pyhrg.bench.cases import QUICK_PLAN, slow_bench

Rows = list[dict[str, str]]
Spoil = Callable[[Rows], Rows]
RUNS = 3
FIXED, AROUND = fixed_position.PROCEDURE, full_circumference.PROCEDURE
SPOILT = {FIXED.name: "fixed_2", AROUND.name: "positions_2"}
MIDDLE = slice(150, 175)
"""Rows at rest: in the second segment of either test's log."""


@pytest.fixture(scope="module")
def intact(slow_fmu: GyroFmu, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three power-ons of either test."""
    bench = slow_bench(slow_fmu, TYPICAL)
    power_ons = fixed_position.make_power_ons(bench, RUNS)
    power_ons += full_circumference.make_power_ons(bench, QUICK_PLAN, RUNS, segments=3)
    folder = tmp_path_factory.mktemp("campaign")
    campaigns.write_campaign(bench.campaign(bench.run(power_ons)), folder)
    return folder


def evaluate(procedure: Procedure, folder: Path) -> Outcome:
    return evaluate_tests(procedure, campaigns.read_campaign(folder))


def spoil_log(intact: Path, tmp_path: Path, procedure: Procedure, spoil: Spoil) -> Path:
    """The campaign with rows of one log changed."""
    folder = tmp_path / "spoilt"
    shutil.copytree(intact, folder)
    path = folder / f"{SPOILT[procedure.name]}.csv.gz"
    rows = spoil(list(csv.DictReader(io.StringIO(gzip.decompress(path.read_bytes()).decode()))))
    text = io.StringIO()
    writer = csv.DictWriter(text, list(rows[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    path.write_bytes(gzip.compress(text.getvalue().encode()))
    return folder


def set_values(column: str, part: slice, value: str | None) -> Spoil:
    """A column's values in some rows replaced; None: by the first of them."""

    def spoil(rows: Rows) -> Rows:
        first = rows[part.start or 0][column]
        for row in rows[part]:
            row[column] = first if value is None else value
        return rows

    return spoil


def drop_rows(part: slice) -> Spoil:
    return lambda rows: [row for i, row in enumerate(rows) if i not in range(*part.indices(10**6))]


def drop_columns(*columns: str) -> Spoil:
    return lambda rows: [{k: v for k, v in row.items() if k not in columns} for row in rows]


def rename_columns(old: str, new: str) -> Spoil:
    return lambda rows: [{k.replace(old, new): v for k, v in row.items()} for row in rows]


def convert_to_radians(*columns: str) -> Spoil:
    """Radians under deg."""

    def spoil(rows: Rows) -> Rows:
        for row in rows:
            row.update({name: f"{math.radians(float(row[name])):.12g}" for name in columns})
        return rows

    return spoil


def repeat_rows(rows: Rows) -> Rows:
    return rows[:200] + rows[150:200] + rows[200:]


def reverse_part(rows: Rows) -> Rows:
    return rows[:150] + rows[150:175][::-1] + rows[175:]


EXCLUDED = {
    "gap": (drop_rows(MIDDLE), "row 152: a gap before each, 25 rows missing in all"),
    "NaN": (set_values("gyro_angle_deg", MIDDLE, "NaN"), "rows 152-176: gyro_angle_deg missing"),
    "empty": (set_values("wave_angle_deg", MIDDLE, ""), "rows 152-176: wave_angle_deg missing"),
    "axis": (set_values("axis_up", MIDDLE, "nan"), "rows 152-176: axis_up missing"),
    "drive": (set_values("drive_on", MIDDLE, ""), "rows 152-176: drive_on missing"),
    "table": (set_values("table_angle_deg", MIDDLE, ""), "rows 152-176: table_angle_deg missing"),
    "saturated": (set_values("gyro_angle_deg", MIDDLE, None), "gyro_angle_deg stands still"),
    "repeated": (repeat_rows, "rows 202-251: an earlier row again"),
    "unused": (drop_columns("temperature_degC"), "no column temperature_degC"),
}
"""Spoilt logs that can still be used, and the exclusion that the outcome states."""


@pytest.mark.parametrize("procedure", [FIXED, AROUND], ids=lambda p: p.name)
@pytest.mark.parametrize(("spoil", "message"), EXCLUDED.values(), ids=EXCLUDED)
def test_an_exclusion_is_stated_and_figures_stay_right(
    intact: Path, tmp_path: Path, procedure: Procedure, spoil: Spoil, message: str
) -> None:
    right = evaluate(procedure, intact)
    outcome = evaluate(procedure, spoil_log(intact, tmp_path, procedure, spoil))
    file = SPOILT[procedure.name]
    assert any(file in x and message in x for x in outcome.exclusions), outcome.exclusions
    assert right.exclusions == ()
    assert [f.name for f in outcome.findings] == [f.name for f in right.findings]
    for finding, expected in zip(outcome.findings, right.findings, strict=True):
        if math.isfinite(finding.si_low):
            assert finding.si_low <= expected.si_value <= finding.si_high, finding.name
        assert finding.si_value == pytest.approx(expected.si_value, rel=0.2, abs=1e-9), finding.name


def test_inputs_that_are_taken_as_at_rest_are_said_once(intact: Path, tmp_path: Path) -> None:
    spoil = drop_columns("phase_offset_rad", "temperature_degC")
    records = open_records(spoil_log(intact, tmp_path, FIXED, spoil), [FIXED])
    assert evaluate_tests(FIXED, records.get_records(FIXED)).exclusions == (
        "fixed_2.csv.gz: phase_offset_rad, temperature_degC: missing, taken as on a gyro at rest",
    )


REFUSED = {
    "reversed": (reverse_part, r"row 153, time_s: .* expected time to increase"),
    "column": (drop_columns("gyro_angle_deg"), "column gyro_angle_deg is missing"),
    "drive": (drop_columns("drive_on"), "column drive_on is missing"),
    "virtual": (drop_columns("virtual_rotation_deg_s"), "column virtual_rotation_deg_s is missing"),
    "text": (
        set_values("gyro_angle_deg", MIDDLE, "n/a"),
        "row 152, gyro_angle_deg: 'n/a'; expected",
    ),
    "radians": (convert_to_radians("gyro_angle_deg"), "are radians given where degrees are meant"),
    "short": (lambda rows: rows[:100], "segment"),
    "unit": (
        rename_columns("gyro_angle_deg", "gyro_angle_rad"),
        "gyro_angle_rad; expected gyro_angle_deg",
    ),
}
"""Spoilt logs that can't be used, and the message of the error."""


@pytest.mark.parametrize("procedure", [FIXED, AROUND], ids=lambda p: p.name)
@pytest.mark.parametrize(("spoil", "message"), REFUSED.values(), ids=REFUSED)
def test_what_can_not_be_used_is_refused_by_name(
    intact: Path, tmp_path: Path, procedure: Procedure, spoil: Spoil, message: str
) -> None:
    folder = spoil_log(intact, tmp_path, procedure, spoil)
    with pytest.raises(HrgError, match=message) as raised:
        evaluate(procedure, folder)
    assert SPOILT[procedure.name] in str(raised.value)


@pytest.mark.parametrize("procedure", [FIXED, AROUND], ids=lambda p: p.name)
def test_truncated_file_is_refused(intact: Path, tmp_path: Path, procedure: Procedure) -> None:
    folder = tmp_path / "spoilt"
    shutil.copytree(intact, folder)
    path = folder / f"{SPOILT[procedure.name]}.csv.gz"
    path.write_bytes(path.read_bytes()[:-1000])
    with pytest.raises(HrgError, match=rf"{path.name}: found what is no whole gzipped data"):
        evaluate(procedure, folder)


def position(rows: Rows, number: int) -> slice:
    """Rows of one position's rest."""
    angles = [float(row["table_angle_deg"]) for row in rows]
    turning = [i for i in range(1, len(rows)) if abs(angles[i] - angles[i - 1]) > 1e-3]
    ends = [i for i, j in zip(turning, [*turning[1:], 10**9], strict=True) if j > i + 1]
    return slice(ends[number - 1] + 1, ends[number] - 20)


@pytest.mark.parametrize("number", [4, 7])
def test_lost_position_does_not_shift_the_mean(intact: Path, tmp_path: Path, number: int) -> None:
    """A position less would shift the mean over the circumference; its power-on is left out."""

    def lose(rows: Rows) -> Rows:
        part = position(rows, 4) if number == 4 else slice(len(rows) - 320, len(rows))
        return drop_rows(part)(rows)

    right = evaluate(AROUND, intact)
    outcome = evaluate(AROUND, spoil_log(intact, tmp_path, AROUND, lose))
    assert any("positions_2" in x and "7 positions" in x for x in outcome.exclusions)
    for name in ("bias", "bias stability"):
        expected = right.finding(name)
        assert outcome.finding(name).n == RUNS - 1
        assert outcome.finding(name).si_low <= expected.si_value <= outcome.finding(name).si_high


def test_all_positions_lost_alike_are_refused(intact: Path, tmp_path: Path) -> None:
    folder = spoil_log(intact, tmp_path, AROUND, lambda rows: drop_rows(position(rows, 4))(rows))
    index = json.loads((folder / "campaign.json").read_text())
    index["tests"] = [test for test in index["tests"] if test["id"] == "positions_2"]
    (folder / "campaign.json").write_text(json.dumps(index))
    with pytest.raises(BenchError, match=r"positions_2\S*: 7 positions .* needs 8N"):
        evaluate(AROUND, folder)


def test_gap_within_a_position_makes_no_two_of_one(intact: Path, tmp_path: Path) -> None:
    outcome = evaluate(AROUND, spoil_log(intact, tmp_path, AROUND, drop_rows(slice(160, 165))))
    assert outcome.finding("bias").n == RUNS
    assert any("7 of 23 data points left out" in text for text in outcome.exclusions)
