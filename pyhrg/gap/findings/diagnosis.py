"""A diagnosis as data, and its file: the campaign format's `diagnosis.json`, written and read."""

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any, Literal, cast, get_args

from pyhrg.common.errors import HrgError
from pyhrg.common.files import write_whole
from pyhrg.common.toml_table import TomlTable, read_json_table
from pyhrg.device.declarations import Family
from pyhrg.gap.findings.localisation import Place
from pyhrg.gap.findings.quantity import Size
from pyhrg.gap.findings.term import Term, parse_term
from pyhrg.gap.findings.values import (
    FIGURE_UNITS,
    ROLES,
    STAGES,
    make_gap_table,
    parse_interval,
    parse_numbers,
    parse_optional_number,
    parse_texts,
)

SCHEMA = "hrg-diagnosis/1"
FILE = "diagnosis.json"
WORSE_RATIO = 1.1
"""Closing has made the simulation worse when the residual after it exceeds the one before by this
factor. Chosen."""
UNSETTLED = "The search did not converge: every statement of this diagnosis is uncertain."
WORSE = (
    "Closing takes the simulation further away from the records: the named causes stand in for "
    "something that the catalogue does not hold."
)
Verdict = Literal["no_gap", "explained", "ambiguous", "unexplained"]


class DiagnosisError(HrgError):
    """The file is no diagnosis; the message names file, key, found and expected."""


@dataclass(frozen=True)
class Cause:
    """An effect that takes part, or a known parameter that is off by more than its tolerance.

    probability: posterior probability that it, or one of its equivalents, takes part; for a known
        parameter, that it is off by more than its tolerance.
    parameters: total values by the format's names, in its units.
    interval_95: 95 % interval of each parameter, in the same units.
    equivalents: effects that are confounded with it in these tests.
    family: what is wrong: the gyro, a nominal value, the bench or the record.
    """

    effect: str
    probability: float
    parameters: Mapping[str, float] = field(default_factory=dict)
    interval_95: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    equivalents: tuple[str, ...] = ()
    family: Family = "gyro"

    @property
    def equivalence_class(self) -> frozenset[str]:
        """The effect and its equivalents."""
        return frozenset((self.effect, *self.equivalents))


@dataclass(frozen=True)
class KnownValue:
    """A parameter known within a tolerance, as the tests show it: off, but by no more than that.

    value, told: total value, and the one that was told, in the unit of the parameter's name.
    interval_95: of the value.
    tolerance: one standard deviation of the value about the told one.
    """

    name: str
    family: Family
    parameter: str
    value: float
    told: float
    interval_95: tuple[float, float]
    tolerance: float


@dataclass(frozen=True)
class GapFigure:
    """Root mean square of a residual before and after closing.

    floor: what noise alone would leave of a perfect simulation (median of draws).
    floor_95: 95 % interval of the floor.
    """

    before: float
    after: float
    floor: float
    floor_95: tuple[float, float]


@dataclass(frozen=True)
class Gap:
    """Size of the gap on the tests that were fitted to and on the held-out ones.

    fit_angle_arcsec, holdout_angle_arcsec: residual of the output angle.
    fit_rate_deg_h, holdout_rate_deg_h: residual of the rate over 100 s; None where all tests are
        shorter.
    shrink_percent: share of the excess over the floor that closing removes, in the angle of the
        held-out tests; None without such tests or without an excess.
    whiteness: p-value that the whitened residual of the held-out tests is white.
    """

    fit_angle_arcsec: GapFigure
    fit_rate_deg_h: GapFigure | None
    holdout_angle_arcsec: GapFigure | None
    holdout_rate_deg_h: GapFigure | None
    shrink_percent: float | None
    whiteness: float | None

    @property
    def is_wider(self) -> bool:
        """Whether closing has moved the simulation away from the tests that it was fitted to."""
        fit = self.fit_angle_arcsec
        return fit.after > max(WORSE_RATIO * fit.before, fit.floor_95[1])


@dataclass(frozen=True)
class NextTest:
    """The test that would best separate what is still confounded.

    hours: duration of this test that is enough.
    """

    kind: str
    why: str
    hours: float


@dataclass(frozen=True)
class Diagnosis:
    """All that a diagnosis says.

    unknown_probability: posterior probability that something outside the catalogue takes part.
    where: shares of the residual's excess power, the largest first.
    sizes: the gap in sigma, by test, channel and time scale.
    unnamed: what takes part outside the catalogue, in words, with posterior probabilities.
    excluded: what of the campaign was missing or left out, a sentence each.
    settled: whether the search converged; everything is uncertain where it did not.
    within_tolerance: known parameters that are off, but by no more than their tolerance.
    terms: proposed equations for what has no name.
    """

    device: str
    verdict: Verdict
    causes: tuple[Cause, ...]
    unknown_probability: float
    where: tuple[Place, ...]
    sizes: tuple[Size, ...]
    gap: Gap
    next_test: NextTest | None
    unnamed: Mapping[str, float]
    excluded: tuple[str, ...]
    settled: bool = True
    within_tolerance: tuple[KnownValue, ...] = ()
    terms: tuple[Term, ...] = ()

    @property
    def caveats(self) -> list[str]:
        """Sentences on what makes the whole diagnosis uncertain."""
        return [
            *([] if self.settled else [UNSETTLED]),
            *([WORSE] if self.gap.is_wider else []),
        ]

    def document(self) -> dict[str, Any]:
        """The content of `diagnosis.json`."""
        values = asdict(self)
        for place in values["where"]:
            if place["harmonic"] is None:
                del place["harmonic"]
        gap = values.pop("gap")
        return {"schema": SCHEMA, **values, "gap": make_gap_table(gap)}


def write(diagnosis: Diagnosis, folder: Path) -> None:
    """Write `diagnosis.json`, whole or not at all."""
    text = json.dumps(diagnosis.document(), indent=1, allow_nan=False) + "\n"
    write_whole(folder / FILE, text.encode())


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
        parse_numbers(index.table("unnamed")),
        parse_texts(index, "excluded"),
        index.flag("settled", True),
        tuple(map(_parse_known, index.tables("within_tolerance"))),
        tuple(map(parse_term, index.tables("terms"))),
    )


def _parse_cause(table: TomlTable) -> Cause:
    intervals = table.table("interval_95")
    return Cause(
        table.text("effect", None),
        table.number("probability", None, 0.0, 1.0),
        parse_numbers(table.table("parameters")),
        {name: parse_interval(intervals, name) for name in intervals.values},
        parse_texts(table, "equivalents"),
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
        parse_interval(table, "interval_95"),
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
    ends = (parse_optional_number(table, key) for key in ("shrink_percent", "whiteness"))
    return Gap(fit_angle, fit_rate, holdout_angle, holdout_rate, *ends)


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
