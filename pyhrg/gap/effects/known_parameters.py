"""What is known within a tolerance, integrated out of the normal equations.

Every nominal value is a little wrong, and so is every bench. Such a parameter has a normal prior
about its told value, with its tolerance as the standard deviation. It takes part in every
hypothesis (docs/methods/effects.md, Eqs. 10 to 12). So has the form of a cause without a name.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import cho_factor, cho_solve

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.design import Design, Group, Sizes
from pyhrg.gap.effects.form import Form

SMALLEST_SHARE = 1e-12
"""Share of a column that counts as nothing left. Chosen: rounding of the normal equations."""


@dataclass(frozen=True)
class KnownParameters:
    """What the tests and the tolerances say of the known parameters, beside any set of groups.

    whole: normal equations with all columns.
    tolerances: standard deviation of each component before the tests, SI; of parameters and forms.
    """

    whole: Design
    tolerances: Mapping[Effect | Form, float]

    @property
    def effects(self) -> tuple[Effect, ...]:
        """Known parameters that the tests see."""
        return tuple(group for group in self._groups if isinstance(group, Effect))

    @cached_property
    def _groups(self) -> tuple[Effect | Form, ...]:
        """These, and the forms that the tests see."""
        seen = self.whole.groups
        return tuple(group for group in self.tolerances if group in seen)

    @cached_property
    def marginal(self) -> Design:
        """Normal equations of all other groups, with the known parameters integrated out."""
        if not self.tolerances:
            return self.whole
        whole, known, others = self.whole, self._known, self._others
        cross = whole.gram[np.ix_(known, others)]
        gain = self._solve(cross)
        own = self._solve(whole.projection[known])
        places = np.full(len(whole.projection), -1)
        places[others] = np.arange(len(others))
        scale = 1 / np.sqrt(self._left_by_forms)
        gram = whole.gram[np.ix_(others, others)] - cross.T @ gain
        return replace(
            whole,
            gram=gram * np.outer(scale, scale),
            projection=(whole.projection[others] - cross.T @ own) * scale,
            power=whole.power - float(whole.projection[known] @ own),
            norms=whole.norms[others] / scale,
            columns={g: places[c] for g, c in whole.columns.items() if g not in self.tolerances},
            log_volume=self._log_volume,
        )

    def estimate(self, sizes: Sizes) -> dict[Effect | Form, Array]:
        """(d,) most probable departure of each of these beside groups of these sizes, SI."""
        whole, projection = self.whole, self.whole.projection[self._known]
        for group, size in sizes.items():
            own = whole.columns[group]
            unit = size * whole.norms[own]
            projection = projection - whole.gram[np.ix_(self._known, own)] @ unit
        values = self._solve(projection) / whole.norms[self._known]
        return {
            g: values[end - g.size : end] for g, end in zip(self._groups, self._ends, strict=True)
        }

    def compute_covariances(self, groups: Sequence[Group]) -> dict[Effect | Form, Array]:
        """(d, d) covariance of each of these beside fitted groups, SI."""
        whole, count = self.whole, len(self._known)
        where = np.concatenate([self._known, *(whole.columns[group] for group in groups)])
        information = whole.gram[np.ix_(where, where)].copy()
        information[:count, :count] += np.diag(1 / self._prior_variance)
        scale = 1 / whole.norms[self._known]
        total = np.linalg.inv(information)[:count, :count] * np.outer(scale, scale)
        parts = [slice(end - g.size, end) for g, end in zip(self._groups, self._ends, strict=True)]
        return {g: total[part, part] for g, part in zip(self._groups, parts, strict=True)}

    @cached_property
    def _known(self) -> NDArray[np.int64]:
        columns = [self.whole.columns[group] for group in self._groups]
        return np.concatenate([np.empty(0, np.int64), *columns])

    @cached_property
    def _others(self) -> NDArray[np.int64]:
        columns = [c for g, c in self.whole.columns.items() if g not in self.tolerances]
        return np.concatenate([np.empty(0, np.int64), *columns])

    @cached_property
    def _ends(self) -> NDArray[np.int64]:
        return np.cumsum([group.size for group in self._groups], dtype=np.int64)

    @cached_property
    def _prior_variance(self) -> Array:
        """Variance before the tests, in units of the design's columns."""
        sigmas = [np.full(group.size, self.tolerances[group]) for group in self._groups]
        return np.asarray((np.concatenate([[], *sigmas]) * self.whole.norms[self._known]) ** 2)

    @cached_property
    def _factor(self) -> tuple[Array, bool]:
        gram = self.whole.gram[np.ix_(self._known, self._known)]
        return cho_factor(gram + np.diag(1 / self._prior_variance))

    @property
    def _left_by_forms(self) -> Array:
        """Share of the power of each other group's columns that the forms leave: they count as
        noise, with which columns are whitened too."""
        forms = [g for g in self._groups if isinstance(g, Form)]
        of_forms = np.concatenate([np.empty(0, np.int64), *(self.whole.columns[f] for f in forms)])
        own = np.isin(self._known, of_forms)
        cross = self.whole.gram[np.ix_(self._known[own], self._others)]
        gram = self.whole.gram[np.ix_(self._known[own], self._known[own])]
        gain = np.linalg.solve(gram + np.diag(1 / self._prior_variance[own]), cross)
        return np.asarray(np.maximum(1 - (cross * gain).sum(axis=0), SMALLEST_SHARE))

    @property
    def _log_volume(self) -> float:
        diagonal = np.diag(self._factor[0])
        return float(2 * np.log(diagonal).sum() + np.log(self._prior_variance).sum())

    def _solve(self, values: Array) -> Array:
        if not self._groups:
            return np.zeros_like(values)
        return np.asarray(cho_solve(self._factor, values))
