"""What candidate terms may miss because a cause without a name has another form than they have.

The share of their power that they miss must be read neither as other terms nor as noise. It counts
as noise where the terms act, and is never more than what they leave of the residual
(docs/methods/evidence.md, Eq. 10a).
"""

from collections.abc import Mapping, Sequence

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.design import (
    Group,
    LinearTest,
    TestChannel,
    measure_excess,
    measure_power,
    whiten_rows,
)
from pyhrg.gap.effects.term_columns import compute_response
from pyhrg.gap.evidence.hypothesis import Hypothesis, TermError, rank_under_noise
from pyhrg.gap.replay.observations import CHANNELS

FORM_ERROR = 1e-2
"""Share of a candidate term's power that may remain in the residual because the cause has another
form. Chosen: a tenth of its amplitude."""
NEGLIGIBLE_CHI2 = 1.0
"""Error, as chi-square, that counts as zero: the power of a row's noise. Chosen."""


def rank_with_form_error(
    first: Hypothesis, nominal: Device, parts: Sequence[LinearTest]
) -> tuple[Hypothesis, TermError]:
    """Rank sets again beside what the terms of the most probable set may miss, and that error.

    The first time it is a share of the terms' power. Then it is that of the terms that are left,
    and no more than what the set with them leaves of the residual: an effect has its own form.
    """
    error = _allow_form_error(first, parts)
    if not error:
        return first, error
    rough = rank_under_noise(
        first.noise, nominal, parts, term_error=error, start=first.ranking.best.groups
    )
    left = measure_excess(rough.exact.whole, rough.sizes)
    allowed = _allow_form_error(rough, parts)
    error = _drop_negligible({where: min(e, left[where]) for where, e in allowed.items()})
    start = rough.ranking.best.groups
    return rank_under_noise(first.noise, nominal, parts, term_error=error, start=start), error


def _allow_form_error(hypothesis: Hypothesis, parts: Sequence[LinearTest]) -> TermError:
    """Chi-square that the terms of the most probable set may miss where they act. Where they read
    the angle wrongly, other channels are compared at a wrong angle."""
    all_sizes = hypothesis.ranking.best.sizes.items()
    terms = [(g, size) for g, size in all_sizes if isinstance(g, CandidateTerm)]
    if not terms:
        return {}
    powers = measure_power(hypothesis.exact.whole, dict[Group, Array](terms))
    readings = {g: size for g, size in terms if g.is_reading_error}
    for part in parts if readings else ():
        angle = compute_response(part.where, "gyro_angle", readings)[:, None]
        for channel in CHANNELS[1:]:
            moved = part.at_measured_angle(np.zeros_like(angle), angle, channel)
            white = whiten_rows(part, channel, moved, hypothesis.channel_noise).series
            powers[part.test.test.id, channel] += float((white**2).sum())
    return _drop_negligible({where: FORM_ERROR * power for where, power in powers.items()})


def _drop_negligible(error: Mapping[TestChannel, float]) -> TermError:
    return {where: chi2 for where, chi2 in error.items() if chi2 > NEGLIGIBLE_CHI2}
