"""Ranking of sets."""

import numpy as np
import pytest

from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.catalogue import DETERMINISTIC
from pyhrg.gap.effects.design import Design
from pyhrg.gap.evidence.evidence import Fit, fit
from pyhrg.gap.evidence.extension import Extensions
from pyhrg.gap.evidence.search import PRODUCT_WEIGHT, Ranking, rank_sets
from tests.pyhrg.gap.made_up import design_of

ROWS = 4000


def test_two_effects_are_found_behind_one_term() -> None:
    """Beside two large effects, the term alone explains almost what two others do, and one of these
    alone explains far less."""
    generator = np.random.default_rng(1)
    effects = [e for e in DETERMINISTIC if e.size == 1]
    terms = [CandidateTerm("quadrature_force", "time", f"{i}") for i in range(60)]
    columns = generator.standard_normal((ROWS, len(effects)))
    columns[:, 1] = columns[:, 0] + 0.3 * columns[:, 1]
    columns /= np.linalg.norm(columns, axis=0)
    small = 20 * (columns[:, 0] - columns[:, 1]) / np.linalg.norm(columns[:, 0] - columns[:, 1])
    large = 500 * (columns[:, 2] + columns[:, 3])
    others = generator.standard_normal((ROWS, len(terms))) / np.sqrt(ROWS)
    others[:, 0] = small / 20 + 0.4 * others[:, 0]
    all_columns = np.column_stack([columns, others / np.linalg.norm(others, axis=0)])
    residual = small + large + generator.standard_normal(ROWS)
    groups = {group: np.array([i]) for i, group in enumerate((*effects, *terms))}
    design = Design(
        all_columns.T @ all_columns,
        all_columns.T @ residual,
        float(residual @ residual),
        groups,
        np.full(len(groups), 1e5),  # 20 sigma are a typical size
        (),
    )
    assert set(rank_sets(design).best.groups) == set(effects[:4])


def test_effects_are_found_from_the_term_that_stands_for_them() -> None:
    """Of a term with two columns each is almost one effect, so that neither is tried beside it, and
    one effect alone explains far less than the term."""
    generator = np.random.default_rng(11)
    effects = [effect for effect in DETERMINISTIC if effect.size == 1]
    shapes = generator.standard_normal((ROWS, len(effects) + 2)) / np.sqrt(ROWS)
    columns = {effect: 1e5 * shapes[:, [i]] for i, effect in enumerate(effects)}  # 40 sigma: 4e-4
    term = CandidateTerm("quadrature_force", "time", "")
    columns[term] = shapes[:, :2] + 0.15 * shapes[:, -2:]
    residual = 40 * (shapes[:, 0] + shapes[:, 1]) + 500 * (shapes[:, 2] + shapes[:, 3])
    design = design_of(columns, residual + generator.standard_normal(ROWS))
    assert fit(design, [effects[0], term]) is None
    assert set(rank_sets(design, start=[*effects[2:4], term]).best.groups) == set(effects[:4])


def test_a_swarm_of_effects_does_not_keep_a_term_out() -> None:
    """As many effects as a set may have explain most of what the term alone explains."""
    generator = np.random.default_rng(3)
    term = CandidateTerm("quadrature_force", "time", "")
    column = generator.standard_normal((ROWS, 1))
    columns = {e: column + 1.7 * generator.standard_normal((ROWS, e.size)) for e in DETERMINISTIC}
    residual = 15 * column[:, 0] + generator.standard_normal(ROWS)
    assert rank_sets(design_of({**columns, term: column}, residual)).best.groups == (term,)


def test_sets_of_effects_that_fill_the_beam_do_not_keep_a_term_out() -> None:
    """Four effects explain most of what a term explains beside a fifth effect, and so do many sets
    of effects that are nearly the same."""
    generator = np.random.default_rng(7)
    effects = [effect for effect in DETERMINISTIC if effect.size == 1]
    directions = generator.standard_normal((ROWS, 5)) / np.sqrt(ROWS)
    columns = {
        effect: directions[:, [i % 4]] + 0.01 * generator.standard_normal((ROWS, 1)) / np.sqrt(ROWS)
        for i, effect in enumerate(effects[1:])
    }
    columns |= {effects[0]: directions[:, [4]]}
    term = CandidateTerm("gyro_angle", "acceleration", "bias: acceleration z squared")
    columns[term] = directions[:, :4].sum(axis=1, keepdims=True) / 2
    residual = 60 * columns[term][:, 0] + 10 * directions[:, 4]
    ranking = rank_sets(design_of(columns, residual + generator.standard_normal(ROWS)))
    assert set(ranking.best.groups) == {term, effects[0]}


def test_an_effect_never_shares_its_function_with_a_term() -> None:
    """Together they explain more than either: the effect's column is noisier than the term's, and
    the residual bends a little. The best set has the effect alone, and no set has both; another
    function of the term's coordinate may stand beside the effect."""
    generator = np.random.default_rng(4)
    effect, time = DETERMINISTIC[0], np.linspace(-1, 1, ROWS)[:, None]
    same, other = (CandidateTerm("gyro_angle", "time", f"bias: power {p}") for p in (1, 3))
    columns = {
        effect: time + 0.1 * generator.standard_normal((ROWS, effect.size)),
        same: time + 0.1 * time**2,
        other: time**3,
    }
    residual = 5 * (columns[effect][:, 0] + 0.2 * time[:, 0] ** 2)
    ranking = rank_sets(design_of(columns, residual + generator.standard_normal(ROWS)))
    assert ranking.best.groups == (effect,)
    assert not any({effect, same} <= set(fitted.groups) for fitted in ranking.fits)
    bent = residual + 2 * time[:, 0] ** 3 + generator.standard_normal(ROWS)
    assert set(rank_sets(design_of(columns, bent)).best.groups) == {effect, other}


def test_required_groups_are_in_every_set() -> None:
    one, other = DETERMINISTIC[:2]
    columns = np.random.default_rng(1).standard_normal((100, 2))
    design = design_of({one: columns[:, :1], other: columns[:, 1:]}, 10 * columns[:, 0])
    assert rank_sets(design).best.groups == (one,)
    ranking = rank_sets(design, required=[other])
    assert all(other in fitted.groups for fitted in ranking.fits)
    assert set(ranking.best.groups) == {one, other}


def test_groups_come_in_the_order_of_their_sets() -> None:
    """The order must not depend on hashes, which differ from process to process."""
    a, b, *more = DETERMINISTIC
    orders = [(b, a), (b,), (a, *more)]
    fits = tuple(Fit(groups, 0.0, 0.0, (), ()) for groups in orders)
    assert Ranking(fits, (0.5, 0.3, 0.2), 0.0).groups == (b, a, *more)


def test_the_next_groups_are_those_that_explain_most_beside_a_set() -> None:
    generator = np.random.default_rng(2)
    sizes = [1, 2, 1, 2, 3, 1, 2]
    ends = np.cumsum(sizes)
    columns = generator.standard_normal((ROWS, ends[-1]))
    columns[:, 1] += columns[:, 0]
    columns /= np.linalg.norm(columns, axis=0)
    residual = columns @ (20 * generator.standard_normal(ends[-1]))
    terms = [CandidateTerm("amplitude", "time", f"{i}") for i in range(len(sizes))]
    where = [np.arange(end - size, end) for end, size in zip(ends, sizes, strict=True)]
    design = Design(
        columns.T @ columns,
        columns.T @ residual,
        float(residual @ residual),
        dict(zip(terms, where, strict=True)),
        np.ones(ends[-1]),
        (),
    )
    prior = list(generator.standard_normal(len(terms)))
    extensions = Extensions(design, terms, prior, range(len(terms)))
    for key in ({0}, {1, 4}, set[int]()):
        explained = {
            i: fitted.explained / 2 + prior[i]
            for i in range(len(terms))
            if i not in key and (fitted := fit(design, [terms[j] for j in (*key, i)]))
        }
        expected = sorted(explained, key=lambda i: -explained[i])
        assert extensions.list_best(key, 3) == expected[:3]


def test_of_two_that_explain_as_much_the_simpler_is_more_probable() -> None:
    generator = np.random.default_rng(5)
    plain, product = (
        CandidateTerm("gyro_angle", "acceleration", f"bias: acceleration y{times}")
        for times in ("", ", times the temperature")
    )
    column = generator.standard_normal((ROWS, 1))
    near = column + 1e-3 * generator.standard_normal((ROWS, 1))
    residual = 0.5 * column[:, 0] + generator.standard_normal(ROWS)
    ranking = rank_sets(design_of({product: near, plain: column}, residual))
    assert ranking.best.groups == (plain,)
    assert ranking.probability(product) == pytest.approx(
        PRODUCT_WEIGHT / (1 + PRODUCT_WEIGHT), rel=0.2
    )
