"""The gyro as it is believed, and with what was found in it."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from pyhrg.device.device import Device
from pyhrg.device.device_file import from_table
from pyhrg.device.keys import KEYS
from pyhrg.gap.effects.catalogue import EFFECTS, NAMES
from pyhrg.gap.evidence.attribution import Attribution
from pyhrg.gap.findings.diagnosis import DiagnosisError
from pyhrg.records.campaign import Campaign


def believed_device(campaign: Campaign) -> Device:
    """The gyro that a campaign's nominal values state, those aside that are not known.

    Raises:
        DeviceError: they are no gyro's.
    """
    names = {key.name for key in KEYS}
    nominal = {name: value for name, value in campaign.nominal.items() if name in names}
    stated = from_table(nominal, f"{campaign.device}: nominal")
    return replace(stated, site=campaign.site)


def closed_device(found: Attribution) -> Device:
    """The believed gyro with the causes in it."""
    device = found.believed
    for effect, size in found.ranked.best.named.items():
        device = effect.put(device, effect.vector(found.believed) + size)
    totals: dict[str, Any] = {added.effect.field: added.total for added in found.noise.added}
    return replace(device, **totals)


def with_causes(believed: Device, causes: Mapping[str, Mapping[str, float]]) -> Device:
    """The believed gyro with causes as a file has them, noise aside.

    Raises:
        DiagnosisError: no such effect, or a parameter is missing.
    """
    device = believed
    for name, parameters in causes.items():
        if name not in NAMES:
            raise DiagnosisError(f"causes: {name}: expected an effect of {', '.join(NAMES)}")
        if name in EFFECTS:
            missing = [key.name for key in EFFECTS[name].keys if key.name not in parameters]
            if missing:
                raise DiagnosisError(f"causes: {name}: {missing[0]}: missing; expected a number")
            device = EFFECTS[name].put(device, EFFECTS[name].vector_of(parameters))
    return device
