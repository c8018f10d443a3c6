"""A diagnosis as data, and its file: the campaign format's `diagnosis.json`, written and read."""

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any, Literal

from pyhrg.common.errors import HrgError, describe_briefly
from pyhrg.common.files import write_whole
from pyhrg.common.units import NAUTICAL_MILE
from pyhrg.device.declarations import Family
from pyhrg.gap.findings.localisation import Place
from pyhrg.gap.findings.quantity import Size
from pyhrg.gap.findings.term import Term
from pyhrg.gap.findings.values import make_gap_table

SCHEMA = "hrg-diagnosis/1"
FILE = "diagnosis.json"
WORSE_RATIO = 1.1
"""Closing has made the simulation worse when the residual after it exceeds the one before by this
factor. Chosen."""
UNSETTLED = "The search did not converge: every statement of this diagnosis is uncertain."
WORSE_HELD_OUT = (
    "On the held-out tests closing takes the simulation further away: the fitted tests do not "
    "determine these causes well enough to predict others."
)
METRES_PER_DEG_H = NAUTICAL_MILE / 0.01
"""Position error after an hour over a bias, m/(deg/h): the usual rule, 0.01 deg/h is 1 nmi/h."""
Verdict = Literal["no_gap", "explained", "ambiguous", "unexplained"]


class DiagnosisError(HrgError):
    """The file is no diagnosis; the message names file, key, found and expected."""


@dataclass(frozen=True)
class Worth:
    """What a cause makes in the fitted tests, each size in the test where it is largest; or the
    bound below which that doesn't matter (docs/methods/verdict.md, Eq. 10).

    angle_arcsec: rms in the output angle.
    rate_deg_h: mean rate over a test.
    loop_share: rms in another channel over its scale: the nominal amplitude, 1/tau for forces, 1e-4
        of the nominal frequency.
    loop_channel: that channel; empty of a bound.
    """

    angle_arcsec: float
    rate_deg_h: float
    loop_share: float
    loop_channel: str = ""

    @property
    def sizes(self) -> tuple[float, float, float]:
        """All sizes, in the order of the fields."""
        return self.angle_arcsec, self.rate_deg_h, self.loop_share

    def exceeds(self, bound: "Worth") -> bool:
        """Whether any size is above the bound's."""
        return any(size > limit for size, limit in zip(self.sizes, bound.sizes, strict=True))

    def document(self) -> dict[str, Any]:
        """Sizes by name, and the position error after an hour that the rate makes by the usual
        rule, m."""
        return {**asdict(self), "position_m": self.rate_deg_h * METRES_PER_DEG_H}


@dataclass(frozen=True)
class Cause:
    """An effect that takes part, or a known parameter that is off by more than its tolerance.

    probability: posterior probability that it, or one of its equivalents, takes part; for a known
        parameter, that it is off by more than its tolerance.
    parameters: total values by the format's names, in its units.
    interval_95: 95 % interval of each parameter, in the same units.
    equivalents: effects that are confounded with it in these tests.
    family: what is wrong: the gyro, a nominal value, the bench or the record.
    worth: what it makes; None of a noise, or of a fault that was found in the rows.
    """

    effect: str
    probability: float
    parameters: Mapping[str, float] = field(default_factory=dict)
    interval_95: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    equivalents: tuple[str, ...] = ()
    family: Family = "gyro"
    worth: Worth | None = None

    @property
    def equivalence_class(self) -> frozenset[str]:
        """The effect and its equivalents."""
        return frozenset((self.effect, *self.equivalents))

    def is_within(self, bound: Worth) -> bool:
        """Whether all that it makes is within a bound."""
        return self.worth is not None and not self.worth.exceeds(bound)


@dataclass(frozen=True)
class KnownValue:
    """A parameter known within a tolerance, as the tests show it: off, but by no more than that.

    parameter: its name; of a magnitude with an angle, that of the magnitude.
    value, stated: total value, and the one that the campaign states, in the unit of the parameter's
        name.
    interval_95: of the value.
    tolerance: one standard deviation of the value about the stated one.
    parameters: total value of each of its parameters, an angle among them, by name.
    """

    name: str
    family: Family
    parameter: str
    value: float
    stated: float
    interval_95: tuple[float, float]
    tolerance: float
    parameters: Mapping[str, float]


@dataclass(frozen=True)
class GapFigure:
    """Size of a residual before and after closing.

    floor: what noise alone would leave of a perfect simulation (median of draws).
    floor_95: 95 % interval of the floor.
    """

    before: float
    after: float
    floor: float
    floor_95: tuple[float, float]


@dataclass(frozen=True)
class Gap:
    """Size of the gap on the tests that were fitted to and on the held-out ones.

    fit_angle_arcsec, holdout_angle_arcsec: residual of the output angle.
    fit_rate_deg_h, holdout_rate_deg_h: residual of the rate over 100 s; None where all tests are
        shorter.
    shrink_percent: share of the excess over the floor that closing removes, in the angle of the
        held-out tests; None without such tests or without an excess.
    whiteness: p-value that the whitened residual of the held-out tests is white.
    holdout_area_arcsec: area between the distributions of the output angle's residual in the
        held-out tests and of the noise.
    """

    fit_angle_arcsec: GapFigure
    fit_rate_deg_h: GapFigure | None
    holdout_angle_arcsec: GapFigure | None
    holdout_rate_deg_h: GapFigure | None
    shrink_percent: float | None
    whiteness: float | None
    holdout_area_arcsec: GapFigure | None = None

    @property
    def is_wider(self) -> bool:
        """Whether closing has moved the simulation away from the tests that it was fitted to."""
        return _is_wider(self.fit_angle_arcsec)

    @property
    def is_wider_held_out(self) -> bool:
        """Whether it has moved the simulation away from the held-out tests."""
        figure = self.holdout_angle_arcsec
        return figure is not None and _is_wider(figure)


def _is_wider(figure: GapFigure) -> bool:
    return figure.after > max(WORSE_RATIO * figure.before, figure.floor_95[1])


@dataclass(frozen=True)
class NextTest:
    """The test that would best separate what is still confounded.

    hours: duration of this test that is enough.
    """

    kind: str
    why: str
    hours: float


@dataclass(frozen=True)
class Diagnosis:
    """All that a diagnosis says.

    causes: the immaterial ones last.
    unknown_probability: posterior probability that something outside the catalogue takes part.
    where: shares of the residual's excess power, the largest first.
    sizes: the gap in sigma, by test, channel and time scale.
    unnamed: what takes part outside the catalogue, in words, with posterior probabilities.
    excluded: what of the campaign was missing or left out, a sentence each.
    settled: whether the search converged; everything is uncertain where it did not.
    within_tolerance: known parameters that are off, but by no more than their tolerance.
    left, bound: what is left unexplained is worth, and the bound below which it does not matter.
    terms: proposed equations for what has no name.
    """

    device: str
    verdict: Verdict
    causes: tuple[Cause, ...]
    unknown_probability: float
    where: tuple[Place, ...]
    sizes: tuple[Size, ...]
    gap: Gap
    next_test: NextTest | None
    unnamed: Mapping[str, float]
    excluded: tuple[str, ...]
    settled: bool = True
    within_tolerance: tuple[KnownValue, ...] = ()
    left: Worth = Worth(0.0, 0.0, 0.0)
    bound: Worth = Worth(0.0, 0.0, 0.0)
    terms: tuple[Term, ...] = ()

    __repr__ = describe_briefly

    def is_immaterial(self, cause: Cause) -> bool:
        """Whether all that a cause makes is within the bound."""
        return cause.is_within(self.bound)

    @property
    def caveats(self) -> list[str]:
        """Sentences on what makes the whole diagnosis uncertain."""
        return [
            *([] if self.settled else [UNSETTLED]),
            *([WORSE_HELD_OUT] if self.gap.is_wider_held_out else []),
        ]

    def document(self) -> dict[str, Any]:
        """The content of `diagnosis.json`."""
        values = asdict(self)
        for place in values["where"]:
            if place["harmonic"] is None:
                del place["harmonic"]
        for cause, own in zip(values["causes"], self.causes, strict=True):
            del cause["worth"]
            cause |= {"worth": own.worth.document()} if own.worth else {}
        gap = values.pop("gap")
        del values["left"], values["bound"]
        material = {
            "is_material": self.left.exceeds(self.bound),
            "bound": self.bound.document(),
            "left": self.left.document(),
        }
        return {"schema": SCHEMA, **values, "material": material, "gap": make_gap_table(gap)}


def write(diagnosis: Diagnosis, folder: Path) -> None:
    """Write `diagnosis.json`, whole or not at all."""
    text = json.dumps(diagnosis.document(), indent=1, allow_nan=False) + "\n"
    write_whole(folder / FILE, text.encode())
