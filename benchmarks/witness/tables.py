"""Tables of docs/witness-results.md from the rows of flights."""

from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np
import pandas as pd

from benchmarks.witness.flown import NONE, SEED, read_flights
from ins_eval.study.gyros.drawn_triad import AXES
from ins_eval.study.scores.resampling import Estimate, bootstrap
from ins_eval.study.tables.score import ALL
from ins_eval.study.witness.judge import (
    CORRECTED,
    COVERAGE,
    NEES,
    POSITION_NEES,
    R2,
    SHUFFLED,
    WORST,
    WitnessScore,
    compute_worst_tenth,
    score_witnesses,
)
from pyhrg.common.arrays import Array
from pyhrg.common.files import write_whole

PAGE = Path("docs/witness-results.md")
BEGIN, END = "<!-- flown -->", "<!-- /flown -->"
"""Lines of the page between which `python -m benchmarks.witness tables` writes."""
OVER_CLASSES = {
    "R2, estimated": (R2, "estimated"),
    "R2, bench's maps": (R2, "known"),
    "R2, bound": (R2, "bound"),
    "R2, true maps": (R2, "true"),
    "coverage of 90 % intervals, estimated": (COVERAGE, "estimated"),
    "corrected over uncorrected, estimated": (CORRECTED, "by_channels"),
    "by the bench's maps": (CORRECTED, "by_bench"),
    "by the bound": (CORRECTED, "by_bound"),
    "by the true maps": (CORRECTED, "by_true"),
    "with another triad's channels": (CORRECTED, SHUFFLED),
    "worst tenth, estimated": (WORST, "by_channels"),
    "worst tenth, bench's maps": (WORST, "by_bench"),
    "worst tenth, bound": (WORST, "by_bound"),
    "worst tenth, true maps": (WORST, "by_true"),
    "NEES of the changes": (NEES, "estimated"),
    "NEES of the position error": (POSITION_NEES, "estimated"),
}
"""Rows of the table over all classes: their score, and what it is of."""
BY_CLASS = {
    "by the bench's maps": (CORRECTED, "by_bench"),
    "by the channels": (CORRECTED, "by_channels"),
    "bound": (CORRECTED, "by_bound"),
    "true maps": (CORRECTED, "by_true"),
    "NEES of the changes": (NEES, "estimated"),
    "NEES of the position": (POSITION_NEES, "estimated"),
}
"""Columns of the table by class."""
SEALED = {
    "bench's maps": ("by_bench", "flown"),
    "channels": ("by_channels", "flown"),
    "bound": ("by_bound", "flown"),
    "true maps": ("by_true", "flown"),
    "channels, over the bench's maps": ("by_channels", "by_bench"),
}
"""Corrections of flights with effects outside the model, each over another flight."""
LEAST = 2
"""Smallest number of triads of which an interval is given."""


def write_tables() -> str:
    """Put the tables of all rows into `PAGE`, and return them."""
    text = "\n\n".join(make_tables(read_flights()))
    page = PAGE.read_text()
    before, rest = page.split(BEGIN)
    _, after = rest.split(END)
    write_whole(PAGE, f"{before}{BEGIN}\n{text}\n{END}{after}".encode())
    return text


def make_tables(flights: pd.DataFrame) -> Iterator[str]:
    """Tables of each calibration, without and with effects outside the model."""
    sealed = flights["effects"] != NONE
    for calibration, rows in flights[~sealed].groupby("calibration"):
        yield f"**Rows of docs/witness-flown.csv, {calibration} calibration.** {_count(rows)}"
        yield _tabulate_classes(rows)
        yield from _tabulate_all(rows)
    for calibration, rows in flights[sealed].groupby("calibration"):
        if rows["triad"].nunique() >= LEAST:
            yield f"**Forms outside the model, {calibration} calibration.** {_count(rows)}"
            yield _tabulate_sealed(rows)


def _count(rows: pd.DataFrame) -> str:
    triads = sorted(rows["triad"].unique())
    commits = ", ".join(f"`{each}`" for each in sorted(rows["commit"].unique()))
    return (
        f"{len(triads)} triads (numbers {triads[0]} to {triads[-1]}), {len(rows)} flights of two "
        f"hours, commit {commits}."
    )


def _tabulate_classes(rows: pd.DataFrame) -> str:
    """Ratios and NEES by class; each class has the triads that flew it."""
    lines = []
    for name, part in rows.groupby("mission_class", sort=False):
        scores = _index(score_witnesses(part, SEED))
        lines += [
            [str(name), _name_start(test), str(part["triad"].nunique())]
            + [f"{scores[test, *key].value:.3f}" for key in BY_CLASS.values()]
            for test in sorted(part["self_test_s"].unique())
        ]
    return _format(["class", "self-test", "triads", *BY_CLASS], lines)


def _tabulate_all(rows: pd.DataFrame) -> Iterator[str]:
    """Scores over all flights, each of a triad and mission of its own; none if they are too few."""
    triads = rows["triad"].nunique()
    if triads < LEAST:
        return
    scores = _index(score_witnesses(rows.assign(mission=ALL, mission_class=ALL), SEED))
    tests = sorted(rows["self_test_s"].unique())
    lines = [
        [name, *(_format_score(scores[test, *key]) for test in tests)]
        for name, key in OVER_CLASSES.items()
    ]
    yield f"All classes, with 95 % intervals over {triads} triads:"
    yield _format(["", *(_name_start(test) for test in tests)], lines)


def _tabulate_sealed(rows: pd.DataFrame) -> str:
    """Errors of corrected flights over those of others, and how many gyros' logs are followed."""
    lines = []
    for test, part in rows.groupby("self_test_s"):
        table = part.sort_values("triad")
        for title, (name, other) in SEALED.items():
            ratios = _compute_sizes(table, name) / _compute_sizes(table, other)
            worst = bootstrap(compute_worst_tenth, [ratios], SEED)
            lines.append(
                [
                    title,
                    _name_start(test),
                    f"{np.median(ratios):.2f}",
                    _format_score(worst),
                    f"{ratios.max():.2f}",
                    f"{table['followed'].sum():.0f} of {AXES * len(table)}",
                ]
            )
    heading = ["corrected by", "self-test", "median", "worst tenth", "largest", "logs followed"]
    return _format(heading, lines)


def _compute_sizes(table: pd.DataFrame, name: str) -> Array:
    """(r, 1) horizontal errors of r flights, m."""
    sizes = np.hypot(table[f"{name}_north_m"], table[f"{name}_east_m"]).to_numpy()
    return np.asarray(sizes.reshape(-1, 1))


def _index(scores: Sequence[WitnessScore]) -> dict[tuple[float, str, str], WitnessScore]:
    """Scores over all classes, by self-test, score and what it is of."""
    return {(s.self_test_s, s.score, s.of): s for s in scores if s.mission_class == ALL}


def _format_score(score: WitnessScore | Estimate) -> str:
    return f"{score.value:.2f} ({score.low:.2f} to {score.high:.2f})"


def _name_start(test: float) -> str:
    return f"{test:g} s" if test else "none"


def _format(heading: Sequence[str], lines: Sequence[Sequence[str]]) -> str:
    """A table in Markdown."""
    rows = [heading, ["---"] * len(heading), *lines]
    return "\n".join(f"| {' | '.join(row)} |" for row in rows)
