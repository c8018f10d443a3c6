"""The two bias tests side by side, in the layout of the paper's Table 2."""

from pyhrg.bench.bias.bias_test import BiasTest
from pyhrg.units import DEG_PER_H


def bias_table(fixed: BiasTest, circumference: BiasTest) -> str:
    """Both tests side by side, deg/h, in the layout of the paper's Table 2."""
    rows = [
        _row("Bias, deg/h", "fixed position", "", "full circumference", ""),
        _row("run", "mean", "std. dev.", "mean", "std. dev."),
    ]
    for number, (old, new) in enumerate(zip(fixed.runs, circumference.runs, strict=True), 1):
        figures = (old.mean, old.deviation, new.mean, new.deviation)
        rows.append(_row(str(number), *(f"{x / DEG_PER_H:.5f}" for x in figures)))
    for name in ("stability", "repeatability"):
        old_figure, new_figure = (
            f"{getattr(test, name) / DEG_PER_H:.5f}" for test in (fixed, circumference)
        )
        rows.append(_row(f"bias {name}", "", old_figure, "", new_figure))
    return "\n".join(rows)


def _row(head: str, *cells: str) -> str:
    return f"{head:<20}" + "".join(f"{cell:>19}" for cell in cells)
