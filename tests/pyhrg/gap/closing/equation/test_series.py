"""Forms as they are written: each expression has the values of the form."""

import numpy as np
import pytest

from pyhrg.gap.closing.equation.expressions import express_term
from pyhrg.gap.closing.equation.series import expand_form
from pyhrg.gap.effects.coordinates import make_harmonic
from pyhrg.gap.effects.form import Form

WARMTH = np.linspace(-40.0, 60.0, 21)
"""K; twice as wide as the tests' own range in these forms."""
ANGLE = np.linspace(0.0, 2.0, 11)


@pytest.mark.parametrize("degree", range(1, 8))
def test_a_polynomial_is_written_in_powers(degree: int) -> None:
    form = Form(
        "gyro_angle", "temperature", "bias: temperature^1", degree=degree, largest=3.0, reach=3.0
    )
    written, values = np.zeros(len(WARMTH)), WARMTH[:, None] / 10
    for term, factor in expand_form(form):
        (basis,) = express_term(term)
        written += factor * basis.scale * eval(basis.modelica, {"warmth": WARMTH})
    assert written == pytest.approx(form.bend(values, values)[:, 0])


@pytest.mark.parametrize("degree", [1, 2, 5])
def test_a_multiple_is_written_as_a_harmonic(degree: int) -> None:
    function = "bias: harmonic 3 of the pattern angle"
    form = Form("gyro_angle", "wave_angle", function, 3, degree=degree, largest=0.9, size=2)
    ((term, factor),) = expand_form(form)
    block = make_harmonic(3 * ANGLE)
    names = {"cos": np.cos, "sin": np.sin, "pattern": ANGLE}
    written = [eval(basis.modelica, dict(names)) for basis in express_term(term)]
    assert factor * np.column_stack(written) == pytest.approx(form.bend(block, block))


@pytest.mark.parametrize("degree", range(1, 8))
def test_of_a_product_the_second_function_is_written_in_powers(degree: int) -> None:
    function, level = "pick-off: harmonic 8 of the pattern angle, times the amplitude", 0.7 * ANGLE
    sizes = {"degree": degree, "largest": 0.5, "reach": 0.4, "size": 2}
    form = Form("gyro_angle", "amplitude", function, **sizes)
    written = np.zeros((len(ANGLE), 2))
    names = {"cos": np.cos, "sin": np.sin, "pattern": ANGLE, "amplitudeExcess": level}
    for term, factor in expand_form(form):
        values = [b.scale * eval(b.modelica, dict(names)) for b in express_term(term)]
        written += factor * np.column_stack(values)
    block = make_harmonic(8 * ANGLE) * level[:, None]
    assert written == pytest.approx(form.bend(block, level[:, None]))
