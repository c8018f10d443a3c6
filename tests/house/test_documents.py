"""Python in README and docs runs as it stands there; commands and paths in them exist."""

import re
from contextlib import suppress
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from typing import Any

import matplotlib as mpl
import pytest

from fmu_build import build_fmu
from pyhrg.bench import catalogue
from tests.modules import load_file

ROOT = Path(__file__).parents[2]
PAGES = ("README.md", "docs/fmu.md", "docs/imus.md", "docs/navigation.md")


@pytest.mark.parametrize("page", PAGES)
def test_python_blocks_run(
    page: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """One page's blocks run one after the other, in a folder that holds the FMU."""
    monkeypatch.chdir(tmp_path)
    build_fmu(out=tmp_path / "HRG.fmu")
    mpl.use("agg")
    blocks = re.findall(r"```python\n(.*?)```", (ROOT / page).read_text(encoding="utf-8"), re.S)
    assert blocks
    names: dict[str, object] = {}
    for block in blocks:
        exec(compile(block, page, "exec"), names)
    assert capsys.readouterr().out


def test_a_few_gyros_are_benched_and_flown(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The recipe, with two gyros, a short flight and quasi-static loops on the bench."""
    monkeypatch.chdir(tmp_path)
    slow = [replace(p, model="HRGSlow", step=0.1) for p in catalogue.PROCEDURES]
    monkeypatch.setattr(catalogue, "PROCEDURES", slow)
    text = (ROOT / "docs" / "how-to.md").read_text(encoding="utf-8")
    (block,) = re.findall(r"```python\n(.*?)```", text, re.S)
    names: dict[str, Any] = {}
    exec(block.replace("range(1, 6)", "range(1, 3)").replace("hours=0.5", "hours=0.1"), names)
    assert "fixed_deg_per_h" in capsys.readouterr().out
    assert names["table"].shape == (2, 3)
    assert (names["table"] > 0).all(axis=None)


def test_links_and_paths_exist() -> None:
    """Relative links of every page, and paths of the code that it names."""
    missing = []
    for page in (*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")):
        text = re.sub(r"\${1,2}[^$]*\${1,2}", "", page.read_text(encoding="utf-8"))
        links = re.findall(r"\[[^\]]*\]\((?!https?:)([^)#\s]+)", text)
        paths = re.findall(r"`((?:pyhrg|ins_eval|fmu_build|tests|benchmarks)/[\w/.-]+)`", text)
        missing += [f"{page.name}: {link}" for link in links if not (page.parent / link).exists()]
        missing += [f"{page.name}: {path}" for path in paths if not (ROOT / path).exists()]
    assert missing == []


def test_commands_and_options_exist() -> None:
    """Each command in a block or between backquotes, with the options that stand behind it."""
    hooks = load_file(ROOT / "docs" / "site" / "hooks.py")
    known = {
        parser.prog: {name for action in parser._actions for name in action.option_strings}
        for whole in hooks.make_parsers()
        for parser in hooks.list_parsers(whole)
    }
    wrong, count = [], 0
    for page in (*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")):
        text = page.read_text(encoding="utf-8")
        for line in re.findall(r"^(?:\$ )?(hrg [a-z].*)$|`(hrg [a-z][^`]*)`", text, re.MULTILINE):
            command = "".join(line)
            words = command.split()
            name = next((n for n in (" ".join(words[:3]), " ".join(words[:2])) if n in known), None)
            options = set(re.findall(r"(?<![\w-])--[a-z][\w-]*", command))
            if name is None or not options <= known[name]:
                wrong.append(f"{page.name}: {command}")
            count += 1
    assert wrong == []
    assert count > 40


def find_object(name: str) -> object:
    """What a dotted name is; raises where there is no such module or attribute."""
    with suppress(ModuleNotFoundError):
        return import_module(name)
    module, _, attribute = name.rpartition(".")
    return getattr(find_object(module), attribute)


def test_dotted_names_exist() -> None:
    """Modules, functions and classes that a page names; what the changelog tells is the past."""
    wrong, count = [], 0
    for page in (*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")):
        text = "" if page.name == "CHANGELOG.md" else page.read_text(encoding="utf-8")
        for name in set(re.findall(r"`((?:pyhrg|ins_eval|fmu_build)(?:\.\w+)+)[`(]", text)):
            count += 1
            try:
                find_object(name)
            except (AttributeError, ImportError):
                wrong.append(f"{page.name}: {name}")
    assert wrong == []
    assert count > 30
