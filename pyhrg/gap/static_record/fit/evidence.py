"""Evidence of a set of noise terms that exceed the belief, with their levels marginalised
(docs/methods/noise.md, Eq. 7 and 8)."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import block_diag
from scipy.optimize import minimize
from scipy.special import gammaln, logsumexp

from pyhrg.common.arrays import Array
from pyhrg.gap.static_record.belief import Belief
from pyhrg.gap.static_record.fit.likelihood import Transform, compute_log_likelihoods
from pyhrg.gap.static_record.fit.unknowns import average_logs
from pyhrg.noise.likelihood import POWERS

DECADE = float(np.log(10))
"""Prior standard deviation of the natural logarithm of a level that exceeds the belief (chosen)."""
PRIOR_STRENGTH = 10.0
"""Strength at the centre of that prior, in standard deviations of its estimate (chosen)."""
T_FREEDOM = 4
"""Degrees of freedom of the t-distributions that importance samples are drawn from (chosen)."""
SAMPLES = 400
"""Importance samples of an integral (chosen)."""
DIFFERENCE_STEP = 1e-3
"""Step of numerical derivatives, in standard deviations of the prior (chosen)."""
RAMP = "ramp"
"""Name of the random column of a rate ramp."""
PRIOR_RANGE = 8.0
"""Half width of the range of parameters, in standard deviations of the prior (chosen)."""


@dataclass(frozen=True)
class Problem:
    """A transformed record with its belief.

    The parameters are logarithms of levels. The first p belong to the believed noises: their prior
    is normal about the belief with its tolerance. A term that exceeds the belief adds to the
    strengths: the prior of its log level is normal, a decade wide, about the level that the record
    would show with 10 standard deviations if the rest were as believed (Eq. 7).
    """

    data: Transform
    belief: Array
    """(4,) believed levels as square roots of strengths: angles."""
    units: Array
    """(4,) level in SI of a strength of 1."""
    tolerance: float
    """Relative standard deviation of the believed levels."""
    walked: Array
    """(r,) variance of each column's coefficient that a rate random walk of unit strength adds. The
    walk is a bridge, which the cosine transform contains, plus the line between its ends."""

    @cached_property
    def believed(self) -> NDArray[np.int64]:
        """(p,) indices of the noises with a believed level above zero."""
        return np.flatnonzero(self.belief)

    @property
    def effects(self) -> int:
        """Number of terms that may exceed the belief: four noises, then the random columns."""
        return len(self.belief) + len(self.data.names)

    @cached_property
    def without_extra(self) -> tuple[Array, Array]:
        """Mode (p,) and square root (p, p) of the covariance of the parameters, if no term exceeds
        the belief."""
        mode = _find_mode(self, (), np.zeros(len(self.believed)))
        return mode, _compute_covariance_root(self, (), mode)

    @cached_property
    def centres(self) -> Array:
        """(e,) logarithms of levels at which the priors of the terms are centred."""
        density = self.belief**2 @ self.data.bands.shapes
        noise = np.sqrt(2 / ((self.data.bands.shapes / density) ** 2 @ self.data.bands.count))
        r = np.arange(self.data.free, len(self.data.columns))
        column = 1 / np.sum(self.data.squares[r, r] / density, axis=-1)
        return 0.5 * np.log(PRIOR_STRENGTH * np.concatenate([noise, column]))

    def unpack(self, extra: Sequence[int], parameters: Array) -> tuple[Array, Array]:
        """Strengths (s, 4) of the noises and variances (s, r) of the columns, of s parameter
        vectors (s, p + x) with x terms that exceed the belief."""
        total = np.zeros((len(parameters), self.effects))
        centre, width = self.prior(extra)
        parameters = np.clip(parameters, centre - PRIOR_RANGE * width, centre + PRIOR_RANGE * width)
        p = len(self.believed)
        total[:, self.believed] = (self.belief[self.believed] * np.exp(parameters[:, :p])) ** 2
        total[:, list(extra)] += np.exp(2 * parameters[:, p:])
        return total[:, :4], total[:, 4:] + total[:, 3:4] * self.walked

    def log_prior(self, extra: Sequence[int], parameters: Array) -> Array:
        """(s,) log prior density of parameters (s, p + x)."""
        centre, width = self.prior(extra)
        away = (parameters - centre) / width
        return np.asarray(-0.5 * np.sum(away**2 + np.log(2 * np.pi * width**2), axis=1))

    def prior(self, extra: Sequence[int]) -> tuple[Array, Array]:
        """Prior means and standard deviations (p + x,) of the parameters."""
        p = len(self.believed)
        centre = np.concatenate([np.zeros(p), self.centres[list(extra)]])
        return centre, np.concatenate([np.full(p, self.tolerance), np.full(len(extra), DECADE)])

    def log_posterior(self, extra: Sequence[int], parameters: Array) -> Array:
        """(s,) log likelihood plus log prior."""
        return compute_log_likelihoods(self.data, *self.unpack(extra, parameters)) + self.log_prior(
            extra, parameters
        )


def build_problem(data: Transform, belief: Belief, interval: float) -> Problem:
    """A record with its belief; levels are converted to a time unit of one interval (s)."""
    units = interval ** ((1 - np.maximum(POWERS, 1)) / 2)
    ramp = np.array([name == RAMP for name in data.names])
    walked = ramp * data.lengths**2 / (data.n * interval**4)
    return Problem(data, belief.levels / units, units, belief.tolerance, walked)


@dataclass(frozen=True)
class Posterior:
    """The posterior distribution of a set of terms, as weighted samples.

    extra: indices of the terms that exceed the belief.
    log_evidence: natural logarithm of the marginal likelihood.
    parameters: (s, p + x) samples.
    weights: (s,) of the samples; their sum is 1.
    """

    problem: Problem
    extra: tuple[int, ...]
    log_evidence: float
    parameters: Array
    weights: Array

    @cached_property
    def levels(self) -> Array:
        """(s, e) levels of all terms: square roots of strengths and variances."""
        return np.sqrt(np.concatenate(self.problem.unpack(self.extra, self.parameters), axis=1))

    @property
    def best(self) -> tuple[Array, Array]:
        """(4,) strengths and (r,) variances at the posterior mean of the parameters."""
        mean = self.weights @ self.parameters
        strengths, variances = self.problem.unpack(self.extra, mean[np.newaxis])
        return strengths[0], variances[0]


def compute_posterior(problem: Problem, extra: Sequence[int], seed: int = 0) -> Posterior:
    """Posterior and evidence of a set of terms, by their indices, by importance sampling (Eq. 8).

    Half of the samples are drawn about the posterior mode. The other half is drawn about the mode
    without the terms, with the terms as in their prior.
    """
    extra = tuple(extra)
    mode = max(
        (_find_mode(problem, extra, start) for start in _choose_starts(problem, extra)),
        key=lambda x: float(problem.log_posterior(extra, x[np.newaxis])[0]),
    )
    nothing, width = problem.without_extra, DECADE * np.eye(len(extra))
    centres = np.array([mode, [*nothing[0], *problem.centres[list(extra)]]])
    roots = np.array(
        [_compute_covariance_root(problem, extra, mode), block_diag(nothing[1], width)]
    )
    parameters = _draw_samples(centres, roots, np.random.default_rng([seed, *extra]))
    logs = problem.log_posterior(extra, parameters) - _compute_log_density(
        parameters, centres, roots
    )
    total = float(logsumexp(logs))
    return Posterior(problem, extra, total - np.log(len(logs)), parameters, np.exp(logs - total))


def _draw_samples(centres: Array, roots: Array, generator: np.random.Generator) -> Array:
    """(s, d) samples of multivariate t-distributions, the same number of each."""
    k, d = centres.shape
    normal = generator.standard_normal((k, SAMPLES // k, d))
    t = normal / np.sqrt(generator.chisquare(T_FREEDOM, (k, SAMPLES // k, 1)) / T_FREEDOM)
    return np.asarray(centres[:, np.newaxis] + t @ np.swapaxes(roots, 1, 2)).reshape(-1, d)


def _compute_log_density(parameters: Array, centres: Array, roots: Array) -> Array:
    """(s,) log density of the mixture with equal weights."""
    d = parameters.shape[1]
    constant = (
        gammaln((T_FREEDOM + d) / 2) - gammaln(T_FREEDOM / 2) - d / 2 * np.log(T_FREEDOM * np.pi)
    )
    logs = []
    for centre, root in zip(centres, roots, strict=True):
        t = np.linalg.solve(root, (parameters - centre).T)
        tail = (T_FREEDOM + d) / 2 * np.log1p(np.sum(t**2, axis=0) / T_FREEDOM)
        logs.append(constant - tail - np.linalg.slogdet(root)[1])
    return average_logs(np.array(logs))


def _choose_starts(problem: Problem, extra: tuple[int, ...]) -> list[Array]:
    """Starting points: levels at the centre of the prior, and the largest levels that the record
    allows."""
    data, p = problem.data, len(problem.believed)
    noise = np.min(data.power / data.bands.count / data.bands.shapes, axis=1)
    density = np.maximum(problem.belief**2 @ data.bands.shapes, data.power / data.bands.count)
    r = np.arange(data.free, len(data.columns))
    column = (
        np.sum(data.products[r] / density, axis=-1) / np.sum(data.squares[r, r] / density, axis=-1)
    ) ** 2
    most = 0.5 * np.log(np.maximum(np.concatenate([noise, column]), 1e-300))
    most = np.clip(
        most, problem.centres - PRIOR_RANGE * DECADE, problem.centres + PRIOR_RANGE * DECADE
    )
    return [
        np.concatenate([np.zeros(p), levels[list(extra)]])
        for levels in ((problem.centres, most) if extra else (problem.centres,))
    ]


def _find_mode(problem: Problem, extra: tuple[int, ...], start: Array) -> Array:
    """Parameters (p + x,) of largest posterior density, by L-BFGS-B in standard deviations of the
    prior."""
    centre, width = problem.prior(extra)
    steps = DIFFERENCE_STEP * np.concatenate([np.zeros((1, len(start))), np.eye(len(start))])
    steps = np.concatenate([steps, -steps[1:]])

    def compute_loss(x: Array) -> tuple[float, Array]:
        values = -problem.log_posterior(extra, centre + width * (x + steps))
        ahead, behind = np.split(values[1:], 2)
        return float(values[0]), (ahead - behind) / (2 * DIFFERENCE_STEP)

    bounds = [(-PRIOR_RANGE, PRIOR_RANGE)] * len(start)
    options = {"ftol": 1e-9, "gtol": 0.01}
    begin = (start - centre) / width
    result = minimize(
        compute_loss, begin, jac=True, method="L-BFGS-B", bounds=bounds, options=options
    )
    return np.asarray(centre + width * result.x)


def _compute_covariance_root(problem: Problem, extra: tuple[int, ...], mode: Array) -> Array:
    """Square root of the covariance from the curvature at the mode, nowhere wider than the
    prior."""
    d, step = len(mode), 10 * DIFFERENCE_STEP
    shift = step * np.eye(d)
    signs = [(1, 1), (1, -1), (-1, 1), (-1, -1)]
    points = np.array(
        [a * shift[i] + b * shift[j] for a, b in signs for i in range(d) for j in range(d)]
    )
    values = problem.log_posterior(extra, mode + points).reshape(4, d, d)
    curvature = -(values[0] - values[1] - values[2] + values[3]) / (4 * step**2)
    width = problem.prior(extra)[1]
    size, axes = np.linalg.eigh((curvature + curvature.T) / 2 * np.outer(width, width))
    return np.asarray(width[:, np.newaxis] * axes / np.sqrt(np.maximum(size, 1.0)))
