"""What the generator does not know, it refuses."""

from pathlib import Path

import pytest

from fmu_build.code.generate import generate_source
from fmu_build.equations import translate as translate_module
from fmu_build.equations.scalars import list_variables
from fmu_build.equations.translate import translate
from pyhrg.common.errors import HrgError
from tests.fmu_build.modelica import SAMPLED, translated


def test_modelica_error_names_model_and_cause(tmp_path: Path) -> None:
    with pytest.raises(HrgError, match=r"P\.M: .*nowhere"):
        translated(tmp_path, SAMPLED.replace("twice = 2*x", "twice = 2*nowhere"))


def test_other_compiler_version_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(translate_module, "COMPILER_VERSION", "0.0.0")
    with pytest.raises(HrgError, match=r"is installed; expected 0\.0\.0"):
        translate(tmp_path, "P.M")


def test_a_parameter_is_tunable_by_its_annotation(tmp_path: Path) -> None:
    """Not by words in its description, and not if it is computed from another one."""
    text = SAMPLED.replace("twice = 2*x", "twice = 2*x + c + d")
    text = text.replace(
        "    input Real u",
        '    parameter Real c = 1 "a; Evaluate = false" annotation(Evaluate = false);\n'
        '    parameter Real d = 1 "annotation(Evaluate = false)";\n    input Real u',
    )
    listed = list_variables(translated(tmp_path, text), 2)
    assert [each.name for each in listed if each.variability == "tunable"] == ["c"]


def test_a_start_value_of_a_tunable_parameter_is_refused(tmp_path: Path) -> None:
    text = SAMPLED.replace('a = 2 "a"', 'a = 2 "a" annotation(Evaluate = false)')
    with pytest.raises(HrgError, match=r"P\.M: x: its start value is made of a parameter with"):
        list_variables(translated(tmp_path, text), 2)


def test_model_without_clock_is_refused(tmp_path: Path) -> None:
    body = "model M\n Real x(start = 1, fixed = true);\nequation\n der(x) = -x;\nend M;"
    with pytest.raises(HrgError, match="has no sample clock"):
        translated(tmp_path, body)


def test_array_reset_within_a_loop_is_refused(tmp_path: Path) -> None:
    """The compiler mistranslates a conditional assignment of an element within a loop."""
    body = """
  function f
    input Real u;
    output Real y[3];
  algorithm
    for i in 1:6 loop
      if i > 3 then
        y[i - 3] := u + i;
      end if;
    end for;
  end f;
""" + SAMPLED.replace("n = pre(n) + twice", "n = g(f(pre(n)))").replace(
        "  model M",
        "  function g\n    input Real u[3];\n    output Real y;\n  algorithm\n"
        "    y := u[1];\n  end g;\n  model M",
    )
    with pytest.raises(
        ValueError, match="f: a statement of kind assignment_group is not supported"
    ):
        generate_source(translated(tmp_path, body))
