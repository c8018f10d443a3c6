"""Pieces of HTML, made of text that is escaped."""

import html
from collections.abc import Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Table:
    """The text of a table, with a heading over each column."""

    title: str
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


def make_paragraph(text: str, style: str = "") -> str:
    """A paragraph, of a CSS class where one is named."""
    opening = f'<p class="{style}">' if style else "<p>"
    return f"{opening}{html.escape(text)}</p>"


def make_table(content: Table) -> str:
    """A table with its title."""
    rows = [_make_row(content.header, "th"), *(_make_row(cells, "td") for cells in content.rows)]
    return f"<table><caption>{html.escape(content.title)}</caption>{''.join(rows)}</table>"


def make_wide_table(content: Table, style: str = "") -> str:
    """A table that scrolls sideways where it is wider than the page."""
    return f'<div class="{f"wide {style}".strip()}">{make_table(content)}</div>'


def _make_row(cells: Sequence[str], tag: str) -> str:
    return "<tr>" + "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in cells) + "</tr>"
