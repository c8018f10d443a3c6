"""The paper's parameter system (Table 1), row by row: the figure, or why there is none."""

from collections.abc import Mapping
from dataclasses import dataclass

from pyhrg.bench.outcome import Outcome
from pyhrg.bench.reporting.text import format_finding
from pyhrg.common.pages.markup import Table


@dataclass(frozen=True)
class Row:
    """A row of Table 1.

    Attributes:
        term: the term in English.
        printed: the term as the paper prints it.
        procedure, finding: the test and its finding that give the figure.
        reason: why no test gives the figure.
    """

    term: str
    printed: str
    procedure: str = ""
    finding: str = ""
    reason: str = ""


NO_DIMENSIONS = "property of the hardware: the model has no dimensions; measure it"
UNBROKEN = "nothing breaks in the model; what a shock changes is put in and its bias measured"
ROOM, FULL = "room temperature", "full temperature"

ADDED = (Row("start-up time", "启动时间", "start-up", "time to specification"),)
"""Terms that the paper's text asks for and its Table 1 lacks."""
TABLE_1 = (
    Row("volume", "体积", reason=NO_DIMENSIONS),
    Row("mass", "质量", reason=NO_DIMENSIONS),
    Row("power", "功耗", reason="the model has no supply; measure current and voltage"),
    Row("cost", "成本", reason="no physical quantity"),
    Row("density", "密度", reason=f"mass over volume: {NO_DIMENSIONS}"),
    Row("eccentricity", "偏心", reason=f"centre of mass off the axis: {NO_DIMENSIONS}"),
    Row("shock resistance", "抗冲击能力", reason=UNBROKEN),
    Row(f"bias stability, {ROOM}", "常温零偏稳定性", "full-circumference", "bias stability"),
    Row(
        f"bias repeatability, {ROOM}", "常温零偏重复性", "full-circumference", "bias repeatability"
    ),
    Row(
        *(f"bias stability, {FULL}", "全温零偏稳定性"),
        *("full-temperature", "bias stability over temperature"),
    ),
    Row(
        *(f"bias repeatability, {FULL}", "全温零偏重复性"),
        *("full-temperature", "bias repeatability over temperature"),
    ),
    Row("random walk", "随机游走", "random-walk", "angle random walk"),
    Row("g-dependent bias", "与 g (加速度)相关零偏", "tumble", "g bias z"),
    Row(
        *("bias change before, during and after vibration", "振动前、中、后零偏变化"),
        *("vibration-shock", "bias change during vibration along the input axis"),
    ),
    Row(
        *("bias change before and after shock", "冲击前后零偏变化"),
        *("vibration-shock", "bias change after shock"),
    ),
    Row("annual bias stability", "零偏年稳定性", "annual", "bias annual stability"),
    Row(
        *(f"scale factor stability, {ROOM}", "常温标度因数稳定性"),
        *("scale-factor-angle", "scale factor variation"),
    ),
    Row(
        *(f"scale factor repeatability, {ROOM}", "常温标度因数重复性"),
        *("linearity", "scale factor repeatability"),
    ),
    Row(
        *(f"scale factor stability, {FULL}", "全温标度因数稳定性"),
        *("full-temperature", "scale factor stability over temperature"),
    ),
    Row(
        *(f"scale factor repeatability, {FULL}", "全温标度因数重复性"),
        *("full-temperature", "scale factor repeatability over temperature"),
    ),
    Row("scale factor nonlinearity", "标度因数非线性", "linearity", "scale factor nonlinearity"),
    Row("scale factor symmetry", "标度因数对称性", "linearity", "scale factor asymmetry"),
    Row("measuring range", "测量范围", "range", "measuring range"),
    Row("threshold", "阈值", "threshold", "threshold"),
    Row(
        *("annual scale factor stability", "标度因数年稳定性"),
        *("annual", "scale factor annual stability"),
    ),
    *ADDED,
)


def make_table_1(outcomes: Mapping[str, Outcome]) -> Table:
    """Every row of Table 1 with its figure and the test that gave it, or why there is none.

    The outcomes stand by their tests' names.
    """
    cells = (_make_cells(row, outcomes.get(row.procedure)) for row in TABLE_1)
    header = ("", "value", "95 % interval", "unit", "test, or why there is no figure")
    return Table("Parameter system (Xu et al. 2024, Table 1)", header, tuple(cells))


def _make_cells(row: Row, outcome: Outcome | None) -> tuple[str, ...]:
    name = f"{row.term} ({row.printed})"
    if outcome is None:
        return (name, "-", "-", "", row.reason or f"hrg bench {row.procedure}")
    finding = outcome.finding(row.finding)
    return (name, *format_finding(finding), f"{row.procedure}: {row.finding}")
