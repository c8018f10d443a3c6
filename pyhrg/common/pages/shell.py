"""The page around sections: one file that needs no network and no script, but may use one."""

import html
from dataclasses import dataclass
from importlib.resources import files
from importlib.resources.abc import Traversable

POLICY = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'"


@dataclass(frozen=True)
class Anchored:
    """A section that the page's contents lead to.

    name: its anchor.
    title: plain text.
    body: markup.
    """

    name: str
    title: str
    body: str

    @property
    def markup(self) -> str:
        """The section."""
        name = html.escape(self.name)
        return (
            f'<section id="{name}" aria-labelledby="{name}-title"><h2 id="{name}-title">'
            f"{html.escape(self.title)}</h2>{self.body}</section>"
        )


def contents(sections: list[Anchored]) -> str:
    """Links to sections."""
    listed = "".join(
        f'<li><a href="#{html.escape(s.name)}">{html.escape(s.title)}</a></li>' for s in sections
    )
    return f'<nav aria-label="Sections"><ul>{listed}</ul></nav>'


def document(title: str, style: str, body: str, script: str) -> str:
    """A whole page.

    Args:
        title: plain text.
        style: beyond that of all pages.
        body: markup.
        script: that makes it livelier.
    """
    return (
        '<!doctype html><html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width,initial-scale=1">'
        f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">'
        f"<title>{html.escape(title)}</title><style>{base_style()}{style}</style></head>"
        f"<body>{body}<script>{script}</script></body></html>\n"
    )


def base_style() -> str:
    """Style of all pages."""
    return asset(files("pyhrg.common.pages"), "base.css")


def asset(folder: Traversable, name: str) -> str:
    """A file of a package."""
    return folder.joinpath(name).read_text(encoding="utf-8")
