"""Screening: what contradicts the format, the nominal values or itself is left out."""

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from pyhrg.device.device import Device
from pyhrg.device.device_file import from_table
from pyhrg.device.keys import KEYS
from pyhrg.gap.soundness.exclusion import NominalEstimate
from pyhrg.gap.soundness.screened_test import ScreenedTest, screen_test
from pyhrg.records.campaign import INDEX, Campaign, CampaignError, Test

REQUIRED_KEYS = ("coriolis_factor", "decay_time_s", "frequency_Hz")
"""Nominal values without which no campaign is diagnosed."""
MAX_CONTRADICTING_SHARE = 0.5
"""Share of contradicting logs above which the campaign is refused, since the nominal values or all
logs must then be wrong. Chosen."""


def screen_campaign(campaign: Campaign) -> tuple[Campaign, tuple[str, ...]]:
    """The campaign that can be diagnosed, and a sentence for everything left out or assumed.

    Every test has inputs that can be replayed row by row. Outputs are NaN where they are missing or
    contradict what the campaign format fixes. Limits are wide: no real error of a gyro exceeds
    them, only mixed-up columns, units, signs or files do. A `CampaignError` where a nominal value
    is missing, most logs contradict the nominal values or themselves, or no test can be fitted.
    """
    notes = _check_nominal(campaign)
    nominal = nominal_device(campaign)
    results = [screen_test(test, nominal) for test in campaign.tests]
    screened = [result for result in results if isinstance(result, ScreenedTest)]
    _check_column_order(screened)
    _check_gyro([estimate for each in screened for estimate in each.estimates])
    _check_angles(screened)
    for result in results:
        notes += result.sentences if isinstance(result, ScreenedTest) else [result]
    tests, duplicates = _drop_known_holdouts([each.usable for each in screened if each.is_usable])
    notes += duplicates
    if all(test.is_holdout for test in tests):
        reasons = "; ".join(notes) or "all are held out"
        raise CampaignError(f"no test that may be fitted can be used: {reasons}")
    if not any(test.is_holdout for test in tests):
        notes.append("no test is held out: a diagnosis can't be verified")
    return replace(campaign, tests=tuple(tests)), tuple(notes)


def describe_screening(campaign: Campaign) -> str:
    """What a diagnosis would leave out of a campaign or take for granted, in words."""
    try:
        _, exclusions = screen_campaign(campaign)
    except CampaignError as error:
        return f"a diagnosis would refuse it: {error}"
    if not exclusions:
        return "a diagnosis would use all of it"
    sentences = "\n".join(f"  {sentence}" for sentence in exclusions)
    return f"a diagnosis would leave out, or take for granted:\n{sentences}"


def nominal_device(campaign: Campaign) -> Device:
    """The device that a campaign's nominal values state, without values that are no device key;
    a `DeviceError` where they are no device's."""
    names = {key.name for key in KEYS}
    nominal = {name: value for name, value in campaign.nominal.items() if name in names}
    return replace(from_table(nominal, f"{INDEX}: nominal"), site=campaign.site)


def _check_nominal(campaign: Campaign) -> list[str]:
    """A sentence on each nominal value whose key is not known."""
    missing = [key for key in REQUIRED_KEYS if key not in campaign.nominal]
    if missing:
        raise CampaignError(f"{INDEX}: nominal.{missing[0]}: missing; expected a number")
    names = [key.name for key in KEYS]
    unknown = [key for key in campaign.nominal if key not in names]
    return [f"{INDEX}: nominal.{key}: not known, ignored" for key in unknown]


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


def _check_angles(screened: Sequence[ScreenedTest]) -> None:
    """Refuse a campaign with mixed-up angles in most logs."""
    wrong = [each for each in screened if each.angles and not each.is_usable]
    if len(wrong) > MAX_CONTRADICTING_SHARE * len(screened):
        sentence = wrong[0].angles[0].sentence
        raise CampaignError(f"{len(wrong)} of {len(screened)} logs, as {sentence}")


def _check_gyro(estimates: Sequence[NominalEstimate]) -> None:
    """Refuse a nominal value that a field contradicts in most logs, unless estimates from another
    field contradict that field's estimate."""
    by_field: dict[tuple[str, str], list[NominalEstimate]] = defaultdict(list)
    for estimate in estimates:
        by_field[estimate.key, estimate.field].append(estimate)
    for (key, field), own in by_field.items():
        if np.mean([estimate.contradicts for estimate in own]) <= MAX_CONTRADICTING_SHARE:
            continue
        value = float(np.median([estimate.found for estimate in own]))
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
