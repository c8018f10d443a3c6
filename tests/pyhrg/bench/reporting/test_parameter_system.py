"""Every row of the paper's Table 1 has a procedure or a reason."""

import os
import re
from pathlib import Path

import pytest

from pyhrg.bench.catalogue import PROCEDURES
from pyhrg.bench.outcome import Finding, Outcome
from pyhrg.bench.reporting.parameter_system import ADDED, TABLE_1, make_table_1


def printed() -> set[str]:
    """Terms of Table 1 in the paper's text, where it is at hand."""
    path = Path(os.environ.get("HRG_PAPER", "../shared/paper.txt"))
    if not path.exists():
        pytest.skip("the paper's text is not here: HRG_PAPER names it")
    text = path.read_text()
    lines = text[text.index("物理性能\t") : text.index("表1中")].splitlines()[1:]
    cells = [cell.strip() for line in lines for cell in line.split("\t")]
    return {re.sub(r"\s", "", cell) for cell in cells if cell}


def test_every_row_has_a_test_or_a_reason() -> None:
    for row in TABLE_1:
        assert bool(row.reason) != bool(row.procedure), row.term
        if row.procedure:
            assert row.procedure in [procedure.name for procedure in PROCEDURES], row.term


def test_rows_are_those_of_the_paper() -> None:
    ours = {re.sub(r"\s", "", row.printed) for row in TABLE_1 if row not in ADDED}
    assert ours == printed()


def test_a_figure_stands_in_its_row() -> None:
    finding = Finding("threshold", 1.745e-5, "deg/s", 0.0, 1.745e-5, 5)
    rows = {cells[0]: cells for cells in make_table_1({"threshold": Outcome((finding,), "")}).rows}
    assert rows["threshold (阈值)"][1] == "0.00100"
    assert rows["measuring range (测量范围)"][4] == "hrg bench range"
    assert rows["mass (质量)"][1] == "-"
