"""One test, checked against the campaign format and the gyro's nominal values."""

from dataclasses import dataclass, replace

import numpy as np

from pyhrg.device.device import Device
from pyhrg.gap.soundness.angles import check_angles, estimate_bryan_factor, find_column_orders
from pyhrg.gap.soundness.attitude import check_attitude, check_temperature, estimate_frequency
from pyhrg.gap.soundness.exclusion import (
    Exclusion,
    NominalEstimate,
    apply_exclusions,
    has_values,
)
from pyhrg.gap.soundness.glitches import check_glitches, mend_inputs
from pyhrg.gap.soundness.inputs import complete_inputs
from pyhrg.gap.soundness.resonator import (
    check_amplitude,
    check_swapped_forces,
    estimate_decay_time,
)
from pyhrg.records import LogError
from pyhrg.records.campaign import Test


@dataclass(frozen=True)
class ScreenedTest:
    """A test with complete inputs, and what was found in its log.

    orders: orders of the three angle columns that fit, see `find_column_orders`.
    angles: exclusions of whole angle columns, which no gyro explains.
    estimates: of nominal values.
    notes: what was left out of the log or assumed.
    """

    test: Test
    orders: frozenset[str]
    angles: tuple[Exclusion, ...]
    estimates: tuple[NominalEstimate, ...]
    notes: tuple[str, ...]

    @property
    def usable(self) -> Test:
        """The test without the columns that contradict nominal values."""
        fields = tuple(estimate.field for estimate in self.estimates if estimate.contradicts)
        log = apply_exclusions(self.test.log, [Exclusion(fields, "")])
        return replace(self.test, recording=log)

    @property
    def sentences(self) -> list[str]:
        """A sentence for everything that was left out or assumed."""
        contradictions = [e.sentence for e in self.estimates if e.contradicts]
        unused = (
            [] if self.is_usable else [f"{self.test.id}: not used: no angle of the gyro is left"]
        )
        return [*self.notes, *contradictions, *unused]

    @property
    def is_usable(self) -> bool:
        """Whether an angle of the gyro is left."""
        log = self.usable.log
        return has_values(log, "gyro_angle") or has_values(log, "wave_angle")


def screen_test(test: Test, nominal: Device) -> ScreenedTest | str:
    """The test without what contradicts itself, or a sentence why it can't be used."""
    try:
        log = test.log
        if len(log.time) < 2 or not np.all(np.diff(log.time) > 0):
            raise LogError(
                f"{log.source}: time_s: expected two rows at least, and time to increase"
            )
    except LogError as error:
        return f"{test.id}: not used: {error}"
    notes = [f"{log.source}: {note}" for note in log.exclusions]
    log, mended = mend_inputs(log)
    wrong_inputs = check_attitude(log, test.kind, nominal) + check_temperature(log, nominal)
    notes += [*mended, *(exclusion.sentence for exclusion in wrong_inputs)]
    try:
        log, filled = complete_inputs(apply_exclusions(log, wrong_inputs), nominal)
    except LogError as error:
        return "; ".join([f"{test.id}: not used: {error}", *notes])
    angles = check_angles(log, nominal)
    others = check_amplitude(log) + check_swapped_forces(log, nominal)
    remaining = apply_exclusions(log, [*angles, *others])
    glitches = check_glitches(remaining, nominal)
    remaining = apply_exclusions(remaining, glitches)
    return ScreenedTest(
        replace(test, recording=remaining),
        frozenset(find_column_orders(log, nominal)),
        tuple(exclusion for exclusion in angles if exclusion.rows is None),
        (
            *estimate_bryan_factor(log, nominal),
            *estimate_decay_time(remaining, nominal),
            *estimate_frequency(remaining, nominal),
        ),
        (*notes, *filled, *(exclusion.sentence for exclusion in (*angles, *others, *glitches))),
    )
