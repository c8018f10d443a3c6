"""Faults of bench and record in a diagnosis: causes beyond their tolerance, listed within it."""

from collections.abc import Iterable, Sequence

import numpy as np

from pyhrg.common.units import ARCSEC
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.evidence.evidence import Fit
from pyhrg.gap.evidence.hypothesis import compute_sigma_along
from pyhrg.gap.evidence.noise.noise_hypothesis import NORMAL_95
from pyhrg.gap.findings.diagnosis import Cause, KnownValue
from pyhrg.gap.findings.verdict import BEYOND_PROBABILITY
from pyhrg.gap.soundness.fault import Fault


def list_ripples(best: Fit) -> list[Fault]:
    """Ripples of the table among the candidate terms of a set."""
    groups = zip(best.groups, best.values, best.covariances, strict=True)
    return [
        Fault(
            g.fault,
            float(np.linalg.norm(size)) / ARCSEC,
            compute_sigma_along(size, covariance) / ARCSEC,
        )
        for g, size, covariance in groups
        if isinstance(g, CandidateTerm) and g.fault
    ]


def list_fault_causes(faults: Iterable[Fault]) -> tuple[Cause, ...]:
    """Causes of the faults that exceed their tolerance, one a name."""
    groups: dict[str, list[Fault]] = {}
    for fault in filter(_is_beyond, faults):
        groups.setdefault(fault.kind.name, []).append(fault)
    return tuple(
        Cause(
            name,
            max(fault.beyond_probability for fault in group),
            {fault.kind.parameter: fault.value for fault in group},
            {fault.kind.parameter: _compute_interval(fault) for fault in group},
            family=group[0].kind.family,
        )
        for name, group in groups.items()
    )


def list_tolerated_faults(faults: Sequence[Fault]) -> tuple[KnownValue, ...]:
    """Faults that are not beyond their tolerance with a probability above `BEYOND_PROBABILITY`."""
    return tuple(
        KnownValue(
            fault.kind.name,
            fault.kind.family,
            fault.kind.parameter,
            fault.value,
            fault.kind.sound,
            _compute_interval(fault),
            fault.kind.tolerance,
            {fault.kind.parameter: fault.value},
        )
        for fault in faults
        if not _is_beyond(fault)
    )


def _is_beyond(fault: Fault) -> bool:
    return fault.beyond_probability > BEYOND_PROBABILITY


def _compute_interval(fault: Fault) -> tuple[float, float]:
    half_width = NORMAL_95 * fault.sigma
    return fault.value - half_width, fault.value + half_width
