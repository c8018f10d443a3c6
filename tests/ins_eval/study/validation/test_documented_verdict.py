"""Tables of README and docs/validate.md have the figures that `hrg validate --seed 1` prints, as
docs/validation.txt keeps them; that file is made by the command, which takes minutes."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[4]
PRINTED = (ROOT / "docs/validation.txt").read_text(encoding="utf-8")
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
def test_figures_of_the_claims_are_printed(page: str, head: str) -> None:
    rows = read_rows(page, head)
    assert len(rows) > 7
    for row in rows:
        for name, cell in zip(CLASSES, row[-2:], strict=True):
            figures = FIGURE.findall(cell)
            assert figures, row
            for figure in figures:
                assert f"{name} {figure}" in PRINTED, (row, figure)


def test_figures_of_the_conditions_are_printed() -> None:
    conditions = PRINTED.split("(d) The claims in other conditions:\n  ")[1].split("\n  ")
    blocks = re.split(r"\n  (?=\S)", "\n  ".join(conditions))
    rows = read_rows("docs/validate.md", "| condition | (a)")
    assert len(rows) == len(blocks) == 7
    for row, block in zip(rows, blocks, strict=True):
        assert block.startswith(NAMES.get(row[0], row[0]))
        figures = FIGURE.findall(" ".join(row[1:]))
        assert len(figures) > 2
        for figure in figures:
            assert figure in block, (row[0], figure)
