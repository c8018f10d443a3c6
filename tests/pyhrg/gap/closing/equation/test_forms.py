"""The written expression of every candidate term gives the term's columns."""

import numpy as np
import pytest

from pyhrg.common.units import DEG
from pyhrg.gap.closing.equation.forms import express_term
from pyhrg.gap.effects.candidate_terms import (
    Coordinates,
    _follow_with_play,
    build_term_columns,
    compute_coordinates,
)
from pyhrg.gap.replay.observations import observe_test
from pyhrg.records.campaign import Campaign
from tests.pyhrg.gap.soundness.conftest import NOMINAL, error_free  # noqa: F401 (a fixture)


def _evaluate(modelica: str, where: Coordinates) -> np.ndarray:
    log = where.test.log
    variables = {
        "pattern": where.pattern_angle,
        "tableAngle": where.table_angle,
        "warmth": where.resonator,
        "caseWarmth": where.case,
        "warming": where.case_rate * 60,
        "turnRate": where.table_rate / DEG,
        "commandedRate": log.virtual_rotation / DEG,
        "amplitudeExcess": where.amplitude,
        "hours": log.time / 3600,
        **{f"force{a}": getattr(log, f"acceleration_{a.lower()}") for a in "XYZ"},
        **{f"play{width}": _follow_with_play(where.case, float(width)) for width in (2, 10)},
        **{name: getattr(np, name) for name in ("cos", "sin", "exp", "sqrt", "abs")},
    }
    return np.asarray(eval(modelica.replace("^", "**"), {"__builtins__": {}}, variables))


@pytest.mark.parametrize("test_id", ["warm", "tumble", "virtual", "sweep"])
def test_an_expression_gives_its_columns(error_free: Campaign, test_id: str) -> None:  # noqa: F811
    test = next(test for test in error_free.tests if test.id == test_id)
    observed = observe_test(test, NOMINAL)
    n = len(test.log.time)
    where = compute_coordinates(observed, np.linspace(0.2, 1.9, n), np.full(n, 0.9), NOMINAL)
    for term, columns in build_term_columns(where, "amplitude_force"):
        for basis, column in zip(express_term(term), columns.T, strict=False):
            values = basis.scale * _evaluate(basis.modelica, where)
            np.testing.assert_allclose(
                np.broadcast_to(values, n), column, rtol=1e-9, atol=1e-12, err_msg=term.words
            )
