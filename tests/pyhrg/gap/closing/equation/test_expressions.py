"""The written expression of every candidate term gives the term's columns."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.bench.readings.first_order_lag import follow_with_lag
from pyhrg.bench.readings.play import follow_with_play
from pyhrg.common.units import DEG
from pyhrg.gap.closing.equation.closed_class import write_response
from pyhrg.gap.closing.equation.expressions import Basis, express_term
from pyhrg.gap.closing.equation.places import GAIN, GROWTH, LEAK, find_acting
from pyhrg.gap.closing.equation.proposal import list_coefficients
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.coordinates import (
    HYSTERESIS_WIDTHS,
    Coordinates,
    compute_coordinates,
)
from pyhrg.gap.effects.term_columns import build_term_columns
from pyhrg.gap.replay.observations import observe_test
from pyhrg.records.campaign import Campaign
from tests.pyhrg.gap.soundness.conftest import NOMINAL, error_free  # noqa: F401 (a fixture)

QUADRATURE_FORCE = 1e-3
"""Of the replay, 1/s."""


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
        **{f"firstForce{a}": getattr(log, f"acceleration_{a.lower()}")[0] for a in "XYZ"},
        **{f"play{w}": follow_with_play(where.case, w) for w in HYSTERESIS_WIDTHS},
        **{f"lagging{lag}": follow_with_lag(where.case, log.interval, lag) for lag in (600, 3600)},
        **{name: getattr(np, name) for name in ("cos", "sin", "exp", "sqrt", "abs")},
    }
    return np.asarray(eval(modelica.replace("^", "**"), {"__builtins__": {}}, variables))


@pytest.mark.parametrize("test_id", ["warm", "tumble", "virtual", "sweep"])
def test_an_expression_gives_its_columns(
    error_free: Campaign,  # noqa: F811
    monkeypatch: pytest.MonkeyPatch,
    test_id: str,
) -> None:
    """Here all columns have values at the rows' ends, as the expressions do."""
    monkeypatch.setattr(Coordinates, "means", property(lambda where: where))
    test = next(test for test in error_free.tests if test.id == test_id)
    observed = replace(observe_test(test, NOMINAL), line_period=23.7021)
    n = len(test.log.time)
    replay = {
        "wave_angle": np.linspace(0.2, 1.9, n),
        "amplitude": np.full(n, 0.9),
        "amplitude_force": np.full(n, 1 / 450),
        "quadrature_force": np.full(n, QUADRATURE_FORCE),
        "quadrature": np.full(n, 0.1),
    }
    where = compute_coordinates(observed, replay, NOMINAL)
    for channel in ("amplitude_force", "gyro_angle"):
        for term, columns in build_term_columns(where, channel):
            assert all(c.variable.isidentifier() for c in list_coefficients(term))
            if channel == "amplitude_force" and term.channel == "gyro_angle":
                continue  # behind the loop: `test_closed.py` has the gyro itself
            for basis, column in zip(express_term(term), columns.T, strict=False):
                expected = _respond(term, channel, basis, where)
                np.testing.assert_allclose(
                    expected, column, rtol=1e-9, atol=1e-12, err_msg=term.words
                )


def _respond(term: CandidateTerm, channel: str, basis: Basis, where: Coordinates) -> np.ndarray:
    """What a channel shows of a term, by the variables to which the written class adds it."""
    log, gain = where.test.log, where.nominal.bryan_factor
    driven = log.drive_on * 1 / 450
    numbers = {
        "": 1.0,
        GROWTH: driven,
        LEAK: -QUADRATURE_FORCE / (2 * gain),
        "-virtualRotation": -log.virtual_rotation,
        "-gyro.amplitudeForce": -driven,
        f"1/(2*{GAIN})": 1 / (2 * gain),
        f"-2*{GAIN}*virtualRotation": -2 * gain * log.virtual_rotation,
        f"-4*{GAIN}^2*virtualRotation": -4 * gain**2 * log.virtual_rotation,
    }
    added = dict.fromkeys(("addedRate", "addedAngle", "addedAmplitudeForce"), np.zeros(len(driven)))
    for response in find_acting(term).responses:
        if response.variable in added:
            factor = numbers[response.factor]
            expression = write_response(basis.modelica, response._replace(factor=""))
            values = np.broadcast_to(basis.scale * _evaluate(expression, where), len(driven))
            before = np.append(values[:1], values[:-1])
            values = (values + before) / 2 if response.factor in (GROWTH, LEAK) else values
            added[response.variable] = added[response.variable] + values * factor
    if channel == "amplitude_force":
        return added["addedAmplitudeForce"]
    return np.asarray(added["addedAngle"] + np.cumsum(added["addedRate"]) * log.interval)
