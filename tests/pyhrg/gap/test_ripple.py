"""A ripple of the table that its encoder does not show."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from pyhrg.common.units import ARCSEC
from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.records import Log, campaign
from tests.pyhrg.gap.soundness.spoil import change_logs


def test_a_ripple_is_named_alone(simulation: Simulation, recorded_campaign: Path) -> None:
    def ripple(log: Log) -> Log:
        error = np.sin(3 * log.table_angle + 0.7) - np.sin(0.7)
        return replace(log, table_angle=log.table_angle + 0.5 * ARCSEC * error)

    given = campaign.read_campaign(recorded_campaign.parent / "lab-04")
    found = diagnose(change_logs(given, ripple), simulation=simulation).diagnosis
    assert found.verdict == "explained"
    (cause,) = found.causes
    assert (cause.effect, cause.family) == ("table_ripple", "bench")
    assert cause.parameters == {"table_ripple_3_arcsec": pytest.approx(0.5, abs=0.02)}
    (term,) = found.terms
    assert (term.place, term.coordinates) == ("bench", ("table_angle",))
