"""The pictures of docs/gallery: `python -m benchmarks.gallery DIR` works in DIR and writes them.

A command whose results are in DIR already is not run again. It takes about ten minutes of a core,
and three minutes of two for `hrg validate`.
"""

import shlex
import sys
from pathlib import Path
from typing import Any

import matplotlib as mpl
from PIL import Image
from playwright.sync_api import sync_playwright

import pyhrg
from pyhrg.common.cli import main
from tests.modules import load_file
from tests.programs import find_chromium

DOCS = Path(__file__).parents[1] / "docs"
GALLERY = DOCS / "gallery"
WIDTH = 720
"""Width of a picture, px: a column of the site at twice the density of most screens is wider."""
COLORS = 256
"""Colours of a picture: the figures are lines and text, and shrink to a third of their bytes."""
REPORT_VIEW = {"width": 1100, "height": 900}
"""Part of a report that its picture shows, px."""
COMMANDS = {
    "circumference": "hrg bench full-circumference --runs 2 --seed 1 --out circumference",
    "drive": "hrg nav --trajectory car --imu typical-hrg --hours 0.5 --seed 1 --out drive",
    "align": "hrg align --out align",
    "allan": "hrg allan rest.csv --out allan",
    "parking": "hrg parking --out parking",
    "validation": "hrg validate --seed 1 --out validation",
    "my-diagnosis": "hrg gap diagnose my-gyro --out my-diagnosis",
}
"""What writes each folder, beside the bench: `bench/TEST` is by `hrg bench TEST --out bench`."""
PICTURES = {
    "map": "drive/map.png",
    "growth": "drive/growth.png",
    "budget": "drive/budget.png",
    "align": "align/align.png",
    "allan-report": "allan/report.html",
    "bench-report": "circumference/report.html",
    "diagnosis-report": "my-diagnosis/report.html",
    "validation-report": "validation/report.html",
}
"""Name of each picture, and the file that it shows."""


def run(command: str) -> None:
    """Run a command line of `hrg` in this folder."""
    print(f"$ {command}", flush=True)
    if status := main(shlex.split(command)[1:]):
        raise SystemExit(status)


def run_blocks(page: str) -> None:
    """Make the logs and the campaign that a page of the docs begins with."""
    text = (DOCS / page).read_text(encoding="utf-8")
    names: dict[str, Any] = {}
    for language, name, block in load_file(DOCS / "site" / "notebooks.py").BLOCK.findall(text):
        if name:
            Path(name).write_text(block, encoding="utf-8")
        elif language == "python":
            exec(compile(block, page, "exec"), names)
            return


def make_results() -> None:
    """Run in this folder what is not there yet."""
    if not Path("rest.csv").exists():
        run_blocks("start/test-engineer.md")
    if not Path("my-gyro").exists():
        run_blocks("tutorials/diagnose.md")
    for test in pyhrg.list_tests()["name"]:
        if not Path("bench", test).exists():
            run(f"hrg bench {test} --device typical --seed 1 --out bench")
    for folder, command in COMMANDS.items():
        if not Path(folder).exists():
            run(command)


def write_picture(name: str, source: Path, browser: Any) -> None:
    """Write one picture: a figure as it is, or the head of a report."""
    image = GALLERY / f"{name}.png"
    if source.suffix == ".html":
        page = browser.new_page(viewport=REPORT_VIEW)
        page.goto(source.resolve().as_uri())
        page.screenshot(path=image)
        page.close()
        source = image
    with Image.open(source) as picture:
        height = round(picture.height * WIDTH / picture.width)
        small = picture.convert("RGB").resize((WIDTH, height), Image.Resampling.LANCZOS)
        small.quantize(COLORS).save(image, optimize=True)


def write_pictures() -> None:
    """Write all pictures that this folder has the results for."""
    sources = {name: Path(file) for name, file in PICTURES.items()}
    sources |= {file.parent.name: file for file in sorted(Path("bench").glob("*/figure.png"))}
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=find_chromium())
        for name, source in sources.items():
            write_picture(name, source, browser)
        browser.close()


if __name__ == "__main__":
    import os

    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    os.chdir(folder)
    mpl.use("agg")
    make_results()
    write_pictures()
