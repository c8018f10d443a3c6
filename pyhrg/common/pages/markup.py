"""Pieces of HTML, made of text that is escaped, and a whole page around sections: one file that
needs neither network nor script.
"""

import html
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib.resources import files
from importlib.resources.abc import Traversable


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


POLICY = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'"
"""Content security policy: nothing is loaded from elsewhere."""


@dataclass(frozen=True)
class PageSection:
    """A section of a page: the anchor that the list of contents links to, a plain title, markup."""

    name: str
    title: str
    body: str

    @property
    def markup(self) -> str:
        name = html.escape(self.name)
        return (
            f'<section id="{name}" aria-labelledby="{name}-title"><h2 id="{name}-title">'
            f"{html.escape(self.title)}</h2>{self.body}</section>"
        )


def make_contents(sections: list[PageSection]) -> str:
    listed = "".join(
        f'<li><a href="#{html.escape(s.name)}">{html.escape(s.title)}</a></li>' for s in sections
    )
    return f'<nav aria-label="Sections"><ul>{listed}</ul></nav>'


def make_document(title: str, style: str, body: str, script: str, images: bool = False) -> str:
    """A whole page of markup under a plain title: `style` is CSS beside that of all pages, `script`
    JavaScript that the page can do without; `images` says whether it shows files beside it."""
    policy = f"{POLICY}; img-src 'self' file:" if images else POLICY
    base_style = read_asset(files("pyhrg.common.pages"), "base.css")
    return (
        '<!doctype html><html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width,initial-scale=1">'
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">'
        f"<title>{html.escape(title)}</title><style>{base_style}{style}</style></head>"
        f"<body>{body}<script>{script}</script></body></html>\n"
    )


def read_asset(folder: Traversable, name: str) -> str:
    """The text of a file in a package."""
    return folder.joinpath(name).read_text(encoding="utf-8")
