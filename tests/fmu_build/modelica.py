"""Small Modelica models for tests of the generator."""

from pathlib import Path

from fmu_build.equations.dae import Dae
from fmu_build.equations.translate import translate


def translated(folder: Path, body: str) -> Dae:
    """Translate a package P whose content is given; the model is P.M."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "package.mo").write_text(f"package P\n{body}\nend P;\n")
    return translate(folder, "P.M")


SAMPLED = """
  model M
    parameter Real a = 2 "a";
    parameter Real b = 3*a "b";
    input Real u(start = 0) "u";
    output Real y "y";
    Real x(start = b, fixed = true) "x";
    Real twice "algebraic";
    discrete Real n(start = 0, fixed = true) "n";
  equation
    y = twice + n;
    der(x) = -x + u + 0*n;
    twice = 2*x;
    when sample(0, 0.01) then
      n = pre(n) + twice;
    end when;
  end M;
"""

COUNTING = """
  model M
    parameter Real c = 2 "start";
    parameter Real idle = 1 "used nowhere";
    input Real u(start = 0) "u";
    output Real y "y";
    discrete Real n(start = c, fixed = true) "n";
    Real x(start = 0, fixed = true) "x";
  equation
    y = n;
    der(x) = 0*n;
    when sample(0, 0.01) then
      n = pre(n) + u;
    end when;
  end M;
"""
