"""Families of schedules, one for each way to choose a motion: parked patterns, an indexed case,
patterns turned by virtual rotation."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from ins_eval.error_model.linear_model import AXES
from ins_eval.schedules.schedule import PATTERN_PERIOD, Schedule, Sweep
from pyhrg.common.units import DEG

OWN_START = (None,)
START_ANGLES = tuple((np.arange(0.0, 180.0, 0.5) * DEG).tolist())
"""Start angles that are compared, rad. Chosen: the scatter of power-on angles."""
ROTATIONS = np.geomspace(0.002, 1.0, 19) * DEG
"""Speeds of virtual rotation that are compared, rad/s. Chosen: from 2 deg of pattern in
an hour to a quarter of a turn in the alignment."""
PATTERN_SPANS = (PATTERN_PERIOD / 2, PATTERN_PERIOD)
"""Virtual rotation after which it changes its sign, rad: periods of the fourth and of the second
harmonic."""
CASE_SPEEDS = np.array([0.25, 0.5, 1.0, 2.0, 4.0]) * DEG
"""Speeds of the case that are compared, rad/s; after each turn it turns back. Chosen."""
CASE_ANGLES = np.arange(0.0, 360.0, 10.0) * DEG
"""Angles of the case at power-on that are compared, rad."""


@dataclass(frozen=True)
class Family:
    """Schedules that are compared. A candidate is a motion with a start angle.

    Attributes:
        name: name in files.
        label: name in reports.
        motions: schedules with the gyros' own start angles.
        starts: start angles, rad, of each gyro's pattern; None is the gyro's own.
        is_joint: whether one motion moves the whole triad; otherwise each gyro has its own.
    """

    name: str
    label: str
    motions: tuple[Schedule, ...]
    starts: tuple[tuple[float | None, ...], ...] = field(default=(OWN_START,) * AXES)
    is_joint: bool = False

    @property
    def counts(self) -> tuple[int, ...]:
        """Number of candidates of each gyro; of the triad where they are chosen as one."""
        every = tuple(len(self.motions) * len(starts) for starts in self.starts)
        return every[:1] if self.is_joint else every

    def compose(self, chosen: Sequence[int]) -> Schedule:
        """The schedule of the candidates chosen (`counts`); those of motions come in the order of
        their start angles."""
        places = tuple(chosen) * AXES if self.is_joint else chosen
        pairs = [divmod(at, len(starts)) for at, starts in zip(places, self.starts, strict=True)]
        motions = [self.motions[motion] for motion, _ in pairs]
        return Schedule(
            tuple(starts[at] for (_, at), starts in zip(pairs, self.starts, strict=True)),
            tuple(each.virtual_rotation[axis] for axis, each in enumerate(motions)),
            motions[0].case,
            tuple(each.takes_mean[axis] for axis, each in enumerate(motions)),
        )

    def draw(self, generator: np.random.Generator) -> Schedule:
        """One of the schedules at random."""
        return self.compose([int(generator.integers(count)) for count in self.counts])


PARKING = Family(
    "parking",
    "patterns of the level gyros parked",
    (Schedule(),),
    (START_ANGLES, START_ANGLES, OWN_START),
)
INDEXING = Family(
    "indexing",
    "case turned to and fro",
    tuple(
        Schedule(case=Sweep(rate, 2 * np.pi, start))
        for rate in (0.0, *CASE_SPEEDS, *-CASE_SPEEDS)
        for start in CASE_ANGLES
    ),
    is_joint=True,
)
VIRTUAL_ROTATION = Family(
    "virtual_rotation",
    "patterns turned by virtual rotation",
    tuple(
        Schedule(virtual_rotation=(sweep,) * AXES, takes_mean=(takes_mean,) * AXES)
        for takes_mean in (False, True)
        for sweep in (
            Sweep(),
            *(Sweep(w, span) for w in (*ROTATIONS, *-ROTATIONS) for span in PATTERN_SPANS),
        )
    ),
)
FAMILIES = (PARKING, INDEXING, VIRTUAL_ROTATION)
