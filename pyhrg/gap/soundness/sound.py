"""A campaign without what contradicts it."""

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from pyhrg.device.device import Device
from pyhrg.device.device_file import DeviceError, from_table
from pyhrg.device.keys import KEYS
from pyhrg.gap.soundness.doubt import Believed, Witness
from pyhrg.gap.soundness.examined import Examined, examined
from pyhrg.records.campaign import INDEX, Campaign, CampaignError, Test

NEEDED = ("coriolis_factor", "decay_time_s", "frequency_Hz")
MOST = 0.5
"""Share of logs that contradict something, from which on it is not the logs that are left out."""


def sound(campaign: Campaign) -> tuple[Campaign, tuple[str, ...]]:
    """The campaign that can be diagnosed: tests whose inputs can be replayed row by row, outputs
    NaN where they are missing or contradict what a campaign's format fixes.

    Bounds are wide: what a gyro may really do wrong is never taken out, only what columns, units,
    signs or files mixed up do. A `truth.json` is not looked at.

    Returns:
        The campaign, and a sentence on each thing that was left out or taken for granted.

    Raises:
        CampaignError: nominal values are missing or can't be; most logs contradict them (another
            gyro's) or themselves; no test that may be fitted is left.
    """
    nominal, notes = _nominal(campaign)
    believed = Believed(_device(nominal), campaign.site)
    results = [examined(test, believed) for test in campaign.tests]
    found = [result for result in results if isinstance(result, Examined)]
    _check_order(found)
    _check_gyro([witness for one in found for witness in one.witnesses])
    _check_angles(found)
    for result in results:
        notes += result.sentences if isinstance(result, Examined) else [result]
    tests, twins = _unseen([one.usable for one in found if one.is_usable])
    notes += twins
    if all(test.is_holdout for test in tests):
        reasons = "; ".join(notes) or "all are held out"
        raise CampaignError(f"no test that may be fitted can be used: {reasons}")
    if not any(test.is_holdout for test in tests):
        notes.append("no test is held out: a diagnosis can't be verified")
    return replace(campaign, nominal=nominal, tests=tuple(tests)), tuple(notes)


def _nominal(campaign: Campaign) -> tuple[dict[str, float], list[str]]:
    """Values whose keys are known."""
    missing = [key for key in NEEDED if key not in campaign.nominal]
    if missing:
        raise CampaignError(f"{INDEX}: nominal.{missing[0]}: missing; expected a number")
    names = [key.name for key in KEYS]
    unknown = [key for key in campaign.nominal if key not in names]
    notes = [f"{INDEX}: nominal.{key}: not known, ignored" for key in unknown]
    return {k: v for k, v in campaign.nominal.items() if k in names}, notes


def _device(nominal: dict[str, float]) -> Device:
    try:
        return from_table(nominal, f"{INDEX}: nominal")
    except DeviceError as error:
        raise CampaignError(str(error)) from error


def _check_order(found: Sequence[Examined]) -> None:
    """Refuse a campaign whose logs all fit one other order of the angles, and some not the stated
    one; logs that fit none are something else, if they are not many."""
    fitting = [one for one in found if one.arrangements]
    other = [one for one in fitting if "" not in one.arrangements]
    strange = [one for one in found if one.angles and not one.arrangements]
    if len(other) <= len(strange):
        return
    common = frozenset.intersection(*(one.arrangements for one in fitting))
    if common:
        names = min(sorted(common), key=len)
        raise CampaignError(
            f"{other[0].test.log.source} and others: columns {names}: all logs fit each other's "
            "names, these not their own: are they swapped?"
        )


def _check_angles(found: Sequence[Examined]) -> None:
    """Refuse a campaign with angles mixed up in most logs."""
    wrong = [one for one in found if one.angles and not one.is_usable]
    if len(wrong) > MOST * len(found):
        sentence = wrong[0].angles[0].sentence
        raise CampaignError(f"{len(wrong)} of {len(found)} logs, as {sentence}")


def _check_gyro(witnesses: Sequence[Witness]) -> None:
    """Refuse nominal values that most logs contradict in a field, unless another field contradicts
    what that one says."""
    by_field: dict[tuple[str, str], list[Witness]] = defaultdict(list)
    for witness in witnesses:
        by_field[witness.key, witness.field].append(witness)
    for (key, field), those in by_field.items():
        if np.mean([witness.contradicts for witness in those]) <= MOST:
            continue
        value = float(np.median([witness.found for witness in those]))
        others = [w for (k, f), ws in by_field.items() if k == key and f != field for w in ws]
        if not others or np.mean([witness.fits(value) for witness in others]) > MOST:
            raise _another_gyro(key, those)


def _another_gyro(key: str, witnesses: Sequence[Witness]) -> CampaignError:
    against = [witness for witness in witnesses if witness.contradicts]
    logs = {witness.source for witness in against}
    return CampaignError(
        f"{INDEX}: nominal.{key}: contradicted by {len(logs)} logs, as {against[0].sentence}: are "
        "they another gyro's, or is the column in another unit or sign?"
    )


def _unseen(tests: Sequence[Test]) -> tuple[list[Test], list[str]]:
    """Without tests that are held out but were also given to be fitted."""
    fitted = {_outputs(test): test.id for test in tests if not test.is_holdout}
    twins = {t.id: fitted[_outputs(t)] for t in tests if t.is_holdout and _outputs(t) in fitted}
    notes = [f"{name}: not used: the same log as {twin}" for name, twin in twins.items()]
    return [test for test in tests if test.id not in twins], notes


def _outputs(test: Test) -> bytes:
    return test.log.gyro_angle.tobytes() + test.log.wave_angle.tobytes()
