"""A whole page around sections: one file that needs neither network nor script."""

import html
from dataclasses import dataclass
from importlib.resources import files
from importlib.resources.abc import Traversable

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
