"""Screening: what contradicts the format, the nominal values or itself is left out."""

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from pyhrg.common.errors import HrgError
from pyhrg.device.device import Device
from pyhrg.device.device_file import from_table
from pyhrg.device.keys import KEYS
from pyhrg.gap.soundness.angles import check_angles, estimate_bryan_factor, find_column_orders
from pyhrg.gap.soundness.attitude import (
    check_attitude,
    check_temperature,
    estimate_frequency,
    require_steady_temperature,
)
from pyhrg.gap.soundness.exclusion import (
    Exclusion,
    NominalEstimate,
    apply_exclusions,
)
from pyhrg.gap.soundness.fault import Fault, LogFaults, sum_log_faults
from pyhrg.gap.soundness.glitches import check_glitches, mend_inputs
from pyhrg.gap.soundness.inputs import CONTINUOUS_INPUTS, complete_inputs
from pyhrg.gap.soundness.interruption import mend_drive
from pyhrg.gap.soundness.mounting import find_mounting_faults, mend_mounting
from pyhrg.gap.soundness.origin import mend_origin
from pyhrg.gap.soundness.resonator import (
    check_amplitude,
    check_swapped_forces,
    estimate_decay_time,
    mend_nominal_amplitude,
)
from pyhrg.records import Log, LogError
from pyhrg.records.campaign import INDEX, Campaign, CampaignError, Test
from pyhrg.records.table import fold_absent_columns

KEY_NAMES = frozenset(key.name for key in KEYS)
"""Names of all values that a device may have."""
REQUIRED_KEYS = ("coriolis_factor", "decay_time_s", "frequency_Hz")
"""Nominal values without which no campaign is diagnosed."""
MAX_CONTRADICTING_SHARE = 0.5
"""Share of contradicting logs above which the campaign is refused, since the nominal values or all
logs must then be wrong. Chosen."""


class Screening(NamedTuple):
    """What screening makes of a campaign.

    campaign: that can be diagnosed; sentences: one for everything left out or assumed; faults: of
    bench and record, found and mended.
    """

    campaign: Campaign
    sentences: tuple[str, ...]
    faults: tuple[Fault, ...]


@dataclass(frozen=True)
class ScreenedTest:
    """A test with complete inputs, and what was found in its log.

    orders: orders of the three angle columns that fit, see `find_column_orders`.
    angles: exclusions of whole angle columns, which no gyro explains.
    estimates: of nominal values.
    notes: what was left out of the log or assumed.
    faults: what was counted in the log.
    """

    test: Test
    orders: frozenset[str]
    angles: tuple[Exclusion, ...]
    estimates: tuple[NominalEstimate, ...]
    notes: tuple[str, ...]
    faults: LogFaults

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
        return log.has_values("gyro_angle") or log.has_values("wave_angle")


def screen_campaign(campaign: Campaign) -> Screening:
    """The campaign that can be diagnosed, with faults of bench and record mended.

    Every test has inputs that can be replayed row by row. Outputs are NaN where they are missing or
    contradict what the campaign format fixes. Limits are wide: no real error of a gyro exceeds
    them, only mixed-up columns, units, signs or files do. A `CampaignError` where a nominal value
    is missing, most logs contradict the nominal values or themselves, or no test can be fitted.
    """
    missing = [key for key in REQUIRED_KEYS if key not in campaign.nominal]
    if missing:
        raise CampaignError(f"{INDEX}: nominal.{missing[0]}: missing; expected a number")
    unknown = [name for name in campaign.nominal if name not in KEY_NAMES]
    notes = [f"{INDEX}: nominal.{name}: not known, ignored" for name in unknown]
    nominal = build_nominal_device(campaign)
    logs = [_read_log(test) for test in campaign.tests]
    pairs = list(zip(campaign.tests, logs, strict=True))
    to_fit = [log for test, log in pairs if isinstance(log, Log) and not test.is_holdout]
    mounting = find_mounting_faults(to_fit, nominal)
    turned = [fault.kind.parameter for fault in mounting]
    results = [
        log if isinstance(log, str) else _screen_test(test, log, nominal, turned)
        for test, log in pairs
    ]
    screened = [result for result in results if isinstance(result, ScreenedTest)]
    _check_column_order(screened)
    _check_gyro([estimate for each in screened for estimate in each.estimates])
    wrong = [each for each in screened if each.angles and not each.is_usable]
    if len(wrong) > MAX_CONTRADICTING_SHARE * len(screened):
        sentence = wrong[0].angles[0].sentence
        raise CampaignError(f"{len(wrong)} of {len(screened)} logs, as {sentence}")
    for result in results:
        notes += result.sentences if isinstance(result, ScreenedTest) else [result]
    tests, duplicates = _drop_known_holdouts([each.usable for each in screened if each.is_usable])
    notes += duplicates
    if all(test.is_holdout for test in tests):
        reasons = "; ".join(notes) or "all are held out"
        raise CampaignError(f"no test that may be fitted can be used: {reasons}")
    if not any(test.is_holdout for test in tests):
        notes.append("no test is held out: a diagnosis can't be verified")
    faults = (*mounting, *sum_log_faults([each.faults for each in screened]))
    usable = replace(campaign, tests=tuple(tests))
    usable, amplitude = mend_nominal_amplitude(usable, nominal.amplitude)
    return Screening(usable, (*notes, *amplitude), faults)


def build_nominal_device(campaign: Campaign) -> Device:
    """The device that a campaign's nominal values state, without values that are no device key;
    an `HrgError` where they are no device's."""
    nominal = {name: value for name, value in campaign.nominal.items() if name in KEY_NAMES}
    return replace(from_table(nominal, f"{INDEX}: nominal"), site=campaign.site)


def _check_column_order(screened: Sequence[ScreenedTest]) -> None:
    """Refuse a campaign whose logs all fit another order of the angle columns, but not all the
    stated one.

    Logs that fit no order have another error; the campaign is refused only if they are few.
    """
    fitting = [each for each in screened if each.orders]
    misnamed = [each for each in fitting if "" not in each.orders]
    without_order = [each for each in screened if each.angles and not each.orders]
    if len(misnamed) <= len(without_order):
        return
    common = frozenset.intersection(*(each.orders for each in fitting))
    if common:
        names = min(sorted(common), key=len)
        raise CampaignError(
            f"{misnamed[0].test.log.source} and others: columns {names}: all logs fit with "
            "these names exchanged, these not as they are: are they swapped?"
        )


def _check_gyro(estimates: Sequence[NominalEstimate]) -> None:
    """Refuse a nominal value that a field contradicts in most logs, unless estimates from another
    field contradict that field's estimate."""
    by_field: dict[tuple[str, str], list[NominalEstimate]] = defaultdict(list)
    for estimate in estimates:
        by_field[estimate.key, estimate.field].append(estimate)
    for (key, field), own in by_field.items():
        if np.mean([estimate.contradicts for estimate in own]) <= MAX_CONTRADICTING_SHARE:
            continue
        value = float(np.median([estimate.value for estimate in own]))
        others = [e for (k, f), es in by_field.items() if k == key and f != field for e in es]
        if not others or np.mean([e.fits(value) for e in others]) > MAX_CONTRADICTING_SHARE:
            contradicting = [estimate for estimate in own if estimate.contradicts]
            raise CampaignError(
                f"{INDEX}: nominal.{key}: contradicted by "
                f"{len({estimate.source for estimate in contradicting})} logs, as "
                f"{contradicting[0].sentence}: are they another gyro's, or is the column in "
                "another unit or sign?"
            )


def _drop_known_holdouts(tests: Sequence[Test]) -> tuple[list[Test], list[str]]:
    """Tests without those held out whose log is also given to be fitted; a sentence for each."""
    fitted = {_read_angles(test): test.id for test in tests if not test.is_holdout}
    duplicates = {
        test.id: fitted[_read_angles(test)]
        for test in tests
        if test.is_holdout and _read_angles(test) in fitted
    }
    notes = [f"{name}: not used: the same log as {other}" for name, other in duplicates.items()]
    return [test for test in tests if test.id not in duplicates], notes


def _read_angles(test: Test) -> bytes:
    return test.log.gyro_angle.tobytes() + test.log.wave_angle.tobytes()


def _read_log(test: Test) -> Log | str:
    """The log of a test, or a sentence why it can't be used."""
    try:
        log = test.log
        if len(log.time) < 2 or not np.all(np.diff(log.time) > 0):
            raise LogError(
                f"{log.source}: time_s: expected two rows at least, and time to increase"
            )
    except HrgError as error:
        return f"{test.id}: not used: {error}"
    return log


def _screen_test(
    test: Test, log: Log, nominal: Device, turned: Sequence[str]
) -> ScreenedTest | str:
    """The test without what contradicts itself, or a sentence why it can't be used; `turned` are
    the signs of the mounting that are reversed."""
    notes = _list_notes(log)
    log, signs = mend_mounting(log, turned)
    read = log
    log, mended = mend_inputs(read)
    wrong_inputs = check_attitude(log, test.kind, nominal) + check_temperature(log, nominal)
    changes = [*signs, *mended, *(exclusion.sentence for exclusion in wrong_inputs)]
    wrong_rows = _count_changed_rows(read, log, CONTINUOUS_INPUTS)
    try:
        require_steady_temperature(log, nominal)
        complete, missing, filled = complete_inputs(apply_exclusions(log, wrong_inputs), nominal)
        log, moved = mend_origin(complete, nominal)
        log, interrupted = mend_drive(log, nominal)
    except HrgError as error:
        return "; ".join([f"{test.id}: not used: {error}", *notes, *changes])
    angles = check_angles(log, nominal)
    others = check_amplitude(log) + check_swapped_forces(log, nominal)
    remaining = apply_exclusions(log, [*angles, *others])
    glitches = check_glitches(remaining, nominal)
    remaining = apply_exclusions(remaining, glitches)
    wrong = [exclusion.rows for exclusion in (*angles, *glitches) if exclusion.rows is not None]
    faults = LogFaults(
        rows=len(log.time),
        lost_rows=int(np.sum(missing)),
        wrong_rows=wrong_rows + int(np.sum(np.any(wrong, axis=0))),
        interruptions=len(interrupted),
        interrupted_s=log.interval * _count_changed_rows(complete, log, ("drive_on",)),
        interval_s=log.interval,
    )
    return ScreenedTest(
        replace(test, recording=remaining),
        frozenset(find_column_orders(log, nominal)),
        tuple(exclusion for exclusion in angles if exclusion.rows is None),
        (
            *estimate_bryan_factor(log, nominal),
            *estimate_decay_time(remaining, nominal),
            *estimate_frequency(remaining, nominal),
        ),
        (
            *_list_notes(complete),
            *changes,
            *filled,
            *moved,
            *interrupted,
            *(exclusion.sentence for exclusion in (*angles, *others, *glitches)),
        ),
        faults,
    )


def _list_notes(log: Log) -> list[str]:
    """A sentence on each thing that reading the log left out or missed, with its source."""
    return [f"{log.source}: {note}" for note in fold_absent_columns(log.exclusions)]


def _count_changed_rows(before: Log, after: Log, fields: Sequence[str]) -> int:
    """Number of rows in which any of these fields has another value, NaN aside."""
    changes = [np.abs(getattr(before, name) - getattr(after, name)) > 0 for name in fields]
    return int(np.sum(np.any(changes, axis=0)))
