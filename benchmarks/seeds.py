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
    "false alarm without a gap": "false alarms",
    "single: right effect or its class": "one effect right",
    "pair: right effects or their classes": "two effects right",
    "several: all named": "3 to 8: all named",
    "several: none invented": "3 to 8: none invented",
    "where: gyro, nominal, bench or record": "where right",
    "outside: recognised": "outside: recognised",
    "outside: a term in the right coordinate": "outside: right coordinate",
    "a term where there is none": "false terms",
    "false discovery rate of names": "false names",
    "95 % intervals that cover": "intervals that cover",
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
    write_whole(FILE, text.getvalue().encode())


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
    lines = ["| figure | target | all these seeds | n |", "|---|---|---|---|"]
    for f in figures:
        target = f"{SIGNS[f.sense]} {f.target:.2f}".removeprefix("= ")
        share = f"{f.value:.3f} ({f.low:.3f} to {f.high:.3f})"
        lines.append(f"| {f.name} | {target} | {share} | {f.n} |")
    return lines


def format_by_seed(rows: Sequence[Row], figures: Sequence[Figure]) -> list[str]:
    """Lines of the table by seed: what each figure counts, of how many."""
    lines = [
        "| seed | commit | " + " | ".join(TITLES.values()) + " |",
        "|---" * (len(TITLES) + 2) + "|",
    ]
    for row in rows:
        pairs = ((row[f"{name}: yes"], row[f"{name}: of"]) for name in TITLES)
        own = (f"{hits}/{n}" if n else "-" for hits, n in pairs)
        lines.append(f"| {row['seed']} | {row['commit']} | " + " | ".join(own) + " |")
    totals = (f"**{round(f.value * f.n)}/{f.n}**" for f in figures)
    return [*lines, "| **all** | | " + " | ".join(totals) + " |"]


def main(arguments: Sequence[str]) -> None:
    rows = read_rows()
    if arguments:
        folder, commit = arguments
        finished = read_finished(Folder(Path(folder)))
        settings = finished.settings
        if (settings.level, settings.data) != ("good-lab", "full"):
            sys.exit(f"{folder}: found {settings.level}, {settings.data}, expected good-lab, full")
        if any(row["seed"] == str(settings.seed) for row in rows):
            sys.exit(f"{folder}: seed {settings.seed} is counted already")
        rows.append(count(finished, commit))
        write_rows(rows)
    figures = pool(rows)
    print("\n".join(["", *format_pooled(figures), "", *format_by_seed(rows, figures)]))


if __name__ == "__main__":
    main(sys.argv[1:])
