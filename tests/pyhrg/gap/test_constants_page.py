"""`docs/methods/constants.md` names every chosen constant of these folders, and no other."""

import ast
import re
from itertools import pairwise
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]
PAGE = ROOT / "docs" / "methods" / "constants.md"
SECTIONS = {
    "Evidence": ("evidence", "evidence/noise"),
    "Findings and closing": ("findings", "closing"),
    "Next test": ("next_test",),
}
ORIGIN = re.compile(r"\b(Chosen|Derived)\b")


def chosen(folder: Path) -> set[tuple[str, str]]:
    """File and name of each constant whose gloss says that it was chosen or derived."""
    names = set()
    for file in folder.glob("*.py"):
        body = ast.parse(file.read_text(encoding="utf-8")).body
        for node, after in pairwise(body):
            if isinstance(node, ast.Assign) and isinstance(after, ast.Expr):
                gloss = ast.unparse(after)
                names |= {
                    (file.stem, name.id)
                    for name in ast.walk(node.targets[0])
                    if isinstance(name, ast.Name) and ORIGIN.search(gloss)
                }
    return names


def listed(section: str) -> set[tuple[str, str]]:
    text = PAGE.read_text(encoding="utf-8").split(f"\n## {section}\n")[1].split("\n## ")[0]
    rows = re.findall(r"^\| `(\w+)` \| (`[A-Z].*?) \|", text, re.M)
    return {(file, name) for file, names in rows for name in re.findall(r"`(\w+)`", names)}


@pytest.mark.parametrize("section", SECTIONS)
def test_every_chosen_constant_is_on_the_page(section: str) -> None:
    folders = [ROOT / "pyhrg" / "gap" / name for name in SECTIONS[section]]
    missing = set.union(*(chosen(folder) for folder in folders)) - listed(section)
    assert missing == set()


@pytest.mark.parametrize("section", SECTIONS)
def test_every_constant_of_the_page_is_there(section: str) -> None:
    folders = [ROOT / "pyhrg" / "gap" / name for name in SECTIONS[section]]
    files = {file.stem: file.read_text("utf-8") for f in folders for file in f.glob("*.py")}
    for file, name in listed(section):
        assert re.search(rf"^.*\b{name}\b.* = ", files[file], re.M), f"{file}: {name}"
