"""docs/paper.md holds the figures that the code computes, and nothing else."""

import re
from pathlib import Path

import pytest

from pyhrg.paper import document

ROOT = Path(__file__).parents[3]
PRINTED = (
    "0.0009 0.1 0.1000 0.0082 0.0032 10.045 10.053 10.05 0.000017 0.0024 0.0288 0.7072 0.5 0.001"
    " 0.01 2e-5 1e-6"
)
"""Of the paper, with what `test_claims` recomputes from the rows of its Table 2."""
STATED = "0.277 39.9 15.04 0.01 1e-4 0.004 0.6 0.1 11.25 22.5 0.3 1.5e-4 2e-6 4.5e-5 4.75e-5 9e-6"
"""Of the gyros and tests that were chosen."""
PLACES = "02.001 10.19306 8110.2024 1.1 1.2 2.1 2.3 2.4 2.5 3.2 4.1 4.2 5.3"
"""Sections, and the paper's identifier."""


def test_document_is_what_the_code_computes(values: dict[str, float]) -> None:
    """Else: python -m pyhrg.paper > docs/paper.md, and say in the commit what moved and why."""
    assert (ROOT / "docs" / "paper.md").read_text(encoding="utf-8") == document.filled(values)


def test_every_figure_is_in_the_text_or_was_held_to_something(values: dict[str, float]) -> None:
    text = document.TEMPLATE.read_text(encoding="utf-8")
    shown = set(re.findall(r"\{(\w+)", text))
    tested = "".join(path.read_text() for path in Path(__file__).parent.glob("test_*.py"))
    assert [v for v in values if v not in shown and v not in tested and "_new_" not in v] == []


def test_no_figure_is_written_by_hand() -> None:
    """Every decimal of the text outside its placeholders is the paper's or an input."""
    text = re.sub(r"\{[^}]*\}", "", document.TEMPLATE.read_text(encoding="utf-8"))
    decimals = set(re.findall(r"\d+\.\d+(?:e-?\d+)?|\d+e-\d+", text))
    assert decimals - set(f"{PRINTED} {STATED} {PLACES}".split()) == set()


def test_a_figure_that_is_not_computed_is_an_error(values: dict[str, float]) -> None:
    fewer = {name: value for name, value in values.items() if name != "beat_turns"}
    with pytest.raises(KeyError, match="beat_turns"):
        document.filled(fewer)
