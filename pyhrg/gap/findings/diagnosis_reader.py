"""Reads a `diagnosis.json` back into a `Diagnosis`."""

import math
from pathlib import Path
from typing import cast, get_args

from pyhrg.common.toml_table import TomlTable, read_json_table
from pyhrg.device.declarations import Family
from pyhrg.gap.findings.diagnosis import (
    FIGURE_UNITS,
    FILE,
    ROLES,
    SCHEMA,
    STAGES,
    Cause,
    Diagnosis,
    DiagnosisError,
    Gap,
    GapFigure,
    KnownValue,
    Leftover,
    NextTest,
    Verdict,
)
from pyhrg.gap.findings.localisation import Place
from pyhrg.gap.findings.quantity import Size


def read_diagnosis(path: Path | str) -> Diagnosis:
    """Read a campaign's diagnosis; what `write` wrote is read back as it was.

    Args:
        path: a `diagnosis.json`, or the folder that holds one.

    Raises:
        DiagnosisError: an unreadable file, one that is no diagnosis, or that of a static record.
    """
    path = Path(path)
    return _parse(read_json_table(path / FILE if path.is_dir() else path, DiagnosisError))


def _parse(index: TomlTable) -> Diagnosis:
    index.text("schema", None, (SCHEMA,))
    if "record" in index.values:
        raise index.error("record", index.values["record"], "a campaign's diagnosis")
    for key in ("causes", "where", "sizes", "gap", "unnamed", "settled"):
        index.require(key, "as `hrg gap diagnose` writes it")
    verdict = cast(Verdict, index.text("verdict", None, get_args(Verdict)))
    return Diagnosis(
        index.text("device", None),
        verdict,
        tuple(map(_parse_cause, index.tables("causes"))),
        index.number("unknown_probability", None, 0.0, 1.0),
        tuple(map(_parse_place, index.tables("where"))),
        tuple(map(_parse_size, index.tables("sizes"))),
        _parse_gap(index.table("gap")),
        _parse_next_test(index),
        _numbers(index.table("unnamed")),
        _texts(index, "excluded"),
        index.flag("settled", True),
        tuple(map(_parse_known, index.tables("within_tolerance"))),
        *(_parse_leftover(index.table("material").table(key)) for key in ("left", "bound")),
    )


def _parse_leftover(table: TomlTable) -> Leftover:
    names = ("angle_arcsec", "rate_deg_h", "loop_share")
    return Leftover(*(table.finite_number(name) if table.values else 0.0 for name in names))


def _parse_cause(table: TomlTable) -> Cause:
    intervals = table.table("interval_95")
    return Cause(
        table.text("effect", None),
        table.number("probability", None, 0.0, 1.0),
        _numbers(table.table("parameters")),
        {name: _interval(intervals, name) for name in intervals.values},
        _texts(table, "equivalents"),
        _parse_family(table),
    )


def _parse_family(table: TomlTable) -> Family:
    return cast(Family, table.text("family", "gyro", get_args(Family)))


def _parse_known(table: TomlTable) -> KnownValue:
    return KnownValue(
        table.text("name", None),
        _parse_family(table),
        table.text("parameter", None),
        table.finite_number("value"),
        table.finite_number("told"),
        _interval(table, "interval_95"),
        table.finite_number("tolerance"),
    )


def _parse_place(table: TomlTable) -> Place:
    return Place(
        table.text("test", None),
        table.text("channel", None),
        table.text("coordinate", None),
        table.finite_number("share"),
        table.finite_number("sigmas"),
        int(table.finite_number("harmonic")) if "harmonic" in table.values else None,
    )


def _parse_size(table: TomlTable) -> Size:
    numbers = (table.finite_number(key) for key in ("scale_s", "before", "after"))
    return Size(table.text("test", None), table.text("channel", None), *numbers)


def _parse_gap(table: TomlTable) -> Gap:
    fit_angle, fit_rate, holdout_angle, holdout_rate = (
        _parse_figure(table, role, unit) for role in ROLES for unit in FIGURE_UNITS
    )
    if fit_angle is None:
        raise table.table("before").table("fit").missing("angle_arcsec", "a number")
    ends = (_optional_number(table, key) for key in ("shrink_percent", "whiteness"))
    return Gap(fit_angle, fit_rate, holdout_angle, holdout_rate, *ends)


def _parse_figure(gap: TomlTable, role: str, unit: str) -> GapFigure | None:
    tables = {stage: gap.table(stage).table(role) for stage in STAGES}
    if unit not in tables["before"].values:
        return None
    before, after, floor = (tables[stage].finite_number(unit) for stage in STAGES[:3])
    return GapFigure(before, after, floor, _interval(tables["floor_95"], unit))


def _parse_next_test(index: TomlTable) -> NextTest | None:
    if index.values.get("next_test") is None:
        return None
    test = index.table("next_test")
    return NextTest(test.text("kind", None), test.text("why", None), test.finite_number("hours"))


def _numbers(table: TomlTable) -> dict[str, float]:
    return {name: table.finite_number(name) for name in table.values}


def _optional_number(table: TomlTable, key: str) -> float | None:
    return None if table.values.get(key) is None else table.finite_number(key)


def _interval(table: TomlTable, key: str) -> tuple[float, float]:
    low, high = table.numbers(key, 2, -math.inf, math.inf)
    if low > high:
        raise table.error(key, table.values[key], "[low, high]")
    return low, high


def _texts(table: TomlTable, key: str) -> tuple[str, ...]:
    texts = table.values.get(key)
    if not isinstance(texts, list) or not all(isinstance(text, str) for text in texts):
        raise table.error(key, texts, "a list of texts")
    return tuple(texts)
