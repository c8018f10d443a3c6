"""What is known within a tolerance, integrated out of the normal equations.

Every nominal value is a little wrong, and so is every bench. Such a parameter has a normal prior
about its stated value, with its tolerance as the standard deviation. It takes part in every
hypothesis (docs/methods/effects.md, Eqs. 10 to 12). So has the form of a cause without a name. A
parameter may also be wrong by far more: it is then a group of a set (Eq. 12a).
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import accumulate

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import cho_factor, cho_solve

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.design import Design, Sizes
from pyhrg.gap.effects.form import Form
from pyhrg.gap.effects.linear_test import Group

MIN_SHARE = 1e-3
"""An effect is part of a cause when the cause's terms and forms leave less than this share of its
power. Chosen."""
PINV_SHARE = 1e-6
"""Share of the largest eigenvalue below which a direction of terms and forms counts as none."""
SMALLEST_SHARE = 1e-10
"""Share of a column that counts as nothing left. Chosen: rounding of the normal equations."""


@dataclass(frozen=True)
class KnownParameters:
    """What the tests and the tolerances say of the known parameters, beside any set of groups.

    whole: normal equations with all columns.
    tolerances: standard deviation of each component before the tests, SI; of parameters and forms.
    terms: whose forms these are. Of a form counts what the terms don't explain: their sizes are
        those that explain most of the cause.
    """

    whole: Design
    tolerances: Mapping[Effect | Form, float]
    terms: tuple[CandidateTerm, ...] = ()

    @property
    def effects(self) -> tuple[Effect, ...]:
        """Known parameters that the tests see."""
        return tuple(group for group in self._groups if isinstance(group, Effect))

    @cached_property
    def _groups(self) -> tuple[Effect | Form, ...]:
        """These, and the forms that the tests see."""
        seen = self._apart.groups
        return tuple(group for group in self.tolerances if group in seen)

    @cached_property
    def _apart(self) -> Design:
        """The normal equations with what the terms explain of the forms taken out of these."""
        whole, forms = self.whole, self._of_forms
        if not forms.size:
            return whole
        moved = self._change[:, forms]
        scale = moved[forms, range(len(forms))]
        norms = whole.norms.copy()
        norms[forms] = np.divide(norms[forms], scale, out=np.zeros_like(scale), where=scale > 0)
        gram, projection = whole.gram.copy(), whole.projection.copy()
        products = whole.gram @ moved
        gram[:, forms], gram[forms] = products, products.T
        gram[np.ix_(forms, forms)] = moved.T @ products
        projection[forms] = moved.T @ projection
        return replace(whole, gram=gram, projection=projection, norms=norms)

    @cached_property
    def _change(self) -> Array:
        """(p, p) the columns of `_apart` in those of `whole`."""
        whole, forms = self.whole, self._of_forms
        change = np.eye(len(whole.projection))
        change[np.ix_(self._of_terms, forms)] = -self._shares
        power = (change[:, forms] * (whole.gram @ change[:, forms])).sum(axis=0)
        power = np.where(power > SMALLEST_SHARE, power, 0.0)
        scale = np.divide(1.0, np.sqrt(power), out=np.zeros_like(power), where=power > 0)
        change[:, forms] *= scale
        return change

    @cached_property
    def marginal(self) -> Design:
        """Normal equations of all other groups, and of known parameters beyond their tolerance,
        with the known parameters within it integrated out."""
        if not self.tolerances:
            return self._apart
        whole, known, others = self._apart, self._known, self._others
        beyond = self.whole.list_columns(self.effects)
        free, rows = np.concatenate([others, beyond]), np.isin(known, beyond)
        gain = self._solve(whole.gram[np.ix_(known, free)])
        own = self._solve(whole.projection[known])
        cross_beyond = (gain / self._prior_variance[:, None])[rows]
        cross, count = whole.gram[np.ix_(known, others)], len(others)
        gram = whole.gram[np.ix_(free, free)]
        gram[:count, :count] -= cross.T @ gain[:, :count]
        gram[count:], gram[:count, count:] = cross_beyond, cross_beyond[:, :count].T
        projection = whole.projection[free]
        projection[:count] -= cross.T @ own
        projection[count:] = (own / self._prior_variance)[rows]
        scale = 1 / np.sqrt(np.concatenate([self._remaining_power, gram.diagonal()[count:]]))
        places = np.full(len(whole.projection), -1)
        places[free] = np.arange(len(free))
        is_seen = ~np.isin(free, self._find_shared_effects())
        return replace(
            whole,
            gram=gram * np.outer(scale, scale),
            projection=projection * scale,
            power=whole.power - float(whole.projection[known] @ own),
            norms=whole.norms[free] / scale * is_seen,
            columns={
                g: places[c]
                for g, c in whole.columns.items()
                if g not in self.tolerances or g in self.effects
            },
            log_volume=self._log_volume,
        )

    def estimate(self, sizes: Sizes) -> dict[Effect, Array]:
        """(d,) most probable departure of each known parameter beside groups of these sizes, SI;
        all of it where the parameter is one of them."""
        return {g: v for g, v in self._estimate_all(sizes).items() if isinstance(g, Effect)}

    def complete(self, sizes: Sizes) -> dict[Group, Array]:
        """Groups of these sizes, and all that is known within a tolerance beside them. What the
        terms explain of the forms is taken out of the terms' sizes."""
        apart, all_sizes = self._apart, dict(sizes)
        all_sizes.update(self._estimate_all(sizes).items())
        unit = np.zeros(len(apart.norms))
        for group, size in all_sizes.items():
            own = apart.columns[group]
            unit[own] = size * apart.norms[own]
        unit, norms = self._change @ unit, self.whole.norms
        values = np.divide(unit, norms, out=np.zeros_like(unit), where=norms > 0)
        return {group: values[apart.columns[group]] for group in (*all_sizes, *self.terms)}

    def estimate_jointly(
        self, fitted: Sequence[Group], groups: Sequence[Group]
    ) -> tuple[Array, Array]:
        """(n,) sizes of some groups and forms as `complete` has them, and their (n, n) covariance,
        beside a fitted set."""
        whole, known = self._apart, self._known
        where = np.concatenate([known, *(whole.columns[group] for group in fitted)])
        information = whole.gram[np.ix_(where, where)].copy()
        information[: len(known), : len(known)] += np.diag(1 / self._prior_variance)
        covariance = np.linalg.inv(information)
        own = self.whole.list_columns(groups)
        change = self._change[np.ix_(own, where)] / self.whole.norms[own][:, None]
        values = change @ covariance @ whole.projection[where]
        return np.asarray(values), np.asarray(change @ covariance @ change.T)

    def _estimate_all(self, sizes: Sizes) -> dict[Effect | Form, Array]:
        whole, projection = self._apart, self._apart.projection[self._known]
        for group, size in sizes.items():
            own = whole.columns[group]
            unit = size * whole.norms[own]
            projection = projection - whole.gram[np.ix_(self._known, own)] @ unit
        values = self._solve(projection) / whole.norms[self._known]
        return {g: values[part] + sizes.get(g, 0.0) for g, part in self._parts.items()}

    def compute_covariances(self, groups: Sequence[Group]) -> dict[Effect | Form, Array]:
        """(d, d) covariance of each of these beside fitted groups, SI. Known parameters among the
        groups have no tolerance."""
        whole, count = self._apart, len(self._known)
        others = [whole.columns[group] for group in groups if group not in self._groups]
        where = np.concatenate([self._known, *others])
        information = whole.gram[np.ix_(where, where)]
        is_fitted = np.isin(self._known, self.whole.list_columns(set(groups) & set(self._groups)))
        information[:count, :count] += np.diag(~is_fitted / self._prior_variance)
        scale = 1 / whole.norms[self._known]
        total = np.linalg.inv(information)[:count, :count] * np.outer(scale, scale)
        return {g: total[part, part] for g, part in self._parts.items()}

    @cached_property
    def _known(self) -> NDArray[np.int64]:
        return self.whole.list_columns(self._groups)

    @cached_property
    def _others(self) -> NDArray[np.int64]:
        return self.whole.list_columns(g for g in self.whole.columns if g not in self.tolerances)

    @cached_property
    def _parts(self) -> dict[Effect | Form, slice]:
        """Where each of these groups stands in vectors of all of them."""
        ends = accumulate(group.size for group in self._groups)
        return {g: slice(end - g.size, end) for g, end in zip(self._groups, ends, strict=True)}

    @cached_property
    def _prior_variance(self) -> Array:
        """Variance before the tests, in units of the design's columns."""
        sigmas = [np.full(group.size, self.tolerances[group]) for group in self._groups]
        return np.asarray((np.concatenate([[], *sigmas]) * self._apart.norms[self._known]) ** 2)

    @cached_property
    def _factor(self) -> tuple[Array, bool]:
        gram = self._apart.gram[np.ix_(self._known, self._known)]
        return cho_factor(gram + np.diag(1 / self._prior_variance))

    @property
    def _remaining_power(self) -> Array:
        """Share of the power of each other group's columns that the forms leave: forms count as
        noise, with which columns are whitened too."""
        own = np.isin(self._known, self._of_forms)
        cross = self._apart.gram[np.ix_(self._known[own], self._others)]
        gram = self._apart.gram[np.ix_(self._known[own], self._known[own])]
        gain = np.linalg.solve(gram + np.diag(1 / self._prior_variance[own]), cross)
        return np.asarray(np.maximum(1 - (cross * gain).sum(axis=0), SMALLEST_SHARE))

    def _find_shared_effects(self) -> NDArray[np.int64]:
        """Columns of effects of which a cause's terms and its forms, if they may have any size,
        leave next to nothing: these are part of the same function."""
        if not self.terms:
            return np.empty(0, np.int64)
        gram, cause = self.whole.gram, np.concatenate([self._of_terms, self._of_forms])
        cause = cause[self.whole.norms[cause] > 0]
        effects = [g for g in self.whole.groups if isinstance(g, Effect)]
        own = self.whole.list_columns(g for g in effects if g not in self.tolerances)
        cross = gram[np.ix_(cause, own)]
        inside = (cross * (self._invert(cause) @ cross)).sum(axis=0)
        shared = set(own[1 - inside < MIN_SHARE])
        return self.whole.list_columns(g for g in effects if shared & set(self.whole.columns[g]))

    @cached_property
    def _shares(self) -> Array:
        """(t, f) sizes with which the terms explain most of each form, in units of the columns.
        Under some noises two terms are the same function, or one is not seen."""
        gram, terms = self.whole.gram, self._of_terms
        return self._invert(terms) @ gram[np.ix_(terms, self._of_forms)]

    def _invert(self, columns: NDArray[np.int64]) -> Array:
        """Pseudo-inverse of the products of some columns, which may be collinear."""
        own = self.whole.gram[np.ix_(columns, columns)]
        return np.asarray(np.linalg.pinv(own, PINV_SHARE, hermitian=True))

    @property
    def _of_terms(self) -> NDArray[np.int64]:
        return self.whole.list_columns(self.terms)

    @property
    def _of_forms(self) -> NDArray[np.int64]:
        return self.whole.list_columns([g for g in self.tolerances if isinstance(g, Form)])

    @property
    def _log_volume(self) -> float:
        diagonal = np.diag(self._factor[0])
        return float(2 * np.log(diagonal).sum() + np.log(self._prior_variance).sum())

    def _solve(self, values: Array) -> Array:
        if not self._groups:
            return np.zeros_like(values)
        return np.asarray(cho_solve(self._factor, values))
