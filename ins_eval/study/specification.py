"""What a study is: how many triads, in which missions, of which gyros; nothing random is drawn."""

import math
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

from ins_eval.study.sections import Settings
from ins_eval.trajectories.keys import Checked, quantity, required_choice, whole

TRAIN, TEST, CONDITION = "train", "test", "condition"
"""Halves of triads and classes; conditions stand apart from both."""
MEAN: Final = "mean"
CALIBRATIONS = (MEAN, "map")
"""By the maker: bias and scale factor at the mean; or the whole maps of both."""
LONGEST_HOURS = 10.0
MOST_TRIADS = 1_000_000
SIGNIFICANCE = 0.05
"""Two-sided, of the exact binomial test that coverage is held to."""


@dataclass(frozen=True, kw_only=True)
class PlannedMission(Checked):
    """A mission with all that is in its file, so that it can be flown on any machine.

    Attributes:
        name: unlike any other of the study.
        mission_class: of manoeuvre; all missions of a class are in the same half.
        half: "train", on which predictors are made, or "test", on which they are judged.
        hours: of navigation.
        file_name: as `ins_eval.trajectories.catalogue.trajectory` tells kinds of files by.
        content: of the file.
    """

    name: str
    mission_class: str
    half: str = required_choice(TRAIN, TEST)
    hours: float = quantity("", 0.1, LONGEST_HOURS)
    file_name: str
    content: bytes = field(repr=False)

    @contextmanager
    def placed(self) -> Iterator[Path]:
        """The mission as a file, while the block lasts."""
        with tempfile.TemporaryDirectory(prefix="hrg-study-") as folder:
            path = Path(folder) / self.file_name
            path.write_bytes(self.content)
            yield path


@dataclass(frozen=True, kw_only=True)
class Study(Checked):
    """The experiment.

    Attributes:
        seed: of everything random.
        triads: how many; the first half of them is what predictors are made on.
        hours: of navigation, where a mission doesn't say its own.
        interval_percent: of predicted errors, whose coverage is judged.
        accelerometer_bias_micro_g: 1 sigma of each.
        cosimulated: triads of the sample that is flown without linearising, of each calibration.
        conditions: triads of the half that is judged that are also flown in each of
            `conditions.CONDITIONS`.
        missions: in the order of the results.
        left_out: recorded drives that the study names and this machine doesn't have.
        calibrations: some of `CALIBRATIONS`.
        settings: of `sections.SECTIONS`, by field, SI; only what differs from the defaults.
    """

    seed: int = whole(0, 2**63 - 1)
    triads: int = whole(2, MOST_TRIADS)
    hours: float = quantity("", 0.1, LONGEST_HOURS, 2.0)
    interval_percent: float = quantity("", 50.0, 99.0, 90.0)
    accelerometer_bias_micro_g: float = quantity("", 0.0, 1e4, 10.0)
    cosimulated: int = whole(0, MOST_TRIADS, 0)
    conditions: int = whole(0, MOST_TRIADS, 0)
    missions: tuple[PlannedMission, ...]
    left_out: tuple[str, ...] = ()
    calibrations: tuple[str, ...] = CALIBRATIONS
    settings: Mapping[str, Settings] = field(default_factory=dict)

    def half_of(self, triad: int) -> str:
        """Of a triad, counted from 0."""
        return TRAIN if triad < self.triads // 2 else TEST

    def is_cosimulated(self, triad: int) -> bool:
        """Whether a triad is of the sample, which is spread over all."""
        return triad * self.cosimulated % self.triads < self.cosimulated

    def is_in_conditions(self, triad: int) -> bool:
        """Whether a triad is of the sample of the judged half that is flown in conditions."""
        first = self.triads // 2
        judged = self.triads - first
        place = triad - first
        return place >= 0 and place * self.conditions % judged < self.conditions


def fewest_judged(interval_percent: float) -> int:
    """With fewer, no count whatever of covered errors refutes intervals that are too wide:
    share^n stays above half the significance."""
    return math.ceil(math.log(SIGNIFICANCE / 2) / math.log(interval_percent / 100))


def fewest_triads(interval_percent: float) -> int:
    """Of a study, half of which is judged."""
    return 2 * fewest_judged(interval_percent)
