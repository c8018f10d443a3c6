"""What an effect outside the catalogue is, to who generates it."""

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module

import numpy as np

from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.device.device import Device

FILE = "pyhrg.challenge.truths.outside"
"""Loaded by this name when a challenge is generated; no module imports it."""


@dataclass(frozen=True)
class Form:
    """An effect that no catalogue names.

    name: of the form.
    coordinate: that it lives in, as the campaign format calls it.
    scale: a size that is nothing special, in its own unit.
    disturbance: by the believed gyro, a size in units of the scale, and a generator of what else
        the form is free in; the same generator gives the same form at any size.
    """

    name: str
    coordinate: str
    scale: float
    disturbance: Callable[[Device, float, np.random.Generator], Disturbance]


def forms() -> tuple[Form, ...]:
    """All forms that there are."""
    found: tuple[Form, ...] = import_module(FILE).FORMS
    return found
