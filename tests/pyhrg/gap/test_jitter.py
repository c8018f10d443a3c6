"""Readings at times that scatter: named, and nothing else is blamed."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.common.units import DEG
from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.effects.catalogue import Catalogue
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign
from tests.pyhrg.gap.bench import recorded
from tests.pyhrg.gap.soundness.conftest import NOMINAL
from tests.pyhrg.gap.soundness.spoil import change_logs

COLUMNS = {
    "encoder": {"table_angle": 1.0},
    "gyro": {"gyro_angle": 1.0, "wave_angle": -NOMINAL.bryan_factor},
}
COLUMNS["row"] = COLUMNS["encoder"] | COLUMNS["gyro"]
"""Columns that an instrument writes, with their turn per turn of the case."""


@pytest.fixture(scope="module")
def campaign(simulation: Simulation) -> Campaign:
    """Rest, and 5 and 60 deg/s."""
    bench = Bench(simulation.sampled, NOMINAL)
    power_ons = [
        PowerOn("still", "static", bench.programme().rest(300)),
        PowerOn("slow", "rate", bench.programme(0.1).rest(5).spin(5 * DEG, 40)),
        PowerOn("fast", "rate", bench.programme(0.1).rest(5).spin(60 * DEG, 30)),
    ]
    return recorded(simulation.sampled, NOMINAL, power_ons=power_ons)


def read_late(log: Log, instrument: str, jitter: float) -> Log:
    """The log of an instrument that is read at wrong times."""
    times = jitter * np.random.default_rng(len(log.time)).normal(size=len(log.time))
    turned = times * np.gradient(log.table_angle, log.interval)
    columns = {n: getattr(log, n) + share * turned for n, share in COLUMNS[instrument].items()}
    return replace(log, **columns)


@pytest.mark.parametrize("instrument", COLUMNS)
@pytest.mark.parametrize(("jitter", "verdict"), [(1e-5, "no_gap"), (1e-4, "explained")])
def test_jitter_alone_is_named(
    simulation: Simulation, campaign: Campaign, instrument: str, jitter: float, verdict: str
) -> None:
    given = change_logs(campaign, lambda log: read_late(log, instrument, jitter))
    found = diagnose(given, catalogue=Catalogue(known=()), simulation=simulation).diagnosis
    names = [cause.effect for cause in found.causes]
    listed = {known.parameter: known.value for known in found.within_tolerance}
    values = listed if verdict == "no_gap" else found.causes[0].parameters
    assert (found.verdict, names) == (verdict, ["time_jitter"] if verdict == "explained" else [])
    assert values == {f"{instrument}_jitter_s": pytest.approx(jitter, rel=0.2)}
    assert found.unknown_probability < 0.1
