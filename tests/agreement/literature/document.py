"""docs/literature.md: the text of `literature.md` in this folder, filled with the figures."""

from pathlib import Path

from tests.agreement.literature import bias_maps, gain_asymmetry, temperature

TEMPLATE = Path(__file__).with_name("literature.md")


def compute_figures() -> dict[str, float]:
    """All figures by name; takes about two seconds."""
    return {**bias_maps.figures(), **gain_asymmetry.figures(), **temperature.figures()}


def fill_document(values: dict[str, float]) -> str:
    """The document.

    Raises:
        KeyError: the text names a figure that is not computed.
    """
    return TEMPLATE.read_text(encoding="utf-8").format_map(values)
