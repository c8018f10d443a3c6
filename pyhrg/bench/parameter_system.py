"""The paper's parameter system (Table 1): each row's figure, or why simulation can't give it."""

from collections.abc import Mapping
from dataclasses import dataclass

from pyhrg.bench.outcome import Finding, Outcome


@dataclass(frozen=True)
class Row:
    """One row of Table 1.

    column: of the table; "added" where the paper's text asks for it and the table leaves it out.
    term: as procedures name it in their `rows`.
    printed: in the paper.
    procedure, finding: where its figure is found.
    reason: why there is none.
    """

    column: str
    term: str
    printed: str
    procedure: str = ""
    finding: str = ""
    reason: str = ""


NO_BODY = "property of the hardware: the model has no dimensions; measure it"
ROOM, FULL = "room temperature", "full temperature"

TABLE_1 = (
    Row("physical", "volume", "体积", reason=NO_BODY),
    Row("physical", "mass", "质量", reason=NO_BODY),
    Row("physical", "power", "功耗", reason="the model has no supply; measure current and voltage"),
    Row("physical", "cost", "成本", reason="no physical quantity"),
    Row("physical", "density", "密度", reason=f"mass over volume: {NO_BODY}"),
    Row("physical", "eccentricity", "偏心", reason=f"centre of mass off the axis: {NO_BODY}"),
    Row(
        *("physical", "shock resistance", "抗冲击能力"),
        reason="nothing breaks in the model; what a shock changes is put in and its bias measured",
    ),
    Row(
        *("static", f"bias stability, {ROOM}", "常温零偏稳定性"),
        *("full-circumference", "bias stability"),
    ),
    Row(
        *("static", f"bias repeatability, {ROOM}", "常温零偏重复性"),
        *("full-circumference", "bias repeatability"),
    ),
    Row(
        *("static", f"bias stability, {FULL}", "全温零偏稳定性"),
        *("full-temperature", "bias stability"),
    ),
    Row(
        *("static", f"bias repeatability, {FULL}", "全温零偏重复性"),
        *("full-temperature", "bias repeatability"),
    ),
    Row("static", "random walk", "随机游走", "random-walk", "angle random walk"),
    Row("static", "g-dependent bias", "与 g (加速度)相关零偏", "tumble", "bias z"),
    Row(
        *("static", "bias change before, during and after vibration", "振动前、中、后零偏变化"),
        *("vibration-shock", "bias change"),
    ),
    Row(
        *("static", "bias change before and after shock", "冲击前后零偏变化"),
        *("vibration-shock", "bias change"),
    ),
    Row("static", "annual bias stability", "零偏年稳定性", "annual", "bias stability"),
    Row(
        *("dynamic", f"scale factor stability, {ROOM}", "常温标度因数稳定性"),
        *("scale-factor-angle", "scale factor variation"),
    ),
    Row(
        *("dynamic", f"scale factor repeatability, {ROOM}", "常温标度因数重复性"),
        *("linearity", "scale factor repeatability"),
    ),
    Row(
        *("dynamic", f"scale factor stability, {FULL}", "全温标度因数稳定性"),
        *("full-temperature", "scale factor stability"),
    ),
    Row(
        *("dynamic", f"scale factor repeatability, {FULL}", "全温标度因数重复性"),
        *("full-temperature", "scale factor repeatability"),
    ),
    Row(
        *("dynamic", "scale factor nonlinearity", "标度因数非线性"),
        *("linearity", "scale factor nonlinearity"),
    ),
    Row(
        *("dynamic", "scale factor symmetry", "标度因数对称性"),
        *("linearity", "scale factor symmetry"),
    ),
    Row("dynamic", "measuring range", "测量范围", "range", "measuring range"),
    Row("dynamic", "threshold", "阈值", "threshold", "threshold"),
    Row(
        *("dynamic", "annual scale factor stability", "标度因数年稳定性"),
        *("annual", "scale factor stability"),
    ),
    Row("added", "start-up time", "启动时间", "start-up", "time to valid"),
)


def figure_of(row: Row, outcomes: Mapping[str, Outcome]) -> Finding | None:
    """The row's finding among the outcomes by procedure; None where it wasn't run."""
    outcome = outcomes.get(row.procedure)
    return outcome.finding(row.finding) if outcome else None
