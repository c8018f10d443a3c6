"""`Controls.deviation` finds in the frame of the true orbit what `Controls.orbit` finds in any."""

from math import cos, sin

import numpy as np
import pytest

from tests.modelica.models import Model, built

TEXT = """
model Readings
  parameter Real a = 1;
  parameter Real q = 0;
  parameter Real angle = 0;
  parameter Real phase = 0;
  parameter Real between = 0;
  parameter Real lag = 0;
  output Real detected[6];
  output Real expected[6];
  Real c[2] = {cos(angle + between), cos(phase + lag)};
  Real s[2] = {sin(angle + between), sin(phase + lag)};
  Real reading[4] = {
    a*c[1]*c[2] - q*s[1]*s[2],
    -a*c[1]*s[2] - q*s[1]*c[2],
    a*s[1]*c[2] + q*c[1]*s[2],
    -a*s[1]*s[2] + q*c[1]*c[2]};
  discrete Real n(start = 0, fixed = true);
  Real x(start = 0, fixed = true);
equation
  detected = HRG.Controls.deviation(reading, {cos(angle), sin(angle), cos(phase), sin(phase)});
  expected = HRG.Controls.orbit(reading, angle);
  when sample(0, 1) then
    n = pre(n) + 1;
  end when;
  der(x) = 0*n;
end Readings;
"""
"""An orbit that is read turned by an angle, and late by a phase."""


def test_the_detected_orbit_is_the_same_by_series_and_by_roots() -> None:
    """Angles between on both sides of 0.005 rad, where series end, and up to 0.5 rad."""
    generator = np.random.default_rng(4)
    with built(Model("Readings", 1.0, "", TEXT, is_own=False)) as fmu:
        for between in (0.0, 1e-9, 1e-4, 0.004999, 0.005001, 0.03, 0.5):
            angle, phase = generator.uniform(-3, 3), generator.uniform(-1, 1)
            for sign in (-1, 1):
                given = {"angle": angle, "phase": phase, "between": sign * between}
                fmu.power_on({**given, "lag": 1e-3, "a": 0.7, "q": 2e-3})
                found = fmu.read([f"detected[{i}]" for i in range(1, 7)])
                orbit = fmu.read([f"expected[{i}]" for i in range(1, 7)])
                turned = angle + sign * between
                assert found[:2] == pytest.approx([0.7, 2e-3], rel=1e-12)
                assert found[2] == pytest.approx(1e-3, rel=1e-12)
                assert found[3:5] == pytest.approx([cos(turned), sin(turned)], abs=1e-15)
                assert found[:2] + found[3:5] == pytest.approx(
                    [orbit[3], orbit[4], orbit[1], orbit[2]], abs=1e-15
                )
                series = 0.05 * between**7 + 1e-15
                assert found[5] == pytest.approx(sign * between, abs=series)
