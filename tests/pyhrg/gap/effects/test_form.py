"""Forms of terms are integrated out as a covariance of the residual, with its determinant."""

from collections.abc import Mapping

import numpy as np
import pytest
from scipy.stats import multivariate_normal

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.catalogue import EFFECTS
from pyhrg.gap.effects.design import Block, Design, discount_model_error
from pyhrg.gap.effects.form import Form
from pyhrg.gap.effects.known_parameters import KnownParameters
from pyhrg.gap.effects.linear_test import Group
from pyhrg.gap.evidence.evidence import fit

ROWS = 40
TERM = CandidateTerm("gyro_angle", "temperature", "bias: temperature^1")
EFFECT = EFFECTS["phase_temperature"]
RIVAL = CandidateTerm("gyro_angle", "time", "bias: time since power-on")
FORMS = {
    Form(TERM.channel, TERM.coordinate, TERM.function, degree=2): 3.0,
    Form(TERM.channel, TERM.coordinate, TERM.function, degree=3, size=2): 0.2,
}
GENERATOR = np.random.default_rng(5)
COLUMNS: dict[Group, Array] = {
    group: GENERATOR.normal(size=(ROWS, size))
    for group, size in ((TERM, 1), (RIVAL, 1), *((form, form.size) for form in FORMS))
}
RESIDUAL = GENERATOR.normal(size=ROWS) + COLUMNS[TERM][:, 0]


def build(blocks: Mapping[Group, Array] = COLUMNS) -> Design:
    """Normal equations of white residuals."""
    series = np.column_stack([*blocks.values(), RESIDUAL])
    ends = np.cumsum([column.shape[1] for column in blocks.values()])
    columns = {
        group: np.arange(end - column.shape[1], end)
        for (group, column), end in zip(blocks.items(), ends, strict=True)
    }
    block = Block("test", "gyro_angle", np.arange(ends[-1]), series.T @ series, ROWS, 0.0)
    empty = Design(np.eye(1), np.zeros(1), 0.0, columns, np.ones(1), (block,))
    return discount_model_error(empty, {})


def find_covariance() -> Array:
    """Covariance of the residual: noise of one, and the forms apart from the term."""
    own = COLUMNS[TERM]
    apart = np.eye(ROWS) - own @ own.T / float((own**2).sum())
    covariance = np.eye(ROWS)
    for form, sigma in FORMS.items():
        column = apart @ COLUMNS[form]
        covariance += sigma**2 * column @ column.T
    return covariance


def test_the_evidence_is_that_of_the_covariance() -> None:
    covariance = find_covariance()
    design = KnownParameters(build(), FORMS, (TERM,)).marginal
    expected = multivariate_normal(np.zeros(ROWS), covariance).logpdf(RESIDUAL)
    constant = -ROWS / 2 * np.log(2 * np.pi)
    assert design.log_likelihood == pytest.approx(float(expected) - constant)
    for group in (TERM, RIVAL):
        found = fit(design, [group])
        assert found is not None
        weighted = np.linalg.solve(covariance, COLUMNS[group])
        information = float((COLUMNS[group].T @ weighted).item())
        assert found.values[0] == pytest.approx(weighted.T @ RESIDUAL / information)
        assert found.covariances[0].item() == pytest.approx(1 / information)


def test_forms_take_nothing_from_their_term() -> None:
    with_forms = KnownParameters(build(), FORMS, (TERM,)).marginal
    without = KnownParameters(build(), {}).marginal
    first, second = fit(with_forms, [TERM]), fit(without, [TERM])
    assert first is not None
    assert second is not None
    assert first.log_evidence == pytest.approx(second.log_evidence)


def test_removed_sizes_make_the_estimated_response() -> None:
    known = KnownParameters(build(), FORMS, (TERM,))
    best = fit(known.marginal, [TERM])
    assert best is not None
    sizes = known.complete(best.sizes)
    left = RESIDUAL - sum(COLUMNS[group] @ size for group, size in sizes.items())
    covariance = find_covariance()
    beside = RESIDUAL - COLUMNS[TERM] @ best.values[0]
    assert left == pytest.approx(np.linalg.solve(covariance, beside))


def test_forms_of_the_posterior_are_estimated_together() -> None:
    known = KnownParameters(build(), FORMS, (TERM,))
    best = fit(known.marginal, [TERM])
    assert best is not None
    groups = [TERM, *FORMS]
    values, covariance = known.estimate_jointly(best.groups, groups)
    sizes = known.complete(best.sizes)
    assert values == pytest.approx(np.concatenate([sizes[group] for group in groups]))
    columns = np.column_stack([COLUMNS[group] for group in groups])
    prior = np.diag([0.0, *np.repeat([s**-2 for s in FORMS.values()], [f.size for f in FORMS])])
    apart = np.eye(len(values))
    apart[0, 1:] = columns[:, 0] @ columns[:, 1:] / (columns[:, 0] @ columns[:, 0])
    free = np.linalg.inv(apart.T) @ columns.T @ columns @ np.linalg.inv(apart) + prior
    expected = np.linalg.inv(apart) @ np.linalg.inv(free) @ np.linalg.inv(apart.T)
    assert covariance == pytest.approx(expected)


def test_an_effect_that_is_a_function_of_the_coordinate_is_none_beside_the_cause() -> None:
    """It is part of the same function; without the cause, or a little off it, it is an effect."""
    columns = dict(COLUMNS)
    form = columns[next(iter(FORMS))]
    for share, is_effect in ((0.0, False), (0.2, True)):
        columns[EFFECT] = COLUMNS[TERM] + form + share * COLUMNS[RIVAL]
        whole = build(columns)
        assert EFFECT in KnownParameters(whole, {}).marginal.groups
        assert (EFFECT in KnownParameters(whole, FORMS, (TERM,)).marginal.groups) is is_effect
