"""The documentation site: built strictly, read from its files without a network, at any width."""

import json
import os
import re
import subprocess
import sys
from html.parser import HTMLParser
from importlib import import_module
from importlib.metadata import entry_points
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).parents[2]
LOADING = {
    *(("script", "src"), ("img", "src"), ("img", "srcset"), ("source", "src"), ("video", "src")),
    *(("iframe", "src"), ("embed", "src"), ("object", "data"), ("audio", "src")),
}
"""Elements and attributes whose address a browser loads by itself; `link` is seen to below."""
PHONE_WIDTH = 390
"""Width of a window, px, that every page fits."""
NOT_LOADED = {"canonical", "next", "prev"}
"""Relations of a `link` that only name another page."""


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The site as a reader gets it."""
    folder = tmp_path_factory.mktemp("site")
    command = [sys.executable, "-m", "mkdocs", "build", "--strict", "--site-dir", str(folder)]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    run = subprocess.run(
        command, cwd=ROOT, env=environment, capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stdout + run.stderr
    return folder


class Addresses(HTMLParser):
    """Addresses that a page makes the browser load."""

    def __init__(self) -> None:
        super().__init__()
        self.loaded: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        values = dict(attrs)
        if tag == "link" and values.get("rel") not in NOT_LOADED:
            self.loaded.append(values.get("href") or "")
        self.loaded += [value or "" for name, value in attrs if (tag, name) in LOADING]


def test_no_page_loads_from_elsewhere(site: Path) -> None:
    pages = sorted(site.rglob("*.html"))
    assert len(pages) > 40
    outside = []
    for page in pages:
        addresses = Addresses()
        addresses.feed(page.read_text(encoding="utf-8"))
        assert addresses.loaded
        outside += [f"{page.name}: {a}" for a in addresses.loaded if re.match(r"(\w+:)?//", a)]
    for style in site.rglob("*.css"):
        links = re.findall(r"""url\(["']?((?:\w+:)?//[^)]*)""", style.read_text(encoding="utf-8"))
        outside += [f"{style.name}: {link}" for link in links]
    assert outside == []


def test_formulas_are_shown_without_a_script(site: Path) -> None:
    text = (site / "methods" / "noise.html").read_text(encoding="utf-8")
    assert text.count("<math") > 50
    assert "<span>(1)</span>" in text
    unread = {}
    for page in site.rglob("*.html"):
        body = page.read_text(encoding="utf-8").partition("<article")[2]
        prose = re.sub(r"<(pre|code|script)\b.*?</\1>|<[^>]*>", "", body, flags=re.DOTALL)
        if found := re.findall(r"\\[a-zA-Z]+|\$", prose):
            unread[page.name] = found
    assert unread == {}


@pytest.mark.parametrize("package", ["pyhrg", "ins_eval", "fmu_build"])
def test_the_reference_has_every_public_name(site: Path, package: str) -> None:
    text = (site / "reference" / f"{package}.html").read_text(encoding="utf-8")
    titles = re.findall(r"<h2[^>]*>(.*?)</h2>", text, re.DOTALL)
    named = {re.sub(r"<[^>]*>|&para;|¶", " ", title).split()[0] for title in titles}
    front_door = {title for title in named if title.startswith(f"{package}.")}
    assert front_door == {f"{package}.{name}" for name in import_module(package).__all__}


def test_links_are_words(site: Path) -> None:
    """Not the names of files that the site doesn't have."""
    link = re.compile(r'<a [^>]*href="[^":]*\.html[^"]*"[^>]*>(?:<code>)?([\w/.-]+\.md)<')
    pages = {page.name: page.read_text(encoding="utf-8") for page in site.rglob("*.html")}
    assert {name: found for name, text in pages.items() if (found := link.findall(text))} == {}
    assert (
        '<a href="import.html">A laboratory\'s own logs as a campaign</a>' in pages["how-to.html"]
    )


def test_the_reference_has_every_command_and_mechanism(site: Path) -> None:
    text = (site / "reference" / "commands.html").read_text(encoding="utf-8")
    commands = entry_points(group="hrg.commands").names
    assert [name for name in commands if f"usage: hrg {name}" not in text] == []
    table = (site / "reference" / "mechanisms.html").read_text(encoding="utf-8")
    source = (ROOT / "modelica" / "HRG" / "UsersGuide" / "Mechanisms.mo").read_text()
    assert table.count("<tr>") == source.count("<tr>") > 31


def test_a_tutorial_is_a_notebook_too(site: Path) -> None:
    notebook = json.loads((site / "tutorials" / "fly.ipynb").read_text(encoding="utf-8"))
    code = [cell["source"] for cell in notebook["cells"] if cell["cell_type"] == "code"]
    assert code[0].startswith('%%writefile my-gyro.toml\nname = "my gyro"')
    assert code[1].startswith("import ins_eval\n")
    assert any(cell.startswith("!hrg nav --trajectory car") for cell in code)
    page = (site / "tutorials" / "fly.html").read_text(encoding="utf-8")
    assert 'href="fly.ipynb"' in page


@pytest.mark.needs("chromium")
def test_pages_fit_a_phone_and_ask_for_nothing(site: Path, browser: Any) -> None:
    """No request out of the site's folder, no message of an error, no page wider than its window.

    A server shows `404.html`, by addresses from its root; nobody reads it from its folder."""
    page = browser.new_page(viewport={"width": PHONE_WIDTH, "height": 800})
    complaints: list[str] = []
    page.on("console", lambda message: complaints.append(f"{message.type}: {message.text}"))
    page.on("pageerror", lambda error: complaints.append(str(error)))
    folder = site.as_uri()
    page.on("request", lambda r: None if r.url.startswith(folder) else complaints.append(r.url))
    for file in sorted(set(site.rglob("*.html")) - {site / "404.html"}):
        page.goto(file.as_uri(), wait_until="load")
        if page.evaluate("document.documentElement.scrollWidth") > PHONE_WIDTH:
            complaints.append(f"{file.relative_to(site)} is wider than its window")
    page.close()
    assert complaints == []


@pytest.mark.needs("chromium")
def test_the_search_answers_without_a_server(site: Path, browser: Any) -> None:
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    page.goto((site / "glossary.html").as_uri())
    page.fill("input[data-md-component=search-query]", "parking")
    page.wait_for_selector("a.md-search-result__link", timeout=20_000)
    assert page.locator("a.md-search-result__link").count() > 0
    page.close()
