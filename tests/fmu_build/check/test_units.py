"""Names of units that can be read mean what the SI Brochure says."""

import math

import pytest

from fmu_build.check.rules.unit_names import EXPONENTS, find_meanings


@pytest.mark.parametrize(
    ("name", "exponents", "factor", "offset"),
    [
        ("1", {}, 1, 0),
        ("rad/s", {"rad": 1, "s": -1}, 1, 0),
        ("deg/h", {"rad": 1, "s": -1}, math.pi / 180 / 3600, 0),
        ("km/h", {"m": 1, "s": -1}, 1 / 3.6, 0),
        ("m/s2", {"m": 1, "s": -2}, 1, 0),
        ("N.m", {"kg": 1, "m": 2, "s": -2}, 1, 0),
        ("W/(m2.K)", {"kg": 1, "s": -3, "K": -1}, 1, 0),
        ("kg", {"kg": 1}, 1, 0),
        ("mbar", {"kg": 1, "m": -1, "s": -2}, 100, 0),
        ("degC", {"K": 1}, 1, 273.15),
        ("degC/s", {"K": 1, "s": -1}, 1, 0),
        ("m.s-2", {"m": 1, "s": -2}, 1, 0),
        ("1/min", {"s": -1}, 1 / 60, 0),
    ],
)
def test_meaning(name: str, exponents: dict[str, int], factor: float, offset: float) -> None:
    (meaning,) = find_meanings(name)
    assert meaning.exponents == tuple(exponents.get(n, 0) for n in EXPONENTS)
    assert meaning.factor == pytest.approx(factor, rel=1e-12)
    assert meaning.offset == offset


@pytest.mark.parametrize("name", ["furlong", "lbf.ft", "", "m^2", "m/s/s", "°C"])
def test_what_cannot_be_read_is_not_judged(name: str) -> None:
    assert find_meanings(name) == ()


def test_hertz_may_be_of_either_frequency() -> None:
    assert [m.factor for m in find_meanings("Hz")] == pytest.approx([1, 2 * math.pi])
