"""What a diagnosis says: the campaign format's `diagnosis.json`."""

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Literal

from pyhrg.common.errors import HrgError
from pyhrg.common.files import write_whole
from pyhrg.gap.findings.quantity import Size

SCHEMA = "hrg-diagnosis/1"
FILE = "diagnosis.json"
WIDENED = 1.1
"""Residual after closing over that before from which closing has made it worse."""
UNSETTLED = "The search did not come to rest: all of this is uncertain."
WIDER = (
    "Closing takes the simulation further away from the records: what is named stands in for "
    "something that has no name."
)
Verdict = Literal["no_gap", "explained", "ambiguous", "unexplained"]


class DiagnosisError(HrgError):
    """The file is no diagnosis; the message names file, key, found and expected."""


@dataclass(frozen=True)
class Cause:
    """An effect that takes part.

    probability: that it, or one of its equivalents, takes part.
    parameters: totals by the format's names, in its units; `interval_95` alike.
    equivalents: effects that these data can't tell from it.
    """

    effect: str
    probability: float
    parameters: Mapping[str, float]
    interval_95: Mapping[str, tuple[float, float]]
    equivalents: tuple[str, ...] = ()


@dataclass(frozen=True)
class Where:
    """A share of the residual's excess power."""

    test: str
    channel: str
    coordinate: str
    share: float
    sigmas: float
    harmonic: int | None = None


@dataclass(frozen=True)
class GapFigure:
    """Root mean square of a residual: before, after, and what noise alone leaves."""

    before: float
    after: float
    floor: float
    floor_95: tuple[float, float]


@dataclass(frozen=True)
class Gap:
    """On tests that were fitted to and on those held out.

    fit_angle_arcsec, holdout_angle_arcsec: of the output angle.
    fit_rate_deg_h, holdout_rate_deg_h: of the rate over 100 s; None where all tests are shorter.
    shrink_percent: of the excess over the floor, in the angle, on the held-out tests.
    whiteness: p-value that what is left on the held-out tests is white.
    """

    fit_angle_arcsec: GapFigure
    fit_rate_deg_h: GapFigure | None
    holdout_angle_arcsec: GapFigure | None
    holdout_rate_deg_h: GapFigure | None
    shrink_percent: float | None
    whiteness: float | None

    @property
    def is_wider(self) -> bool:
        """Whether closing has taken the simulation away from tests that it was fitted to."""
        fit = self.fit_angle_arcsec
        return fit.after > max(WIDENED * fit.before, fit.floor_95[1])


@dataclass(frozen=True)
class NextTest:
    """The test that would best separate what is still confounded.

    hours: of it that would do.
    """

    kind: str
    why: str
    hours: float


@dataclass(frozen=True)
class Diagnosis:
    """All of it.

    sizes: of the gap in deviations of the noise, by test, channel and time scale.
    unnamed: what takes part outside the catalogue, in words, with probabilities.
    excluded: what of the campaign was missing or left out, a sentence each.
    settled: whether the search came to rest; what it says is uncertain where it did not.
    """

    device: str
    verdict: Verdict
    causes: tuple[Cause, ...]
    unknown_probability: float
    where: tuple[Where, ...]
    sizes: tuple[Size, ...]
    gap: Gap
    next_test: NextTest | None
    unnamed: Mapping[str, float]
    excluded: tuple[str, ...]
    settled: bool = True

    @property
    def caveats(self) -> list[str]:
        """What makes all of it uncertain, a sentence each."""
        return [
            *([] if self.settled else [UNSETTLED]),
            *([WIDER] if self.gap.is_wider else []),
        ]

    def document(self) -> dict[str, Any]:
        """As `diagnosis.json` has it."""
        values = asdict(self)
        for place in values["where"]:
            if place["harmonic"] is None:
                del place["harmonic"]
        gap = values.pop("gap")
        return {"schema": SCHEMA, **values, "gap": _gap(gap)}


def _gap(gap: dict[str, Any]) -> dict[str, Any]:
    """`before`, `after`, `floor` on `fit` and `holdout` apart."""
    document: dict[str, Any] = {}
    for stage in ("before", "after", "floor", "floor_95"):
        document[stage] = {
            role: {
                unit: gap[f"{role}_{unit}"][stage]
                for unit in ("angle_arcsec", "rate_deg_h")
                if gap[f"{role}_{unit}"] is not None
            }
            for role in ("fit", "holdout")
        }
    return {**document, "shrink_percent": gap["shrink_percent"], "whiteness": gap["whiteness"]}


def write(diagnosis: Diagnosis, folder: Path) -> None:
    """Write `diagnosis.json`, whole or not at all.

    Raises:
        OSError: the folder can't be written.
    """
    text = json.dumps(diagnosis.document(), indent=1, allow_nan=False) + "\n"
    write_whole(folder / FILE, text.encode())


def causes_of(path: Path, device: str) -> dict[str, dict[str, float]]:
    """Parameters by effect, as a file's causes have them.

    Args:
        path: of a diagnosis.
        device: the gyro that it must be of, if it says so.

    Raises:
        DiagnosisError: an unreadable file, one that is no diagnosis, or another gyro's.
    """
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, json.JSONDecodeError) as error:
        raise DiagnosisError(f"{path}: can't be read: {error}") from error
    if not isinstance(document, dict) or document.get("schema") != SCHEMA:
        found = document.get("schema") if isinstance(document, dict) else document
        raise DiagnosisError(f"{path}: schema: found {found!r}, expected {SCHEMA!r}")
    if "record" in document:
        raise DiagnosisError(f"{path}: is of a static record; expected that of a campaign")
    if document.get("device", device) != device:
        raise DiagnosisError(f"{path}: device: found {document['device']!r}, expected {device!r}")
    try:
        return {
            str(cause["effect"]): {str(k): float(v) for k, v in cause["parameters"].items()}
            for cause in document["causes"]
        }
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise DiagnosisError(
            f"{path}: causes: {error!r}; expected effect and parameters"
        ) from error
