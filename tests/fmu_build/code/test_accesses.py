"""Vectors that a function advances where they stand."""

from pathlib import Path

from fmu_build.code.generate import generate_source
from tests.fmu_build.modelica import translated

SHIFTED = """
  function shifted
    input Real before[4];
    output Real after[4];
  algorithm
    after := {{0 for i in 1:4}};
    for i in 1:3 loop
      after[{to}] := before[{of}];
    end for;
    for i in {end}:{end} loop
      after[i] := {last};
    end for;
  end shifted;
  model M
    input Real u(start = 0) "u";
    output Real y "y";
    discrete Real n[4](start = {{1, 2, 3, 4}}, each fixed = true) "n";
    Real x(start = 0, fixed = true) "x";
  equation
    y = n[1];
    der(x) = u + 0*n[1];
    when sample(0, 0.01) then
      n = shifted(pre(n));
    end when;
  end M;
"""


def generate(folder: Path, **subscripts: str) -> str:
    """C of a model whose vector is shifted once a tick."""
    return generate_source(translated(folder, SHIFTED.format(**subscripts)))


def test_a_result_is_written_over_what_was_read_before(tmp_path: Path) -> None:
    source = generate(tmp_path, to="i", of="i + 1", end="4", last="1")
    assert "f_shifted(&v[2], (v + 2));" in source
    assert "= 0.0" not in source.split("void model_parameters")[0]


def test_a_result_is_not_written_over_what_is_read_later(tmp_path: Path) -> None:
    source = generate(tmp_path, to="i + 1", of="i", end="1", last="1")
    assert "(v + " not in source
    assert "real r" in source


def test_an_initial_value_that_is_read_stays(tmp_path: Path) -> None:
    source = generate(tmp_path, to="i", of="i + 1", end="4", last="after[i]")
    assert "= 0.0" in source.split("void model_parameters")[0]
