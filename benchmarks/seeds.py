"""Campaigns of a good laboratory, counted over all seeds.

    python benchmarks/seeds.py [FOLDER COMMIT]

Prints the two tables of docs/gap-results.md that are made of docs/gap-seeds.csv. With the folder of
a finished challenge and the commit that diagnosed it, a line of that file is added first.
"""

import csv
import io
import sys
from collections.abc import Sequence
from pathlib import Path

from pyhrg.challenge.roster import Folder
from pyhrg.challenge.run import read_finished
from pyhrg.challenge.scoring.figure import Figure, proportion
from pyhrg.challenge.scoring.report import SIGNS, Finished
from pyhrg.challenge.scoring.score import score_figures
from pyhrg.common.files import write_whole

FILE = Path(__file__).parents[1] / "docs" / "gap-seeds.csv"
TITLES = {
    "false alarm without a gap": "no false alarm",
    "single: right effect or its class": "one effect",
    "pair: right effects or their classes": "two effects",
    "several: all named": "3 to 8: all named",
    "several: none invented": "3 to 8: none invented",
    "where: gyro, nominal, bench or record": "where",
    "outside: recognised": "outside: recognised",
    "outside: a term in the right coordinate": "outside: right coordinate",
    "a term where there is none": "no term without a cause",
    "false discovery rate of names": "right names",
    "95 % intervals that cover": "intervals that hold",
}
"""Figures that are counted, and the heads of their columns in the table by seed."""
Row = dict[str, str]


def read_rows() -> list[Row]:
    """A row for each seed: seed, commit, and for each figure its hits and its number."""
    with FILE.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def count(finished: Finished, commit: str) -> Row:
    """The row of a finished challenge."""
    seed = finished.settings.seed
    row = {"seed": str(seed), "commit": commit}
    for figure in score_figures(finished.cases, seed):
        if figure.name in TITLES:
            hits = round(figure.value * figure.n) if figure.n else 0
            row |= {f"{figure.name}: yes": str(hits), f"{figure.name}: of": str(figure.n)}
    return row


def write_rows(rows: Sequence[Row]) -> None:
    """Write the file, whole or not at all."""
    text = io.StringIO()
    writer = csv.DictWriter(text, [*rows[0]], lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    write_whole(FILE, text.getvalue())


def pool(rows: Sequence[Row]) -> list[Figure]:
    """The figures over all seeds, with exact intervals."""
    targets = {figure.name: figure for figure in score_figures([], 0)}
    figures = []
    for name in TITLES:
        hits, n = (sum(int(row[f"{name}: {key}"] or 0) for row in rows) for key in ("yes", "of"))
        outcomes = [True] * hits + [False] * (n - hits)
        figures.append(proportion(name, outcomes, targets[name].sense, targets[name].target))
    return figures


def format_pooled(figures: Sequence[Figure]) -> list[str]:
    """Lines of the table of all seeds."""
    lines = ["| figure | target | all seeds | campaigns |", "|---|---|---|---|"]
    for f in figures:
        target = f"{SIGNS[f.sense]} {f.target:g}".removeprefix("= ")
        share = f"{f.value:.3f} ({f.low:.3f} to {f.high:.3f})"
        lines.append(f"| {f.name} | {target} | {share} | {f.n} |")
    return lines


def format_by_seed(rows: Sequence[Row], figures: Sequence[Figure]) -> list[str]:
    """Lines of the table by seed: how many are right, of how many."""

    def tell(name: str, hits: str, n: str) -> str:
        is_wrong = targets[name].sense == "at most"
        return f"{int(n) - int(hits) if is_wrong else hits}/{n}" if n else "-"

    targets = {figure.name: figure for figure in figures}
    total = {f.name: (str(round(f.value * f.n)), str(f.n)) for f in figures}
    lines = [
        "| seed | commit | " + " | ".join(TITLES.values()) + " |",
        "|---" * (len(TITLES) + 2) + "|",
    ]
    for row in rows:
        own = (tell(name, row[f"{name}: yes"], row[f"{name}: of"]) for name in TITLES)
        lines.append(f"| {row['seed']} | {row['commit']} | " + " | ".join(own) + " |")
    all_of_them = (f"**{tell(name, *total[name])}**" for name in TITLES)
    return [*lines, "| **all** | | " + " | ".join(all_of_them) + " |"]


def main(arguments: Sequence[str]) -> None:
    rows = read_rows()
    if arguments:
        folder, commit = arguments
        new = count(read_finished(Folder(Path(folder))), commit)
        rows = [*(row for row in rows if row["seed"] != new["seed"]), new]
        write_rows(rows)
    figures = pool(rows)
    print("\n".join(["", *format_pooled(figures), "", *format_by_seed(rows, figures)]))


if __name__ == "__main__":
    main(sys.argv[1:])
