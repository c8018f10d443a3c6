"""The parts of a diagnosis that are scored."""

from dataclasses import dataclass
from pathlib import Path

from pyhrg.gap.findings.diagnosis import Cause, read_diagnosis

NAMED = 0.5
"""Posterior probability from which a class of effects counts as named."""


@dataclass(frozen=True)
class ScoredDiagnosis:
    """The parts of a diagnosis that are scored.

    where: coordinate and share of each place of the gap.
    holdout_after_arcsec: residual of the output angle on held-out tests after closing; None
        without such tests.
    next_test: kind of the suggested test; None where nothing is confounded.
    next_hours: its duration.
    """

    verdict: str
    causes: tuple[Cause, ...] = ()
    unknown_probability: float = 0.0
    where: tuple[tuple[str, float], ...] = ()
    holdout_after_arcsec: float | None = None
    next_test: str | None = None
    next_hours: float = 1.0

    @property
    def classes(self) -> list[tuple[frozenset[str], float]]:
        """Equivalence classes of effects with their probabilities; causes that share an effect are
        merged."""
        merged: list[tuple[frozenset[str], float]] = []
        for cause in self.causes:
            effects, probability = cause.equivalence_class, cause.probability
            for other in [entry for entry in merged if entry[0] & effects]:
                merged.remove(other)
                effects, probability = effects | other[0], probability + other[1]
            merged.append((effects, min(1.0, probability)))
        return merged

    @property
    def named(self) -> list[frozenset[str]]:
        """Equivalence classes with a probability of at least `NAMED`."""
        return [effects for effects, probability in self.classes if probability >= NAMED]


def read_scored(path: Path) -> ScoredDiagnosis:
    """Read the scored parts of a `diagnosis.json`.

    Raises:
        DiagnosisError: it is missing or no diagnosis of a campaign.
    """
    diagnosis = read_diagnosis(path)
    held_out, test = diagnosis.gap.holdout_angle_arcsec, diagnosis.next_test
    return ScoredDiagnosis(
        diagnosis.verdict,
        diagnosis.causes,
        diagnosis.unknown_probability,
        tuple((place.coordinate, place.share) for place in diagnosis.where),
        held_out.after if held_out and held_out.after > 0 else None,
        test.kind if test else None,
        test.hours if test else 1.0,
    )
