"""docs/paper.md: the text of `paper.md` in this folder, filled with the computed figures."""

from pathlib import Path

from tests.agreement.paper import (
    bias_equation,
    compensation,
    dead_zone,
    manoeuvres,
    numbers,
    positions,
    scale_factor_equations,
    table1,
    table2,
    table2_device,
    virtual_rotation,
)

TEMPLATE = Path(__file__).with_name("paper.md")
SUBJECTS = (
    bias_equation,
    scale_factor_equations,
    numbers,
    dead_zone,
    virtual_rotation,
    positions,
    manoeuvres,
    compensation,
    table1,
    table2,
    table2_device,
)


def compute_figures() -> dict[str, float]:
    """All figures by name; takes about two minutes."""
    found: dict[str, float] = {}
    for subject in SUBJECTS:
        new = subject.figures()
        twice = found.keys() & new.keys()
        if twice:
            raise ValueError(f"{subject.__name__} gives {', '.join(sorted(twice))} a second time")
        found |= new
    return found


def fill_document(values: dict[str, float]) -> str:
    """The document.

    Raises:
        KeyError: the text names a figure that is not computed.
    """
    return TEMPLATE.read_text(encoding="utf-8").format_map(values)
