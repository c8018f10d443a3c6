"""A frequency that follows the amplitude, in tests at a steady temperature, of a gyro whose stated
frequency is 5 Hz off."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.challenge.campaigns.gyro import Disturbance
from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.effects.catalogue import Catalogue
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.records import Log
from tests.pyhrg.gap.bench import short
from tests.pyhrg.gap.closing.equation.planted import record_planted
from tests.pyhrg.gap.soundness.conftest import NOMINAL
from tests.pyhrg.gap.test_diagnose import FEW

HZ = 2 * np.pi


@pytest.mark.parametrize("size", [0.0, 2e-4 * HZ])
def test_its_fourth_power_is_written_and_nothing_else(simulation: Simulation, size: float) -> None:
    def pull(log: Log) -> Log:
        pulled = 5 * HZ + size * ((log.amplitude / NOMINAL.amplitude) ** 4 - 1)
        return replace(log, frequency_offset=log.frequency_offset + pulled)

    bench = Bench(simulation.sampled, NOMINAL)
    sweep = bench.programme(0.1)
    for level in (0.8, 1.0, 1.2):
        sweep.command(amplitude_setpoint=level * NOMINAL.amplitude).rest(40)
    power_ons = [*short(bench), PowerOn("sweep", "amplitude_sweep", sweep)]
    campaign = record_planted(simulation.sampled, Disturbance(shown=pull), power_ons=power_ons)
    found = diagnose(campaign, catalogue=Catalogue(FEW), simulation=simulation).diagnosis
    assert found.causes == ()
    written = [(term.place, term.coordinates) for term in found.terms]
    assert written == ([("stiffness", ("amplitude",))] if size else [])
    assert bool(found.unnamed) is bool(size)
