"""Normal equations of a campaign: residuals, sensitivities and candidate terms, whitened."""

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.form import Form
from pyhrg.gap.effects.jump import Jump
from pyhrg.gap.effects.linear_test import Group, LinearTest, whiten_gyro_residual, whiten_terms
from pyhrg.gap.replay.observations import CHANNELS
from pyhrg.gap.whitening.campaign_noise import CampaignNoise

Sizes = Mapping[Group, Array]
"""Size of each group, in units of its columns."""
TestChannel = tuple[str, str]
"""Id of a test, and a channel."""

SAME_FUNCTION_SHARE = 0.1
"""Share of a candidate term's power below which what an effect leaves of it has no meaning. Chosen:
terms are approximate shapes."""
MODEL_ERROR_POWER = 1e-10
"""Share of the power of a channel's response in a test that the simulation may get wrong (Eq. (9)).
Derived: two simulators of the same physics, written independently, agree to 1e-5 of a response."""
MIN_NORM = 1e-9
"""Norm of a whitened column below which these tests don't see it. Chosen."""


@dataclass(frozen=True)
class Block:
    """Contribution of one channel of one test to the normal equations.

    columns: (q - 1,) indices of the design's columns that take part.
    gram: (q, q) products of these columns and, last, the residual, all whitened.
    rows: number that were compared.
    log_determinant: of the noise's covariance.
    model_error: chi-square that simulation and linearization may get wrong. It scales the noise
        (docs/methods/effects.md, Eq. 9).
    """

    test: str
    channel: str
    columns: NDArray[np.int64]
    gram: Array
    rows: int
    log_determinant: float
    model_error: float = 0.0


@dataclass(frozen=True)
class Design:
    """Normal equations of a campaign, for columns of unit norm (docs/methods/effects.md, Eq. 8).

    gram: (p, p) products of the columns.
    projection: (p,) products of the columns with the residual.
    power: squared norm of the whitened residual, a chi-square.
    columns: indices of each group's columns.
    norms: (p,) of the whitened columns before they were scaled, standard deviations of the noise
        per unit of the column; 0 where the tests don't see it.
    blocks: contribution of each channel of each test.
    log_volume: logarithm of the determinant that parameters known within a tolerance add to the
        covariance of the residual; 0 where none is integrated out.
    """

    gram: Array
    projection: Array
    power: float
    columns: Mapping[Group, NDArray[np.int64]]
    norms: Array
    blocks: tuple[Block, ...]
    log_volume: float = 0.0

    @property
    def log_likelihood(self) -> float:
        """Logarithm of the residual's likelihood if nothing explains it, up to a constant."""
        log_determinant = sum(b.log_determinant / (1 + b.model_error) for b in self.blocks)
        return -(self.power + log_determinant + self.log_volume) / 2

    @property
    def model_error(self) -> dict[TestChannel, float]:
        """Chi-square of each channel of each test that counts as noise."""
        return {(b.test, b.channel): b.model_error for b in self.blocks}

    @cached_property
    def log_volumes(self) -> dict[Group, float]:
        """Half the log determinant of each group's own products."""
        by_size: dict[int, list[Group]] = {}
        for group, where in self.columns.items():
            by_size.setdefault(len(where), []).append(group)
        volumes: dict[Group, float] = {}
        for groups in by_size.values():
            where = np.array([self.columns[group] for group in groups])
            own = self.gram[where[:, :, None], where[:, None, :]]
            volumes.update(zip(groups, (np.linalg.slogdet(own)[1] / 2).tolist(), strict=True))
        return volumes

    @cached_property
    def namesakes(self) -> dict[Effect, CandidateTerm]:
        """The candidate term that is the same function as an effect, for each effect that has one:
        of all terms the one with a direction of which the effect leaves least, and less than
        `SAME_FUNCTION_SHARE` (1 less the square of the largest canonical correlation)."""
        by_size: dict[int, list[CandidateTerm]] = {}
        for group in self.groups:
            if isinstance(group, CandidateTerm):
                by_size.setdefault(len(self.columns[group]), []).append(group)
        closest: dict[Effect, tuple[float, CandidateTerm]] = {}
        for terms in by_size.values():
            where = np.array([self.columns[term] for term in terms])
            own = self.gram[where[:, :, None], where[:, None, :]]
            inverse = np.linalg.inv(own + MIN_NORM * np.eye(where.shape[1]))
            for effect in (group for group in self.groups if isinstance(group, Effect)):
                rows = self.columns[effect]
                cross = np.moveaxis(self.gram[rows][:, where], 0, 1)
                shared = np.linalg.solve(self.gram[np.ix_(rows, rows)], cross)
                products = inverse @ np.swapaxes(cross, 1, 2) @ shared
                remaining = 1 - np.linalg.eigvals(products).real.max(axis=1)
                best = int(np.argmin(remaining))
                least = closest.get(effect, (SAME_FUNCTION_SHARE, terms[best]))
                if remaining[best] < least[0]:
                    closest[effect] = float(remaining[best]), terms[best]
        return {effect: term for effect, (_, term) in closest.items()}

    @cached_property
    def groups(self) -> list[Group]:
        """Groups all of whose columns the tests see."""
        return [group for group, own in self.columns.items() if (self.norms[own] > 0).all()]

    def list_columns(self, groups: Iterable[Group]) -> NDArray[np.int64]:
        """Indices of the columns of some groups, in their order."""
        own = (self.columns[group] for group in groups)
        return np.concatenate([np.empty(0, np.int64), *own])


def list_rival_terms(design: Design, term: CandidateTerm) -> list[CandidateTerm]:
    """Candidate terms of a term's channel, jumps left out: what may stand in its place."""
    terms = [g for g in design.groups if isinstance(g, CandidateTerm) and not isinstance(g, Jump)]
    return [g for g in terms if g.channel == term.channel and not isinstance(term, Jump)]


def build_design(
    parts: Sequence[LinearTest],
    noise: CampaignNoise,
    model_error: Mapping[TestChannel, float] | None = None,
    jumps: Sequence[Jump] = (),
    forms: Collection[Form] = (),
) -> Design:
    """Whiten all series of linearized tests and sum up the normal equations
    (docs/methods/effects.md, Eqs. 7 to 9). Jumps are candidates in addition to effects and
    candidate terms. Forms are what large terms may miss; these terms and forms act in other
    channels too where they make the pattern be read at a wrong angle."""
    error = model_error or {}
    columns: dict[Group, NDArray[np.int64]] = {}
    _assign_columns(columns, {effect: effect.size for effect in parts[0].sensitivities})
    shared = np.concatenate([np.empty(0, np.int64), *columns.values()])
    blocks = []
    for channel in CHANNELS:
        for index, part in enumerate(parts):
            white = whiten_terms(part, channel, jumps, forms, noise)
            if index == 0:
                sizes = white.sizes.items()
                counts = {t: len(parts) if t.is_of_each_power_on else n for t, n in sizes}
                _assign_columns(columns, counts)
            own = [
                columns[t][[index]] if t.is_of_each_power_on else columns[t] for t in white.sizes
            ]
            indices = np.concatenate([shared, *own])
            blocks.append(
                Block(
                    part.test.test.id,
                    channel,
                    indices,
                    white.gram,
                    int(part.test.rows[channel].sum()),
                    white.log_determinant,
                    error.get((part.test.test.id, channel), 0.0),
                )
            )
    return _assemble(columns, blocks)


def _assign_columns(
    columns: dict[Group, NDArray[np.int64]],
    sizes: Mapping[CandidateTerm, int] | Mapping[Effect, int],
) -> None:
    """Give each group that has no indices in `columns` the next ones, as many as its size."""
    count = sum(map(len, columns.values()))
    for group, size in sizes.items():
        if group not in columns:
            columns[group] = np.arange(count, count + size)
            count += size


def _assemble(columns: Mapping[Group, NDArray[np.int64]], blocks: Sequence[Block]) -> Design:
    count = sum(map(len, columns.values()))
    total, projection, power = np.zeros((count, count)), np.zeros(count), 0.0
    for channel in dict.fromkeys(block.channel for block in blocks):
        own = [block for block in blocks if block.channel == channel]
        grams = [block.gram / (1 + block.model_error) for block in own]
        where = np.array([block.columns for block in own])
        _add_products(total, where, grams)
        for places, gram in zip(where, grams, strict=True):
            projection[places] += gram[:-1, -1]
            power += float(gram[-1, -1])
    norms = np.sqrt(np.diag(total))
    norms[norms < MIN_NORM] = 0.0
    unit = np.divide(1.0, norms, out=np.zeros(count), where=norms > 0)
    gram = total * np.outer(unit, unit)
    return Design(gram, projection * unit, power, columns, norms, tuple(blocks))


def _add_products(total: Array, where: NDArray[np.int64], grams: Sequence[Array]) -> None:
    """Add the products of one channel's columns in k tests to those of the design. `where`, (k, q):
    the design's columns in each test; what all tests have in the same columns is summed first."""
    is_shared = (where == where[0]).all(axis=0)
    shared = where[0][is_shared]
    summed = np.zeros((len(is_shared), len(is_shared)))
    for places, gram in zip(where, grams, strict=True):
        products, own = gram[:-1, :-1], places[~is_shared]
        summed += products
        if len(own):
            total[np.ix_(own, places)] += products[~is_shared]
            total[np.ix_(shared, own)] += products[np.ix_(is_shared, ~is_shared)]
    total[np.ix_(shared, shared)] += summed[np.ix_(is_shared, is_shared)]


def select_groups(design: Design, groups: Sequence[Group]) -> Design:
    """The equations of some groups alone."""
    where = design.list_columns(groups)
    ends = np.cumsum([len(design.columns[group]) for group in groups]).tolist()
    columns = {
        group: np.arange(end - len(design.columns[group]), end)
        for group, end in zip(groups, ends, strict=True)
    }
    return replace(
        design,
        gram=design.gram[np.ix_(where, where)],
        projection=design.projection[where],
        norms=design.norms[where],
        columns=columns,
    )


def subtract_sizes(gram: Array, where: NDArray[np.int64], sizes: Array) -> Array:
    """Products after columns of these sizes are subtracted from the residual, the last column."""
    change = np.eye(len(gram))
    change[where, -1] = -sizes
    return np.asarray(change.T @ gram @ change)


def remove_effects(design: Design, sizes: Mapping[Effect, Array]) -> Design:
    """The equations of the residual without effects of these sizes, SI."""
    where = design.list_columns(sizes)
    removed = np.zeros(len(design.norms))
    removed[where] = np.concatenate([np.empty(0), *sizes.values()])
    blocks = [
        replace(b, gram=subtract_sizes(b.gram, np.arange(len(b.columns)), removed[b.columns]))
        for b in design.blocks
    ]
    return _assemble(design.columns, blocks)


def discount_model_error(design: Design, model_error: Mapping[TestChannel, float]) -> Design:
    """Equations with a chi-square per test and channel counted as noise (Eq. 9).

    It stands for errors of the simulation, and for what a linear search misses of a large response.
    """
    blocks = [
        replace(b, model_error=model_error.get((b.test, b.channel), 0.0)) for b in design.blocks
    ]
    return _assemble(design.columns, blocks)


def measure_power(design: Design, sizes: Mapping[CandidateTerm, Array]) -> float:
    """Chi-square of what groups of these sizes make in all tests."""
    unit = np.zeros(len(design.norms))
    for group, size in sizes.items():
        unit[design.columns[group]] = size * design.norms[design.columns[group]]
    return float(unit @ design.gram @ unit)


def compute_model_error(
    parts: Sequence[LinearTest], noise: CampaignNoise
) -> dict[TestChannel, float]:
    """Chi-square that the simulation may get wrong of each test's residual (Eq. (9)): a share of
    what the residual has beyond its number of rows, without what the recorder alone makes; 0 where
    that is less."""
    error = {}
    for channel in CHANNELS:
        for part in parts:
            white = whiten_gyro_residual(part, channel, noise)
            excess = max(float((white**2).sum()) - len(white), 0.0)
            error[part.test.test.id, channel] = MODEL_ERROR_POWER * excess
    return error
