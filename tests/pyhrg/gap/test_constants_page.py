"""`docs/methods/constants.md` names every chosen constant of these folders, and no other."""

import ast
import re
from itertools import pairwise
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]
PAGE = ROOT / "docs" / "methods" / "constants.md"
GAP = ROOT / "pyhrg" / "gap"
SECTIONS = {
    "Replay": ("replay",),
    "Soundness": ("soundness",),
    "Whitening": ("whitening",),
    "Effects": ("effects",),
    "Evidence": ("evidence",),
    "Findings and closing": ("findings", "closing"),
    "Next test": ("next_test",),
    "A static record": ("static_record",),
}
ORIGIN = re.compile(r"\b(chosen|derived|tuned)\b", re.IGNORECASE)


def chosen(folder: Path) -> set[tuple[str, str]]:
    """File and name of each constant whose gloss says that it was chosen or derived."""
    names = set()
    for file in folder.rglob("*.py"):
        body = ast.parse(file.read_text(encoding="utf-8")).body
        for node, after in pairwise(body):
            if isinstance(node, ast.Assign) and isinstance(after, ast.Expr):
                gloss = str(ast.literal_eval(after.value))
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


def test_every_choice_has_its_reason() -> None:
    rows = re.findall(r"^\| `.*\|$", PAGE.read_text(encoding="utf-8"), re.M)
    assert len(rows) > 100
    assert [row for row in rows if re.search(r"\| (chosen|derived|tuned) \|$", row)] == []


@pytest.mark.parametrize("section", SECTIONS)
def test_every_chosen_constant_is_on_the_page(section: str) -> None:
    folders = [GAP / name for name in SECTIONS[section]]
    missing = set.union(*(chosen(folder) for folder in folders)) - listed(section)
    assert missing == set()


@pytest.mark.parametrize("section", SECTIONS)
def test_every_constant_of_the_page_is_there(section: str) -> None:
    files = [file for name in SECTIONS[section] for file in (GAP / name).rglob("*.py")]
    texts = {file.stem: file.read_text(encoding="utf-8") for file in files}
    for file, name in listed(section):
        assert re.search(rf"^.*\b{name}\b.* = ", texts[file], re.M), f"{file}: {name}"
