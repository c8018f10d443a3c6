"""The written expression of every candidate term gives the term's columns."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.bench.readings.first_order_lag import follow_with_lag
from pyhrg.common.units import DEG
from pyhrg.gap.closing.equation.forms import express_term
from pyhrg.gap.closing.equation.places import GROWTH, find_acting
from pyhrg.gap.closing.equation.proposal import list_coefficients
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.coordinates import (
    HYSTERESIS_WIDTHS,
    Coordinates,
    _follow_with_play,
    compute_coordinates,
)
from pyhrg.gap.effects.term_columns import build_term_columns
from pyhrg.gap.replay.observations import observe_test
from pyhrg.records.campaign import Campaign
from tests.pyhrg.gap.soundness.conftest import NOMINAL, error_free  # noqa: F401 (a fixture)


def _evaluate(modelica: str, where: Coordinates) -> np.ndarray:
    log = where.test.log
    variables = {
        "pattern": where.pattern_angle,
        "tableAngle": where.table_angle,
        "tableDirection": where.table_direction[:, 0],
        "warmth": where.resonator,
        "caseWarmth": where.case,
        "warming": where.case_rate * 60,
        "turnRate": where.table_rate / DEG,
        "commandedRate": log.virtual_rotation / DEG,
        "amplitudeExcess": where.amplitude,
        "hours": log.time / 3600,
        **{f"force{a}": getattr(log, f"acceleration_{a.lower()}") for a in "XYZ"},
        **{f"play{w}": _follow_with_play(where.case, w) for w in HYSTERESIS_WIDTHS},
        **{f"lagging{lag}": follow_with_lag(where.case, log.interval, lag) for lag in (600, 3600)},
        **{name: getattr(np, name) for name in ("cos", "sin", "exp", "sqrt", "abs")},
    }
    return np.asarray(eval(modelica.replace("^", "**"), {"__builtins__": {}}, variables))


@pytest.mark.parametrize("test_id", ["warm", "tumble", "virtual", "sweep"])
def test_an_expression_gives_its_columns(error_free: Campaign, test_id: str) -> None:  # noqa: F811
    test = next(test for test in error_free.tests if test.id == test_id)
    observed = replace(observe_test(test, NOMINAL), line_period=23.7021)
    n = len(test.log.time)
    replay = {
        "wave_angle": np.linspace(0.2, 1.9, n),
        "amplitude": np.full(n, 0.9),
        "amplitude_force": np.full(n, 1 / 450),
        "quadrature_force": np.zeros(n),
        "quadrature": np.full(n, 0.1),
    }
    where = compute_coordinates(observed, replay, NOMINAL)
    for channel in ("amplitude_force", "gyro_angle"):
        for term, columns in build_term_columns(where, channel):
            assert all(c.variable.isidentifier() for c in list_coefficients(term))
            for basis, column in zip(express_term(term), columns.T, strict=False):
                values = np.broadcast_to(basis.scale * _evaluate(basis.modelica, where), n)
                expected = _respond(term, channel, values, where)
                np.testing.assert_allclose(
                    expected, column, rtol=1e-9, atol=1e-12, err_msg=term.words
                )


def _respond(
    term: CandidateTerm, channel: str, values: np.ndarray, where: Coordinates
) -> np.ndarray:
    """What a channel shows of a term, by the variables to which the written class adds it."""
    log, factors = where.test.log, dict(find_acting(term).responses)
    driven = log.drive_on * 1 / 450
    numbers = {"": 1.0, GROWTH: driven, "-virtualRotation": -log.virtual_rotation,
               "-gyro.amplitudeForce": -driven}  # fmt: skip
    if channel == "amplitude_force":
        return np.asarray(values * numbers[factors["addedAmplitudeForce"]])
    by = factors.get("addedRate")
    pushing = (values + np.append(values[:1], values[:-1])) / 2 if by == GROWTH else values
    rate = np.zeros_like(values) if by is None else pushing * numbers[by]
    angle = values if "addedAngle" in factors else np.zeros_like(values)
    return np.asarray(angle + np.cumsum(rate) * log.interval)
