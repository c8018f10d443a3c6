"""An error of the pick-off by the pattern angle: place, form and size of the proposed term.

The error enters as input rates and readings, apart from any candidate term. `benchmarks/terms.py`
tries errors of drives and gains, too.
"""

import numpy as np

from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.effects.catalogue import Catalogue
from pyhrg.gap.replay.simulation import Simulation
from tests.pyhrg.gap.closing.equation.planted import plant_electrode_error, record_planted
from tests.pyhrg.gap.test_diagnose import FEW

ARCSEC_3 = 20.0
"""Coefficient of the third harmonic of the error."""


def test_place_form_and_size_are_right(simulation: Simulation) -> None:
    disturb = plant_electrode_error(lambda a, level: np.cos(3 * a), ARCSEC_3, True)
    campaign = record_planted(simulation.sampled, disturb(1.0))
    found = diagnose(campaign, catalogue=Catalogue(FEW), simulation=simulation).diagnosis
    (term,) = found.terms
    assert (term.place, term.coordinates) == ("pickoff", ("wave_angle",))
    assert term.function == "pick-off: harmonic 3 of the pattern angle"
    low, high = term.interval_95["pickoff_cos3_arcsec"]
    assert low <= ARCSEC_3 <= high
    assert high - low < 0.1 * ARCSEC_3
