"""Slow ticks are counted off the fast ones: of one clock, whatever a product of times rounds to."""

from pathlib import Path

import pytest
import rumoca

from fmu_build.bundle import find_modelica_library
from fmu_build.roots import ROOTS
from pyhrg.common.errors import HrgError
from tests.fmu_build.modelica import translated
from tests.modelica.models import Model, built

RATES = """
model Rates
  Boolean base = sample(0, 1e-3);
  HRG.Controls.ClockDivider three(final factor = 3, clock = base);
  HRG.Controls.ClockDivider ten(final factor = 10, clock = base);
  HRG.Controls.ClockDivider thirty(final factor = 10, clock = three.tick);
  discrete output Real n(start = 0, fixed = true);
  discrete output Real atThree(start = 0, fixed = true);
  discrete output Real atTen(start = 0, fixed = true);
  discrete output Real atThirty(start = 0, fixed = true);
  Real x(start = 0, fixed = true);
equation
  when base then
    n = pre(n) + 1;
  end when;
  when three.tick then
    atThree = n;
  end when;
  when ten.tick then
    atTen = n;
  end when;
  when thirty.tick then
    atThirty = n;
  end when;
  der(x) = 0*n;
end Rates;
"""
"""Ticks in ratios of 3, 10 and 30 to the clock's, and 3 to 10 to each other."""

DIVIDED = """
  model M
    parameter Integer k = 3 "k";
    final parameter Integer f = 3 "f";
    Boolean clock = sample(0, 0.01) "clock";
    Boolean other = sample(0, 0.02) "other";
    Boolean tick = clock and noEvent(n < 0.5) "tick";
    discrete Real n(start = f - 1, fixed = true) "n";
    discrete Real y(start = 0, fixed = true) "y";
    Real x(start = 0, fixed = true) "x";
  equation
    when clock then
      n = if pre(n) > f - 1.5 then 0 else pre(n) + 1;
    end when;
    when tick then
      y = pre(y) + 1;
    end when;
    der(x) = 0*y;
  end M;
"""


def test_coincident_ticks_never_part() -> None:
    """From a start that is no multiple of a period, by steps that are none."""
    model = Model("Rates", 1.0, "", RATES, is_own=False)
    start, step = 0.1234567, 0.77e-3
    with built(model) as fmu:
        fmu.power_on({}, start)
        for i in range(2000):
            fmu.advance(start + i * step, step)
            last = (i + 1) * 77 // 100
            expected = [last // every * every + 1 for every in (1, 3, 10, 30)]
            assert fmu.read(["n", "atThree", "atTen", "atThirty"]) == expected


@pytest.mark.parametrize("name", [name for name in ROOTS if name.startswith("HRG")])
def test_a_gyro_has_one_clock(name: str) -> None:
    """Else another Modelica tool may take the converters' 200th sample before the control period or
    after it: 200 k times 5e-6 is another double than k times 1e-3 for 41 % of the first million k.
    """
    package = str(find_modelica_library() / "package.mo")
    document = rumoca.Session().load(package, model=ROOTS[name].model).to_dict("dae")
    clocks = (clock["kind"]["periodic"]["lattice"] for clock in document["storage"]["clocks"])
    assert len({str(clock) for clock in clocks}) == 1


def test_a_divided_tick_is_found_by_counting(tmp_path: Path) -> None:
    assert [sample.every for sample in translated(tmp_path, DIVIDED).sampled] == [1, 3]


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("pre(n) > f - 1.5", "pre(n) > k - 1.5", "divided by k, which is not final"),
        ("pre(n) > f - 1.5", "pre(n) > x", "divided by x, which is not final"),
        ("start = f - 1", "start = 0", r"not divided evenly: its ticks \[2, 5, 8\] pass"),
        ("n < 0.5", "n < 1.5", r"not divided evenly: its ticks \[0, 1, 3\] pass"),
        ("when clock", "when other", "n divides a clock whose ticks it does not count"),
        ("n < 0.5", "sin(n) < 0.5", "divided by an expression of kind builtin"),
        ("clock and noEvent(n < 0.5)", "noEvent(n < 0.5)", "is no tick of a clock"),
    ],
)
def test_what_divides_a_clock_otherwise_is_refused(
    tmp_path: Path, old: str, new: str, message: str
) -> None:
    with pytest.raises(HrgError, match=message):
        translated(tmp_path, DIVIDED.replace(old, new))
