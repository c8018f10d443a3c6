"""The shape of the house: short files and functions, few files side by side, shallow imports."""

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from statistics import median

ROOT = Path(__file__).parents[2]
PACKAGES = ("fmu_build", "pyhrg", "ins_eval")
MOST_LINES = 300
MOST_FUNCTION_LINES = 60
MOST_FILES = 12
"""Python files side by side in a folder, `__init__.py` aside; about ten is the aim."""
MOST_DEPTH = 8
"""Length of the longest chain of imports among what stands side by side in one folder."""


@cache
def modules() -> dict[str, Path]:
    """Every module of the packages, by its dotted name."""
    names = {}
    for package in PACKAGES:
        for file in sorted((ROOT / package).rglob("*.py")):
            parts = file.relative_to(ROOT).with_suffix("").parts
            names[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = file
    return names


@cache
def tree(file: Path) -> ast.Module:
    return ast.parse(file.read_text(encoding="utf-8"))


def imported(file: Path) -> Iterator[str]:
    """Names of our modules that a file imports."""
    for node in ast.walk(tree(file)):
        if isinstance(node, ast.ImportFrom) and node.module:
            for alias in node.names:
                name = f"{node.module}.{alias.name}"
                yield name if name in modules() else node.module
        elif isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)


def rooms() -> Iterator[tuple[str, dict[str, set[str]]]]:
    """Each package, and for each of its children the siblings that it imports."""
    for package in (name for name, file in modules().items() if file.name == "__init__.py"):
        inside = f"{package}."
        children: dict[str, set[str]] = {}
        for name, file in modules().items():
            if not name.startswith(inside):
                continue
            child = name.removeprefix(inside).split(".")[0]
            uses = (
                n.removeprefix(inside).split(".")[0]
                for n in imported(file)
                if n[: len(inside)] == inside
            )
            children.setdefault(child, set()).update(use for use in uses if use != child)
        yield package, children


def depth(child: str, children: dict[str, set[str]], above: tuple[str, ...] = ()) -> int:
    assert child not in above, f"a circle of imports: {' -> '.join((*above, child))}"
    uses = children.get(child, set())
    return 1 + max((depth(use, children, (*above, child)) for use in uses), default=0)


def test_files_are_short() -> None:
    """Python and C of the packages, their tests and benchmarks, and the Modelica libraries."""
    written = (
        file
        for folder in (*PACKAGES, "tests", "benchmarks", "modelica")
        for file in (ROOT / folder).rglob("*")
        if file.suffix in (".py", ".c", ".h", ".mo")
    )
    counts = {file.relative_to(ROOT): len(file.read_text().splitlines()) for file in written}
    assert {name: n for name, n in counts.items() if n > MOST_LINES} == {}


def test_functions_are_short() -> None:
    long = {}
    for name, file in modules().items():
        for node in ast.walk(tree(file)):
            if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
                lines = (node.end_lineno or node.lineno) - node.lineno + 1
                if lines > MOST_FUNCTION_LINES:
                    long[f"{name}.{node.name}"] = lines
    assert long == {}


def test_few_files_stand_side_by_side() -> None:
    crowded = {}
    for folder in {file.parent for file in modules().values()}:
        count = sum(file.name != "__init__.py" for file in folder.glob("*.py"))
        if count > MOST_FILES:
            crowded[folder.relative_to(ROOT).as_posix()] = count
    assert crowded == {}


def test_imports_are_shallow_in_every_room() -> None:
    depths = {
        package: max((depth(child, children) for child in children), default=0)
        for package, children in rooms()
    }
    assert {package: d for package, d in depths.items() if d > MOST_DEPTH} == {}


def test_every_room_says_what_it_is() -> None:
    silent = [
        name
        for name, file in modules().items()
        if file.name == "__init__.py" and not ast.get_docstring(tree(file))
    ]
    assert silent == []


def test_the_readme_is_short_and_plain() -> None:
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    assert len(text.splitlines()) <= 120
    prose = re.sub(r"```.*?```|^[|#!].*?$|\[([^]]*)\]\([^)]*\)", r"\1", text, flags=re.S | re.M)
    sentences = [s for s in re.split(r"[.:;?!]\s+", prose) if len(s.split()) > 2]
    assert median(len(sentence.split()) for sentence in sentences) <= 15
