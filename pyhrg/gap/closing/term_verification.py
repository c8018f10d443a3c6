"""Proposed terms verified: the FMU of the identified gyro with them, run on the tests."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from scipy.stats import chi2

from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.gap.closing.closing import Closing, Residuals, compute_record_residuals
from pyhrg.gap.closing.equation.closed_fmu import load_closed_fmu, put_terms
from pyhrg.gap.closing.equation.proposal import propose_terms
from pyhrg.gap.closing.equation.refinement import find_moved_tests, list_sizes
from pyhrg.gap.closing.verification import draw_angles, estimate_noise_floor, measure_distance
from pyhrg.gap.evidence.attribution import Attribution
from pyhrg.gap.findings.term import Term
from pyhrg.gap.replay.observations import ObservedTest
from pyhrg.gap.replay.sampled import replay_sampled_together
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.gap.whitening.campaign_noise import CampaignNoise, whiten_finite

UPPER_QUANTILE = 0.975
"""Quantile of the noise floor above which a residual has an excess: that of a 95 % interval."""


def verify_terms(
    simulation: Simulation,
    attribution: Attribution,
    tests: Sequence[ObservedTest],
    closing: Closing,
) -> Closing:
    """Closing by causes alone, made one by causes and proposed terms, each with what it removes of
    the excess on held-out tests that the causes leave (docs/methods/equation.md, Eq. 6).

    The residuals after closing are those of the FMU that is written as `closed.fmu`. The tests that
    were fitted to come first, in the search's order; those in which the terms change next to
    nothing keep their residuals.
    """
    terms = propose_terms(attribution.posterior)
    noise = attribution.channel_noise
    if not terms:
        return closing
    sizes = list_sizes(attribution.posterior)
    device, fmu = closing.device, load_closed_fmu(closing.device, terms)
    after, fitted = list(closing.after), len(attribution.parts)
    for i in find_moved_tests(attribution.parts, sizes, noise):
        (after[i],) = _run(simulation, device, tests[i], fmu, [terms])
    alone = [[term] for term in terms] if len(terms) > 1 else []
    after_each = []
    for i, test in enumerate(tests[fitted:], fitted):
        after[i], *each = _run(simulation, device, test, fmu, [terms, *alone])
        after_each.append(each or [after[i]])
    held_out, before = tests[fitted:], closing.after[fitted:]
    verified = [
        replace(
            term,
            shrink_percent=_compute_shrink(
                held_out, before, [each[k] for each in after_each], noise, term.channel
            ),
        )
        for k, term in enumerate(terms)
    ]
    return replace(closing, after=tuple(after), terms=tuple(verified))


def _run(
    simulation: Simulation,
    device: Device,
    test: ObservedTest,
    fmu: GyroFmu,
    sets: Sequence[Sequence[Term]],
) -> list[Residuals]:
    """Residuals of the FMU in a test, with each of these sets of its terms."""
    devices = [put_terms(device, terms, test.test.id) for terms in sets]
    answers = replay_sampled_together(fmu, devices, test.inputs)
    return [compute_record_residuals(simulation, device, test, answer) for answer in answers]


def _compute_shrink(
    tests: Sequence[ObservedTest],
    before: Sequence[Residuals],
    after: Sequence[Residuals],
    noise: CampaignNoise,
    channel: str,
) -> float | None:
    """Share of the excess over the noise floor that is removed in a channel, per cent; None where
    the residual before has no excess."""
    if not tests:
        return None
    if channel == "gyro_angle":
        own = [[r[channel] for r in stage] for stage in (before, after)]
        first, last = (float(measure_distance(tests, series)[0]) for series in own)
        floor, upper = estimate_noise_floor(tests, draw_angles(tests, noise.angle))[1:, 0].tolist()
    else:
        first, last = (_measure_whitened(tests, s, noise, channel) for s in (before, after))
        n = sum(int(np.isfinite(r[channel]).sum()) for r in before)
        floor, upper = 1.0, float(np.sqrt(chi2.ppf(UPPER_QUANTILE, max(n, 1)) / max(n, 1)))
    return 100 * (first - last) / (first - floor) if first > upper else None


def _measure_whitened(
    tests: Sequence[ObservedTest], residuals: Sequence[Residuals], noise: CampaignNoise, name: str
) -> float:
    """Root mean square of a channel's whitened residual in tests, in sigma."""
    white = []
    for test, residual in zip(tests, residuals, strict=True):
        if np.isfinite(residual[name]).any():
            own, series = noise.get_own_model(name, test), residual[name][:, None]
            white.append(whiten_finite(own, name, test, series)[:, 0])
    return float(np.sqrt(np.mean(np.concatenate(white) ** 2))) if white else 0.0
