"""Forms as they are written: each expression has the values of the form."""

import numpy as np
import pytest

from pyhrg.gap.closing.equation.forms import express_term
from pyhrg.gap.closing.equation.series import expand_form
from pyhrg.gap.effects.candidate_terms import make_harmonic
from pyhrg.gap.effects.form import Form

WARMTH = np.linspace(-20.0, 30.0, 11)
ANGLE = np.linspace(0.0, 2.0, 11)


@pytest.mark.parametrize("degree", range(1, 8))
def test_a_polynomial_is_written_in_powers(degree: int) -> None:
    form = Form("gyro_angle", "temperature", "bias: temperature^1", degree=degree, largest=3.0)
    written = np.zeros(len(WARMTH))
    for term, factor in expand_form(form):
        (basis,) = express_term(term)
        written += factor * basis.scale * eval(basis.modelica, {"warmth": WARMTH})
    assert written == pytest.approx(form.bend(WARMTH[:, None] / 10)[:, 0])


@pytest.mark.parametrize("degree", [1, 2, 5])
def test_a_multiple_is_written_as_a_harmonic(degree: int) -> None:
    function = "bias: harmonic 3 of the pattern angle"
    form = Form("gyro_angle", "wave_angle", function, 3, degree=degree, largest=0.9, size=2)
    ((term, factor),) = expand_form(form)
    names = {"cos": np.cos, "sin": np.sin, "pattern": ANGLE}
    written = [eval(basis.modelica, dict(names)) for basis in express_term(term)]
    assert factor * np.column_stack(written) == pytest.approx(form.bend(make_harmonic(3 * ANGLE)))


def test_what_has_no_expression_is_left_out() -> None:
    function = "bias: temperature, 4th harmonic"
    form = Form("gyro_angle", "temperature", function, degree=2, size=2)
    assert not list(expand_form(form))
