"""Pieces of HTML, made of text that is escaped."""

import html
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Table:
    """The text of a table, with a heading over each column."""

    title: str
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


def make_paragraph(text: str, style: str = "") -> str:
    """A paragraph, of a CSS class where one is named."""
    opening = f'<p class="{html.escape(style)}">' if style else "<p>"
    return f"{opening}{html.escape(text)}</p>"


def make_table(content: Table) -> str:
    rows = [_make_row(content.header, "th"), *(_make_row(cells, "td") for cells in content.rows)]
    return f"<table><caption>{html.escape(content.title)}</caption>{''.join(rows)}</table>"


def make_wide_table(content: Table) -> str:
    """A table that scrolls sideways where it is wider than the page."""
    return f'<div class="wide">{make_table(content)}</div>'


def make_choice(key: str, title: str, options: Mapping[str, str], selected: str = "") -> str:
    """A labelled choice among options, texts by value; `selected` is the value chosen at first."""
    listed = "".join(
        f'<option value="{html.escape(value)}"{" selected" if value == selected else ""}>'
        f"{html.escape(text)}</option>"
        for value, text in options.items()
    )
    return (
        f'<label>{html.escape(title)} <select name="{html.escape(key)}" autocomplete="off">'
        f"{listed}</select></label>"
    )


def embed_json(content: Mapping[str, object]) -> str:
    """JSON that can stand inside a script element."""
    text = json.dumps(content, separators=(",", ":"), allow_nan=False)
    return text.replace("<", "\\u003c")


def _make_row(cells: Sequence[str], tag: str) -> str:
    return "<tr>" + "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in cells) + "</tr>"
