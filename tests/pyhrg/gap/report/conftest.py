"""Diagnoses of short campaigns, made once: of a gyro with a gap, and of one without."""

from dataclasses import replace

import numpy as np
import pytest

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.common.units import DEG
from pyhrg.device import device_file
from pyhrg.device.device import Device
from pyhrg.device.keys import KEYS
from pyhrg.fmu import GyroFmu
from pyhrg.gap.campaign_diagnosis import CampaignDiagnosis
from pyhrg.gap.diagnose import diagnose
from pyhrg.gap.effects.catalogue import EFFECTS, Catalogue
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign
from tests.pyhrg.gap.soundness.conftest import NOMINAL

NOISE = {
    "amplitude": 1e-6,
    "amplitude_force": 2e-8,
    "quadrature_force": 1e-8,
    "frequency_offset": 6e-5,
    "temperature": 5e-3,
}
"""Of a row, SI."""
FIELDS = (
    *("damping_anisotropy", "damping_axis", "frequency_split", "stiffness_axis"),
    *("angle_random_walk", "angle_white_noise"),
)
STATED = [key for key in KEYS if key.field in FIELDS]
"""What is believed beside what any bench believes."""
CATALOGUE = tuple(
    EFFECTS[name] for name in ("damping_anisotropy", "frequency_split", "pickoff_gain_mismatch")
)
"""Enough of it."""


def campaign_of(fmu: GyroFmu, device: Device) -> Campaign:
    """A rest, a slow turn, a warming, and a held-out ride of a gyro believed to be `BELIEVED`."""
    bench = Bench(fmu, device, step=0.1)
    begun = bench.programme
    warm = begun(2.0).rest(20).heat(NOMINAL.reference_temperature + 10, 300).rest(200)
    power_ons = [
        PowerOn("still", "static", begun().rest(400)),
        PowerOn("slow", "rate", begun().rest(5).spin(0.5 * DEG, 300)),
        PowerOn("warm", "thermal", warm),
        PowerOn("ride", "manoeuvre", begun().rest(5).turn(90 * DEG, 1 * DEG).rest(200)),
    ]
    campaign = bench.campaign(bench.run(power_ons))
    generator = np.random.default_rng(7)
    tests = [
        replace(
            t,
            role="holdout" if t.kind == "manoeuvre" else "fit",
            recording=_noisy(t.log, generator),
        )
        for t in campaign.tests
    ]
    stated = {key.name: key.from_si(getattr(NOMINAL, key.field)) for key in STATED}
    nominal = {**device_file.nominal(NOMINAL), **stated}
    return replace(campaign, nominal=nominal, tests=tuple(tests))


def _noisy(log: Log, generator: np.random.Generator) -> Log:
    """With the noise of forces and of thermometers, which the simulated gyro has none of."""
    noisy = {
        name: getattr(log, name) + generator.normal(0, deviation, len(log.time))
        for name, deviation in NOISE.items()
    }
    return replace(log, **noisy)


@pytest.fixture(scope="session")
def simulation(fmu: GyroFmu, slow_fmu: GyroFmu) -> Simulation:
    return Simulation(fmu, slow_fmu)


@pytest.fixture(scope="session")
def with_gap(slow_fmu: GyroFmu, simulation: Simulation) -> CampaignDiagnosis:
    """Too much damping anisotropy."""
    campaign = campaign_of(slow_fmu, replace(NOMINAL, damping_anisotropy=3e-6))
    return diagnose(campaign, catalogue=Catalogue(CATALOGUE), simulation=simulation)


@pytest.fixture(scope="session")
def without_gap(slow_fmu: GyroFmu, simulation: Simulation) -> CampaignDiagnosis:
    campaign = campaign_of(slow_fmu, NOMINAL)
    return diagnose(campaign, catalogue=Catalogue(CATALOGUE), simulation=simulation)
