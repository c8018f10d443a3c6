"""Plain words: a gloss is a sentence, a function is a verb, a constant says quantity and role."""

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

ROOT = Path(__file__).parents[2]
PACKAGES = ("fmu_build", "pyhrg", "ins_eval")
FRAGMENT = re.compile(r"(Of|The same|To which|By which|That|Those|From which|With which)\b")
"""Beginnings of a gloss that is no sentence about a quantity."""
RIDDLES = {
    "ALIKE",
    "CLOSE",
    "EASED",
    "FAR",
    "FEW",
    "LEAST",
    "LITTLE",
    "LIKELY",
    "MOST",
    "SURE",
    "ON",
}
"""Constants that say neither quantity nor role."""
IRREGULAR = {
    *("drawn", "flown", "found", "given", "gone", "heard", "held", "kept", "known", "left", "made"),
    *("seen", "shown", "spent", "spoilt", "taken", "told", "thrown", "written"),
}
NO_NOUNS = {"one", "told"}
"""Names that say nothing of a value."""
VERBS = {"embed", "exceed", "feed", "need", "proceed", "seed", "speed"}
"""Words that end as a participle does and are none."""


@cache
def files() -> list[tuple[str, ast.Module]]:
    return [
        (file.relative_to(ROOT).as_posix(), ast.parse(file.read_text(encoding="utf-8")))
        for package in PACKAGES
        for file in sorted((ROOT / package).rglob("*.py"))
    ]


def glosses(tree: ast.Module) -> Iterator[tuple[int, str]]:
    """Docstrings, and strings that stand below a constant or a field."""
    for node in ast.walk(tree):
        for statement in (
            getattr(node, "body", ()) if not isinstance(node, ast.Lambda | ast.IfExp) else ()
        ):
            value = getattr(statement, "value", None)
            is_text = isinstance(value, ast.Constant) and isinstance(value.value, str)
            if isinstance(statement, ast.Expr) and is_text:
                yield statement.lineno, value.value.strip()


def test_glosses_are_sentences() -> None:
    fragments = [
        f"{name}:{line}: {text.splitlines()[0]}"
        for name, tree in files()
        for line, text in glosses(tree)
        if FRAGMENT.match(text)
    ]
    assert fragments == []


def test_constants_say_quantity_and_role() -> None:
    riddles = [
        f"{name}:{node.lineno}: {target.id}"
        for name, tree in files()
        for node in tree.body
        if isinstance(node, ast.Assign | ast.AnnAssign)
        for assigned in (node.targets if isinstance(node, ast.Assign) else [node.target])
        for target in ast.walk(assigned)
        if isinstance(target, ast.Name) and target.id.lstrip("_") in RIDDLES
    ]
    assert riddles == []


def is_participle(name: str) -> bool:
    """Whether a name is one word that says what was done, not what it does. A property may."""
    return name in IRREGULAR or ("_" not in name and name.endswith("ed") and name not in VERBS)


def test_functions_are_verbs() -> None:
    participles = [
        f"{name}:{node.lineno}: {node.name}"
        for name, tree in files()
        for scope in (tree, *(node for node in tree.body if isinstance(node, ast.ClassDef)))
        for node in scope.body
        if isinstance(node, ast.FunctionDef) and not node.decorator_list
        if is_participle(node.name.strip("_"))
    ]
    assert participles == []


def test_values_have_nouns_for_names() -> None:
    nameless = [
        f"{name}:{node.lineno}"
        for name, tree in files()
        for node in ast.walk(tree)
        if (isinstance(node, ast.arg) and node.arg in NO_NOUNS)
        or (isinstance(node, ast.Name) and node.id in NO_NOUNS)
    ]
    assert nameless == []
