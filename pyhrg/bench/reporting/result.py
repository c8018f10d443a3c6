"""Results of a run: of one test, and of all tests."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar

import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from pyhrg.bench.figures import draw_in_place, move_legends
from pyhrg.bench.outcome import Outcome
from pyhrg.bench.procedure import Procedure
from pyhrg.bench.reporting import page
from pyhrg.bench.reporting.document import format_document, read_document
from pyhrg.bench.reporting.judgement import describe_unmatched_limits, judge_findings
from pyhrg.bench.reporting.parameter_system import make_table_1
from pyhrg.bench.reporting.text import format_outcome, format_section, format_table
from pyhrg.common.errors import HrgError, describe_briefly
from pyhrg.common.files import replace_folder, write_whole
from pyhrg.common.made_by import check_identity
from pyhrg.common.pages.markup import Table
from pyhrg.device import device_file
from pyhrg.device.device import Device
from pyhrg.records import campaign as campaigns
from pyhrg.records.campaign import Campaign

RESULT, PICTURE, DEVICE, PAGE = "result.json", "figure.png", "device.toml", "report.html"
COLUMNS = ("name", "value", "unit", "low_95", "high_95", "n", "target", "verdict", "note")
"""Columns of the findings' table."""


@dataclass(frozen=True)
class TestResult:
    """Result of one test of the bench.

    Attributes:
        procedure: the test.
        outcome: findings, tables and warnings of the test, in SI.
        records: the campaign that was evaluated; None where the result was read from a file.
        identity: device, digest of its parameters, seed and versions, by the keys of `result.json`.
        limits: limits of the specification, by the findings' keys.
        export: the device that the test makes (a calibrated one); None where it makes none.
    """

    __test__: ClassVar[bool] = False  # not one of pytest's

    procedure: Procedure
    outcome: Outcome
    records: Campaign | None
    identity: Mapping[str, Any]
    limits: Mapping[str, float] = field(default_factory=dict)
    export: Device | None = None

    @property
    def name(self) -> str:
        return self.procedure.name

    @property
    def seed(self) -> int | None:
        """Seed of the simulation; None where the records are not simulated."""
        return self.identity["seed"]

    @property
    def verdict(self) -> str:
        """What the findings mean, in a sentence or two."""
        return self.outcome.verdict

    @property
    def findings(self) -> pd.DataFrame:
        """Findings, indexed by key, in the units of column `unit`.

        `low_95` and `high_95` bound the 95 % interval; they are NaN where there is none, and `note`
        says why. `target` is the specification's limit, NaN without one, and `verdict` is `meets`,
        `fails`, `not decided` or `not measured`.
        """
        words = {j.finding.key: j.word for j in judge_findings(self.outcome, self.limits)}
        rows = {
            f.key: (
                *(f.name, f.value, f.unit, *f.interval, f.n),
                *(self.limits.get(f.key, math.nan), words.get(f.key, ""), f.note),
            )
            for f in self.outcome.findings
        }
        index = pd.Index(list(rows), name="key")
        return pd.DataFrame(list(rows.values()), columns=list(COLUMNS), index=index)

    @property
    def rows(self) -> pd.DataFrame:
        """Rows of the test's printed tables, with numbers as numbers; empty where there is none.
        Several tables stand one below the other, and a column `table` names each.
        """
        frames = [_make_frame(table) for table in self.outcome.tables]
        if len(frames) < 2:
            return frames[0] if frames else pd.DataFrame()
        for frame, table in zip(frames, self.outcome.tables, strict=True):
            frame.insert(0, "table", table.title)
        return pd.concat(frames, ignore_index=True)

    @property
    def points(self) -> pd.DataFrame:
        """Data points of a bias test (100 s means), with units in `attrs["units"]`. Empty for other
        tests and for results read from a file.

        Columns: `run`, `position`, `time_s`, `pattern_angle_deg` (0 to 180), `table_angle_deg`,
        `bias_deg_per_h` (output less Earth's rate), and its one-sigma `sigma_deg_per_h`. The sigma
        is the standard deviation within a position, pooled over positions and runs; NaN where each
        has one point. The figure of the full circumference shows `bias_without_tilt_deg_per_h`.
        """
        return self.outcome.points

    def plot(self, ax: Axes | None = None) -> list[Axes]:
        """Draw the test's figure.

        Args:
            ax: axes of a grid (`plt.subplots`) that the figure replaces; None makes a new figure.

        Returns:
            The axes that were drawn; their units are in the labels.

        Raises:
            HrgError: the test has no figure, or `ax` has no place in a grid.
        """
        if self.outcome.draw is None:
            raise HrgError(f"{self.name}: this test has no figure")
        return draw_in_place(self.outcome.draw, ax)

    def write(self, folder: Path | str) -> None:
        """Write `result.json` and `figure.png` into a folder; the logs too if they are simulated,
        and `device.toml` if the test makes a device. An earlier result in the folder is replaced
        as a whole.

        Raises:
            HrgError: the folder holds something else than a result.
            OSError: the folder can't be written.
        """
        check_folder(Path(folder))
        with replace_folder(Path(folder)) as aside:
            text = format_document(self.procedure, self.outcome, self.identity, self.limits)
            (aside / RESULT).write_text(text)
            if self.outcome.draw:
                figure = Figure(figsize=(8, 5), layout="constrained")
                self.outcome.draw(figure)
                move_legends(figure)
                figure.savefig(aside / PICTURE, dpi=120, metadata={"Software": None})
            if self.seed is not None and self.records is not None:
                campaigns.write_campaign(self.records, aside)
            if self.export:
                device_file.write(self.export, aside / DEVICE)

    def __str__(self) -> str:
        return format_section(self.procedure.title, format_outcome(self.outcome, self.limits))

    __repr__ = describe_briefly


@dataclass(frozen=True)
class TestFailure:
    """A test that gave no figures, and why."""

    __test__: ClassVar[bool] = False  # not one of pytest's

    procedure: Procedure
    reason: str

    def __str__(self) -> str:
        return format_section(self.procedure.title, self.reason)


@dataclass(frozen=True)
class BenchResults:
    """Results of several tests of one gyro.

    Attributes:
        subject: the gyro, and where its records are from.
        attempts: results and failures, in the order of the tests.
        limits: limits of the specification, by the findings' keys.
    """

    subject: str
    attempts: Sequence[TestResult | TestFailure]
    limits: Mapping[str, float] = field(default_factory=dict)

    @property
    def results(self) -> list[TestResult]:
        """Results of the tests that gave figures."""
        return [attempt for attempt in self.attempts if isinstance(attempt, TestResult)]

    @property
    def failures(self) -> dict[str, str]:
        """Reason of each test that gave no figures, by the test's name."""
        failed = [attempt for attempt in self.attempts if isinstance(attempt, TestFailure)]
        return {failure.procedure.name: failure.reason for failure in failed}

    def __getitem__(self, name: str) -> TestResult:
        for result in self.results:
            if result.name == name:
                return result
        reason = self.failures.get(name, "it was not among the tests")
        raise HrgError(f"{name}: no result; {reason}")

    @property
    def findings(self) -> pd.DataFrame:
        """Findings of all tests, indexed by test and key; columns as `TestResult.findings`."""
        parts = {result.name: result.findings for result in self.results}
        return pd.concat(parts, names=["test"])

    @property
    def parameter_system(self) -> pd.DataFrame:
        """The paper's Table 1, row by row: the figure and its test, or why there is none."""
        return _make_frame(self._make_table_1())

    def write(self, folder: Path | str) -> None:
        """Write report.html, and a folder for each test that gave figures.

        Raises:
            HrgError, OSError: see `TestResult.write`.
        """
        for result in self.results:
            result.write(Path(folder) / result.name)
        self.write_page(Path(folder))

    def write_page(self, folder: Path) -> None:
        """Write report.html alone; its figures are those in the tests' folders."""
        title, notes = f"HRG bench: {self.subject}", self._list_unmatched()
        sections = [
            page.make_section(a.procedure, a.outcome, self.limits, _find_picture(folder, a.name))
            if isinstance(a, TestResult)
            else page.make_failure_section(a.procedure, a.reason)
            for a in self.attempts
        ]
        overview = self._make_table_1() if len(self.attempts) > 1 else None
        text = page.make_page(title, overview, sections, notes)
        write_whole(folder / PAGE, text.encode())

    def __str__(self) -> str:
        sections = [f"HRG bench: {self.subject}", *map(str, self.attempts)]
        sections += [format_table(self._make_table_1())] if len(self.attempts) > 1 else []
        return "\n\n".join([*sections, *self._list_unmatched()])

    __repr__ = describe_briefly

    def _make_table_1(self) -> Table:
        return make_table_1({result.name: result.outcome for result in self.results})

    def _list_unmatched(self) -> list[str]:
        """Sentences on limits that no finding was compared with; none for a single test, whose
        specification may well limit the findings of other tests."""
        if len(self.attempts) < 2:
            return []
        unmatched = describe_unmatched_limits([r.outcome for r in self.results], self.limits)
        return [f"Specification: {sentence}" for sentence in unmatched]


def read_result(folder: Path, procedure: Procedure, identity: Mapping[str, Any]) -> TestResult:
    """The result of a procedure in a folder, without records and figure.

    Raises:
        HrgError: the file can't be read, or has another identity.
    """
    check_identity(folder / RESULT, identity)
    outcome, limits = read_document(folder / RESULT)
    return TestResult(procedure, outcome, None, identity, limits)


def _find_picture(folder: Path, name: str) -> str:
    """Path of a test's figure from the page's folder; empty where there is none."""
    return f"{name}/{PICTURE}" if (folder / name / PICTURE).is_file() else ""


def check_folder(folder: Path) -> None:
    """Refuse a folder that a result must not replace."""
    if not folder.exists() or (folder / RESULT).is_file():
        return
    if not folder.is_dir() or any(folder.iterdir()):
        raise HrgError(
            f"{folder}: found what is no result of a bench test, expected one or nothing"
        )


def _make_frame(table: Table) -> pd.DataFrame:
    """A printed table as a DataFrame: columns of numbers as numbers, its title in `attrs`."""
    frame = pd.DataFrame(list(table.rows), columns=list(table.header))
    for column in frame.columns:
        numbers = pd.to_numeric(frame[column], errors="coerce")
        if numbers.notna().all():
            frame[column] = numbers
    frame.attrs["title"] = table.title
    return frame
