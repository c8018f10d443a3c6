"""Reads a `diagnosis.json` back into a `Diagnosis`."""

from pathlib import Path
from typing import cast, get_args

from pyhrg.common.toml_table import TomlTable, read_json_table
from pyhrg.device.declarations import Family
from pyhrg.gap.findings.diagnosis import (
    FILE,
    SCHEMA,
    Cause,
    Diagnosis,
    Gap,
    GapFigure,
    KnownValue,
    NextTest,
    Verdict,
    Worth,
)
from pyhrg.gap.findings.localisation import Place
from pyhrg.gap.findings.quantity import Size
from pyhrg.gap.findings.term import parse_term
from pyhrg.gap.findings.values import (
    FIGURE_UNITS,
    ROLES,
    STAGES,
    parse_interval,
    parse_numbers,
)


def read_diagnosis(path: Path | str) -> Diagnosis:
    """Read a campaign's diagnosis; what `write` wrote is read back as it was.

    Args:
        path: a `diagnosis.json`, or the folder that holds one.

    Raises:
        DiagnosisError: an unreadable file, one that is no diagnosis, or that of a static record.
    """
    path = Path(path)
    return _parse(read_json_table(path / FILE if path.is_dir() else path))


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
        parse_numbers(index.table("unnamed")),
        index.texts("excluded"),
        index.flag("settled", True),
        tuple(map(_parse_known, index.tables("within_tolerance"))),
        _parse_worth(index.table("material").table("left")),
        _parse_worth(index.table("material").table("bound")),
        tuple(map(parse_term, index.tables("terms"))),
    )


def _parse_worth(table: TomlTable) -> Worth:
    names = ("angle_arcsec", "rate_deg_h", "loop_share")
    angle, rate, share = (table.finite_number(n) if table.values else 0.0 for n in names)
    return Worth(angle, rate, share, table.text("loop_channel", ""))


def _parse_cause(table: TomlTable) -> Cause:
    intervals = table.table("interval_95")
    return Cause(
        table.text("effect", None),
        table.number("probability", None, 0.0, 1.0),
        parse_numbers(table.table("parameters")),
        {name: parse_interval(intervals, name) for name in intervals.values},
        table.texts("equivalents"),
        _parse_family(table),
        _parse_worth(worth) if (worth := table.table("worth")).values else None,
    )


def _parse_family(table: TomlTable) -> Family:
    return cast(Family, table.text("family", "gyro", get_args(Family)))


def _parse_known(table: TomlTable) -> KnownValue:
    return KnownValue(
        table.text("name", None),
        _parse_family(table),
        table.text("parameter", None),
        table.finite_number("value"),
        table.finite_number("stated"),
        parse_interval(table, "interval_95"),
        table.finite_number("tolerance"),
        parse_numbers(table.table("parameters")),
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
    (fit_angle, fit_rate, _), (angle, rate, area) = (
        [_parse_figure(table, role, unit) for unit in FIGURE_UNITS] for role in ROLES
    )
    if fit_angle is None:
        raise table.table("before").table("fit").missing("angle_arcsec", "a number")
    shrink, whiteness = (table.optional_number(k) for k in ("shrink_percent", "whiteness"))
    return Gap(fit_angle, fit_rate, angle, rate, shrink, whiteness, area)


def _parse_figure(gap: TomlTable, role: str, unit: str) -> GapFigure | None:
    tables = {stage: gap.table(stage).table(role) for stage in STAGES}
    if unit not in tables["before"].values:
        return None
    before, after, floor = (tables[stage].finite_number(unit) for stage in STAGES[:3])
    return GapFigure(before, after, floor, parse_interval(tables["floor_95"], unit))


def _parse_next_test(index: TomlTable) -> NextTest | None:
    if index.values.get("next_test") is None:
        return None
    test = index.table("next_test")
    return NextTest(test.text("kind", None), test.text("why", None), test.finite_number("hours"))
