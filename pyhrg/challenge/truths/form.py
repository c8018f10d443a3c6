"""The interface of errors that the catalogue lacks."""

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module

import numpy as np

from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.device.device import Device

FORMS_MODULE = "pyhrg.challenge.truths.outside"
"""Loaded by this name when a challenge is generated; no module imports it."""


@dataclass(frozen=True)
class Form:
    """A form of error that the catalogue lacks.

    name: of the form.
    coordinate: in which it shows, by the name of the record format.
    scale: a typical size, in its own unit.
    disturbance: by the believed gyro, a size in units of the scale, and a generator of what else
        the form is free in; the same generator gives the same form at any size.
    """

    name: str
    coordinate: str
    scale: float
    disturbance: Callable[[Device, float, np.random.Generator], Disturbance]


def load_forms() -> tuple[Form, ...]:
    """All forms."""
    found: tuple[Form, ...] = import_module(FORMS_MODULE).FORMS
    return found
