"""The definition of a study: number of triads, missions, gyros; no random number is drawn here."""

import math
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

from ins_eval.trajectories.keys import Checked, quantity, whole
from pyhrg.common.errors import describe_briefly
from pyhrg.common.units import ARCSEC, MICRO_G

Settings = Mapping[str, float]
"""Values of a dataclass's fields, SI."""
TRAIN, TEST, CONDITION = "train", "test", "condition"
"""Roles of triads: predictors are made on the training triads and judged on the test triads. A
test triad in a condition is scored apart. Mission classes have no role: all are judged."""
MEAN: Final = "mean"
CALIBRATIONS = (MEAN, "map")
"""What the maker calibrates: the means of bias and scale factor, or their whole maps."""
LONGEST_HOURS = 10.0
LARGEST_TRIADS = 1_000_000
SIGNIFICANCE = 0.05
"""Two-sided significance of the exact binomial test of coverage. Chosen: the usual 5 %."""


@dataclass(frozen=True, kw_only=True)
class PlannedMission(Checked):
    """A mission with the content of its file, so that it can be flown on any machine.

    Attributes:
        name: a name that no other mission of the study has.
        mission_class: class of manoeuvre.
        hours: duration of the navigation.
        file_name: name of the file, whose suffix says its kind.
        content: content of the file.
    """

    name: str
    mission_class: str
    hours: float = quantity("", 0.1, LONGEST_HOURS)
    file_name: str
    content: bytes = field(repr=False)

    @contextmanager
    def as_file(self) -> Iterator[Path]:
        """The mission as a file that exists inside the context."""
        with tempfile.TemporaryDirectory(prefix="hrg-study-") as folder:
            path = Path(folder) / self.file_name
            path.write_bytes(self.content)
            yield path


@dataclass(frozen=True, kw_only=True)
class Study(Checked):
    """A study, as `load_study` reads it.

    Attributes:
        seed: seed of all random numbers.
        triads: number of triads that are benched.
        training: number of the first of them, which are flown by the linear model and on which
            predictors are made; the others are co-simulated and judged.
        hours: duration of the navigation, where a mission does not state its own.
        interval_percent: probability of the predicted intervals, whose coverage is judged.
        accelerometer_bias_micro_g: standard deviation of each accelerometer's bias.
        mounting_arcsec: standard deviation of the angle by which each gyro's input axis leans, in
            each of two directions.
        agreement: number of test triads, for each calibration, that are also co-simulated without
            noise, to be compared with the linear model.
        steady_agreement: the same with `HRGSlow`, whose loops are in their steady state: a third of
            the work.
        lead: number of flights of the lead case, the gyro of the paper's Table 2.
        conditions: number of test triads that also fly in each of `conditions.CONDITIONS`.
        witnessed: number of test triads, for each calibration, that also fly with the channels that
            their gyros record of themselves, with and without a self-test.
        missions: missions in the order of the results.
        left_out: recorded drives that the study names and that are not on this machine.
        calibrations: some of `CALIBRATIONS`.
        settings: settings that differ from the defaults, SI, by table of
            `study_file.SETTING_TABLES` and field.
    """

    seed: int = whole(0, 2**63 - 1)
    triads: int = whole(2, LARGEST_TRIADS)
    training: int = whole(1, LARGEST_TRIADS)
    hours: float = quantity("", 0.1, LONGEST_HOURS, 2.0)
    interval_percent: float = quantity("", 50.0, 99.0, 90.0)
    accelerometer_bias_micro_g: float = quantity("", 0.0, 1e4, 10.0)
    mounting_arcsec: float = quantity("", 0.0, 3600.0, 10.0)
    agreement: int = whole(0, LARGEST_TRIADS, 0)
    steady_agreement: int = whole(0, LARGEST_TRIADS, 0)
    lead: int = whole(0, 10_000, 0)
    conditions: int = whole(0, LARGEST_TRIADS, 0)
    witnessed: int = whole(0, LARGEST_TRIADS, 0)
    missions: tuple[PlannedMission, ...]
    left_out: tuple[str, ...] = ()
    calibrations: tuple[str, ...] = CALIBRATIONS
    settings: Mapping[str, Settings] = field(default_factory=dict)

    __repr__ = describe_briefly

    @property
    def accelerometer_bias(self) -> float:
        """Standard deviation of each accelerometer's bias, m/s^2."""
        return self.accelerometer_bias_micro_g * MICRO_G

    @property
    def mounting(self) -> float:
        """Standard deviation of the lean of each gyro's input axis in each direction, rad."""
        return self.mounting_arcsec * ARCSEC

    def role_of(self, triad: int) -> str:
        """The role of a triad, counted from 0."""
        return TRAIN if triad < self.training else TEST

    @property
    def judged(self) -> int:
        """Number of test triads."""
        return self.triads - self.training

    def is_in_sample(self, triad: int, size: int) -> bool:
        """Whether a triad is in a sample that is spread evenly over the test triads."""
        place = triad - self.training
        return place >= 0 and place * size % self.judged < size


def compute_fewest_judged(interval_percent: float) -> int:
    """Smallest number of judged triads that can show that intervals are too wide.

    With fewer, even full coverage has a probability share^n above half of `SIGNIFICANCE`.
    """
    return math.ceil(math.log(SIGNIFICANCE / 2) / math.log(interval_percent / 100))
