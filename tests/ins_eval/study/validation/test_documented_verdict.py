"""Tables of README and docs/validate.md have the figures of `hrg validate --seed 1`, as
docs/validation.json keeps them; that file is made by the command, which takes minutes."""

import json
import re
from pathlib import Path

import pytest

from pyhrg.common.pages.svg import format_estimate

ROOT = Path(__file__).parents[4]
RESULT = json.loads((ROOT / "docs/validation.json").read_text(encoding="utf-8"))
FIGURE = re.compile(r"-?\d[\d.]* \(-?\d[\d.]* to -?\d[\d.]*\)")
CLASSES = ("car", "aircraft with rolls")
NAMES = {
    "the same, bias at power-on taken out": "straight and level for an hour, bias at power-on",
    "self-calibrated in flight": "self-calibrated",
}
"""Names of conditions in the page that are not those of the command."""


def read_rows(page: str, head: str) -> list[list[str]]:
    """Cells of the rows of the table whose head begins so."""
    table = (ROOT / page).read_text(encoding="utf-8").split(f"\n{head}")[1].split("\n\n")[0]
    return [[cell.strip() for cell in row.split("|")[1:-1]] for row in table.splitlines()[2:]]


@pytest.mark.parametrize(
    ("page", "head"), [("README.md", "| claim | figure"), ("docs/validate.md", "| claim | requir")]
)
def test_figures_of_the_claims_are_of_the_command(page: str, head: str) -> None:
    rows = read_rows(page, head)
    assert len(rows) > 7
    scored = {name: set[str]() for name in CLASSES}
    for score in (s for c in RESULT["claims"]["mean"] for s in c["by_class"] + c["beside"]):
        value, low, high = format_estimate(score["value"], score["low"], score["high"])
        if (name := score["mission_class"]) in scored:
            scored[name].add(f"{value} ({low} to {high})".replace("\N{MINUS SIGN}", "-"))
    for row in rows:
        for name, cell in zip(CLASSES, row[-2:], strict=True):
            figures = FIGURE.findall(cell)
            assert figures, row
            for figure in figures:
                assert figure in scored[name], (row, figure)


def test_figures_of_the_conditions_are_of_the_command() -> None:
    rows = read_rows("docs/validate.md", "| condition | (a)")
    assert len(rows) == len(RESULT["conditions"]) == 7
    for row, condition in zip(rows, RESULT["conditions"], strict=True):
        assert condition["name"].startswith(NAMES.get(row[0], row[0]))
        figures = FIGURE.findall(" ".join(row[1:]))
        assert len(figures) > 2
        kept = json.dumps(condition["figures"], ensure_ascii=False).replace("\N{MINUS SIGN}", "-")
        for figure in figures:
            assert figure in kept, (row[0], figure)
