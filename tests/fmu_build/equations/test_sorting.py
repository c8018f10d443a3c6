"""Equations are matched and ordered; what can't be, is refused by name."""

from pathlib import Path

import pytest

from fmu_build.equations.dae import Dae
from fmu_build.equations.sorting import Assignment, sort_equations
from tests.fmu_build.modelica import SAMPLED, translated


def names(dae: Dae, assignments: tuple[Assignment, ...]) -> list[str]:
    return [dae.variables[a.target[1]].name for a in assignments]


def test_assignments_land_where_they_are_needed(tmp_path: Path) -> None:
    dae = translated(tmp_path, SAMPLED)
    plan = sort_equations(dae)
    assert names(dae, plan.parameters) == ["b"]
    assert names(dae, plan.starts) == ["x", "n"]
    assert names(dae, plan.motion) == ["twice"]
    assert names(dae, plan.tick) == ["n"]
    assert names(dae, plan.outputs) == ["y"]
    assert [a.target[0] for a in plan.derivatives] == ["derivative"]


def test_either_side_of_an_equation_may_be_the_unknown(tmp_path: Path) -> None:
    dae = translated(tmp_path, SAMPLED.replace("twice = 2*x", "2*x = twice"))
    assert "twice" in names(dae, sort_equations(dae).motion)


@pytest.mark.parametrize("other", ["a", "u"])
def test_what_depends_on_more_than_states_is_no_motion(tmp_path: Path, other: str) -> None:
    """A parameter may be tuned, and an input set, between two steps."""
    dae = translated(tmp_path, SAMPLED.replace("2*x", f"{other}*x"))
    assert sort_equations(dae).motion == ()


def test_what_the_next_step_begins_with_is_sampled_first(tmp_path: Path) -> None:
    slow = "      last = pre(n) + twice;\n      n = pre(n) + 1;"
    body = SAMPLED.replace("      n = pre(n) + twice;", slow)
    more = "discrete Real last(start = 0, fixed = true);\n    Real held = 3*n;\n    Real twice"
    dae = translated(tmp_path, body.replace("-x + u", "-x + held").replace("Real twice", more))
    assert names(dae, sort_equations(dae).tick) == ["n", "held", "last"]


def test_algebraic_loop_is_named(tmp_path: Path) -> None:
    dae = translated(tmp_path, SAMPLED.replace("twice = 2*x", "twice = 2*x + y"))
    with pytest.raises(ValueError, match=r"algebraic loop: .*(twice|y)"):
        sort_equations(dae)


def test_vector_parameter_depends_on_others_if_any_element_does(tmp_path: Path) -> None:
    body = SAMPLED.replace("input Real u", 'parameter Real p[2] = {0, 2*a} "p";\n    input Real u')
    dae = translated(tmp_path, body.replace("-x + u", "-x + p[2]*u"))
    assert set(names(dae, sort_equations(dae).parameters)) == {"b", "p"}
