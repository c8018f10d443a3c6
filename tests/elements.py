"""Elements of a page, each closed where it should be, and what every page is held to."""

import re
from collections.abc import Iterator
from html.parser import HTMLParser
from typing import Any

VOID = {"meta", "br", "input"}


class Elements(HTMLParser):
    """Collects every element; holds that each is closed where it should be."""

    def __init__(self) -> None:
        super().__init__()
        self.found: list[tuple[str, dict[str, str | None]]] = []
        self.open: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found.append((tag, dict(attrs)))

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


def elements(text: str) -> list[tuple[str, dict[str, str | None]]]:
    parser = Elements()
    parser.feed(text)
    assert not parser.open
    return parser.found


def check_nothing_is_loaded(text: str) -> None:
    """A page that loads something from elsewhere fails."""
    loading = {"src", "srcset", "data", "poster", "action", "xlink:href"}
    for tag, attributes in elements(text):
        assert not loading & set(attributes), tag
        assert tag not in ("link", "img", "iframe", "object")
    assert not re.search(r"https?://|@import|url\(|fetch\(|XMLHttpRequest", text)


def check_drawings_have_words(text: str) -> None:
    """A drawing that a screen reader can neither read nor pass over fails."""
    for tag, attributes in elements(text):
        if tag == "svg":
            assert attributes.get("aria-label") or attributes.get("aria-hidden") == "true"


def open_quiet_page(browser: Any, address: str) -> Iterator[Any]:
    """The page, open; it fails at an error on the console or a request but for the file."""
    opened = browser.new_page(viewport={"width": 1280, "height": 900})
    complaints: list[str] = []
    opened.on("console", lambda message: complaints.append(f"{message.type}: {message.text}"))
    opened.on("pageerror", lambda error: complaints.append(str(error)))
    opened.on("request", lambda request: complaints.append(request.url))
    opened.goto(address)
    assert complaints.pop(0) == address
    yield opened
    assert complaints == []
    opened.close()


def check_width(browser: Any, address: str, width: int) -> None:
    """A page that reaches over the edge of a window of this width, px, fails."""
    opened = browser.new_page(viewport={"width": width, "height": 800})
    opened.goto(address)
    assert opened.evaluate("document.documentElement.scrollWidth") <= width
    opened.close()


def check_scheme(browser: Any, address: str, dark: bool) -> None:
    """A page fails that is not dark, or light, as the user asks for it, and white on paper."""
    opened = browser.new_page(color_scheme="dark" if dark else "light")
    opened.goto(address)
    back = opened.evaluate("getComputedStyle(document.body).backgroundColor")
    light = [int(v) for v in back.strip("rgb()").split(",")]
    assert (max(light) < 64) == dark
    opened.emulate_media(media="print")
    assert opened.evaluate("getComputedStyle(document.body).backgroundColor").startswith("rgb(255")
    assert not opened.locator("#filters").is_visible()
    opened.close()
