"""One test, held to what a campaign's format and the gyro's nominal values fix."""

from dataclasses import dataclass, replace

import numpy as np

from pyhrg.gap.soundness.angles import arrangements, doubts_of_angles, witnesses_of_bryan_factor
from pyhrg.gap.soundness.attitude import (
    doubts_of_attitude,
    doubts_of_temperature,
    witnesses_of_frequency,
)
from pyhrg.gap.soundness.doubt import Believed, Doubt, Witness, has, without
from pyhrg.gap.soundness.glitches import doubts_of_glitches, with_inputs_mended
from pyhrg.gap.soundness.inputs import InputError, whole
from pyhrg.gap.soundness.resonator import (
    doubts_of_amplitude,
    doubts_of_swapped_forces,
    witnesses_of_decay_time,
)
from pyhrg.records import Log, LogError
from pyhrg.records.campaign import Test


@dataclass(frozen=True)
class Examined:
    """A test whose inputs are whole, and what its log says.

    arrangements: orders of the three angles that fit; see `angles.arrangements`.
    angles: doubts of whole columns of angles, that no gyro explains.
    notes: what was left out of the log or taken for granted.
    """

    test: Test
    arrangements: frozenset[str]
    angles: tuple[Doubt, ...]
    witnesses: tuple[Witness, ...]
    notes: tuple[str, ...]

    @property
    def usable(self) -> Test:
        """The test without what contradicts nominal values."""
        fields = tuple(witness.field for witness in self.witnesses if witness.contradicts)
        return replace(self.test, recording=without(self.test.log, [Doubt(fields, "")]))

    @property
    def sentences(self) -> list[str]:
        """All that was left out."""
        left = [witness.sentence for witness in self.witnesses if witness.contradicts]
        names = () if _has_angle(self.usable.log) else (_unused(self.test),)
        return [*self.notes, *left, *names]

    @property
    def is_usable(self) -> bool:
        """Whether an angle of the gyro is left."""
        return _has_angle(self.usable.log)


def examined(test: Test, believed: Believed) -> Examined | str:
    """The test without what contradicts itself, or why it can't be used."""
    try:
        log = test.log
        _check_time(log)
    except LogError as error:
        return f"{test.id}: not used: {error}"
    notes = [f"{log.source}: {note}" for note in log.exclusions]
    log, mended = with_inputs_mended(log)
    doubts = doubts_of_attitude(log, test.kind, believed) + doubts_of_temperature(log, believed)
    notes += [*mended, *(doubt.sentence for doubt in doubts)]
    try:
        log, filled = whole(without(log, doubts), believed)
    except InputError as error:
        return "; ".join([f"{test.id}: not used: {error}", *notes])
    angles = doubts_of_angles(log, believed)
    others = doubts_of_amplitude(log) + doubts_of_swapped_forces(log, believed)
    left = without(log, [*angles, *others])
    strays = doubts_of_glitches(left, believed)
    left = without(left, strays)
    return Examined(
        replace(test, recording=left),
        frozenset(arrangements(log, believed)),
        tuple(doubt for doubt in angles if doubt.rows is None),
        (
            *witnesses_of_bryan_factor(log, believed),
            *witnesses_of_decay_time(left, believed),
            *witnesses_of_frequency(left, believed),
        ),
        (*notes, *filled, *(doubt.sentence for doubt in (*angles, *others, *strays))),
    )


def _check_time(log: Log) -> None:
    if len(log.time) < 2 or not np.all(np.diff(log.time) > 0):
        raise LogError(f"{log.source}: time_s: expected two rows at least, and time to increase")


def _has_angle(log: Log) -> bool:
    return has(log, "gyro_angle") or has(log, "wave_angle")


def _unused(test: Test) -> str:
    return f"{test.id}: not used: no angle of the gyro is left"
