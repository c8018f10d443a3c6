"""Figures as files."""

from pathlib import Path

from matplotlib.figure import Figure


def save_png(figure: Figure, path: Path) -> None:
    """Write as PNG; the same figure gives the same bytes."""
    figure.savefig(path, format="png", dpi=120, metadata={"Software": None})
