"""Hooks of the documentation site: formulas become MathML, which a browser shows by itself."""

import html
import re

from latex2mathml.converter import convert

FORMULA = re.compile(r'<(span|div) class="arithmatex">\\[(\[](.*?)\\[)\]]</\1>', re.DOTALL)
NUMBER = re.compile(r"\\tag\{(.*?)\}")
BRACKETS = {r"\langle": "⟨", r"\rangle": "⟩"}
"""Brackets that the converter knows beside no `\\Big`, as LaTeX and as a character."""


def on_page_content(content: str, **_: object) -> str:
    """Write each formula of a page as MathML."""
    return FORMULA.sub(lambda match: write_formula(match[1], html.unescape(match[2])), content)


def write_formula(element: str, latex: str) -> str:
    """Give one formula as MathML; a displayed one has its number beside it."""
    for name, character in BRACKETS.items():
        latex = latex.replace(name, character)
    if element == "span":
        return convert(latex)
    numbers = "".join(f"<span>({number})</span>" for number in NUMBER.findall(latex))
    formula = convert(NUMBER.sub("", latex).strip(), display="block")
    return f'<div class="equation">{formula}{numbers}</div>'
