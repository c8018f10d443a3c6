"""A hook of the documentation site: each page whose blocks run is a notebook as well."""

import json
import re
from pathlib import Path
from typing import Any

BLOCK = re.compile(r'^```(\w+)(?: title="(\S+)")?\n(.*?)^```\n?', re.DOTALL | re.MULTILINE)
"""A block of a page: language, name of the file that it is, and text."""
FOLDERS = ("start/", "tutorials/")


def on_page_markdown(markdown: str, page: Any, config: Any, **_: object) -> str:
    """Write the notebook into the site, and a link to it below the page's title."""
    source = page.file.src_uri
    if not source.startswith(FOLDERS) or not BLOCK.search(markdown):
        return markdown
    target = (Path(config.site_dir) / source).with_suffix(".ipynb")
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_text(json.dumps(make_notebook(markdown), indent=1), encoding="utf-8")
    title, _newline, text = markdown.partition("\n")
    return f'{title}\n\n<a href="{target.name}" download>This page as a notebook</a>\n{text}'


def make_notebook(markdown: str) -> dict[str, object]:
    """Give a page as the document of a notebook (nbformat 4.5)."""
    cells: list[tuple[str, str]] = []
    end = 0
    for block in BLOCK.finditer(markdown):
        cells += [
            ("markdown", markdown[end : block.start()]),
            ("code", write_cell(*block.groups())),
        ]
        end = block.end()
    cells.append(("markdown", markdown[end:]))
    return {
        "nbformat": 4,
        "nbformat_minor": 5,
        "metadata": {"kernelspec": {"name": "python3", "display_name": "Python 3"}},
        "cells": [make_cell(i, kind, text.strip()) for i, (kind, text) in enumerate(cells)],
    }


def write_cell(language: str, name: str | None, text: str) -> str:
    """Give a block as IPython reads it: a file, commands or Python."""
    if name:
        return f"%%writefile {name}\n{text}"
    if language == "console":
        return re.sub(r"^\$ ", "!", text, flags=re.MULTILINE)
    return text


def make_cell(number: int, kind: str, text: str) -> dict[str, object]:
    """Give one cell."""
    cell = {"id": str(number), "cell_type": kind, "metadata": {}, "source": text}
    return {**cell, "execution_count": None, "outputs": []} if kind == "code" else cell
