"""Pieces of HTML: text in, escaped markup out."""

import html
from collections.abc import Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Table:
    """Figures beside each other, ready to be read: a heading over each column."""

    title: str
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


def paragraph(text: str, style: str = "") -> str:
    """A paragraph, of a CSS class where one is named."""
    opening = f'<p class="{style}">' if style else "<p>"
    return f"{opening}{html.escape(text)}</p>"


def table(content: Table) -> str:
    """A table with its title."""
    rows = [_row(content.header, "th"), *(_row(cells, "td") for cells in content.rows)]
    return f"<table><caption>{html.escape(content.title)}</caption>{''.join(rows)}</table>"


def _row(cells: Sequence[str], tag: str) -> str:
    return "<tr>" + "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in cells) + "</tr>"
