"""Errors of pick-off and drive by the pattern angle: place, form and size of the proposed term.

The errors enter as input rates and readings, apart from any candidate term.
"""

from collections.abc import Callable

import numpy as np
import pytest

from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.effects.catalogue import Catalogue
from pyhrg.gap.replay.simulation import Simulation
from tests.pyhrg.gap.closing.equation.planted import (
    plant_drive_gain,
    plant_electrode_error,
    record_planted,
)
from tests.pyhrg.gap.test_diagnose import FEW

ARCSEC_3, RATIO_3 = 20.0, 3e-4
"""Coefficient of the third harmonic of an electrode's error, arcsec, and of a gain."""


@pytest.mark.parametrize(
    ("disturb", "place", "function", "name", "size"),
    [
        (
            plant_electrode_error(lambda a, level: np.cos(3 * a), ARCSEC_3, True),
            "pickoff", "pick-off: harmonic 3 of the pattern angle", "pickoff_cos3_arcsec", ARCSEC_3,
        ),
        (
            plant_electrode_error(lambda a, level: np.cos(3 * a), 5 * ARCSEC_3, False),
            "drive", "drive: harmonic 3 of the pattern angle", "drive_cos3_arcsec", 5 * ARCSEC_3,
        ),
        (
            plant_drive_gain(lambda a: np.cos(3 * a), RATIO_3),
            "drive", "drive gain: harmonic 3 of the pattern angle", "drive_gain_cos3", RATIO_3,
        ),
    ],
    ids=["pick-off", "drive", "drive gain"],
)  # fmt: skip
def test_place_form_and_size_are_right(
    simulation: Simulation,
    disturb: Callable[[float], Disturbance],
    place: str,
    function: str,
    name: str,
    size: float,
) -> None:
    campaign = record_planted(simulation.sampled, disturb(1.0))
    found = diagnose(campaign, catalogue=Catalogue(FEW), simulation=simulation).diagnosis
    (term,) = found.terms
    assert (term.place, term.coordinates, term.function) == (place, ("wave_angle",), function)
    low, high = term.interval_95[name]
    assert low <= size <= high
    assert high - low < 0.1 * size
