"""A short campaign of a gyro without errors beyond the nominal ones, recorded on the FMU."""

from dataclasses import replace

import pytest

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.common.units import DEG
from pyhrg.device import device_file
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.records.campaign import Campaign
from tests.pyhrg.challenge.short import GYRO

NOMINAL = replace(GYRO, name="nominal")


def record_campaign(fmu: GyroFmu, device: Device) -> Campaign:
    """One test of each kind, of a gyro whose nominal device is `NOMINAL`."""
    bench = Bench(fmu, device, step=0.1)
    campaign = bench.campaign(bench.run(_power_ons(bench)))
    tests = [replace(t, role="holdout" if t.kind == "manoeuvre" else "fit") for t in campaign.tests]
    return replace(campaign, nominal=device_file.nominal(NOMINAL), tests=tuple(tests))


def _power_ons(bench: Bench) -> list[PowerOn]:
    start, quick = bench.programme, bench.programme(0.5)
    tumble = start().rest(60)
    for up in (0.0, -1.0, 0.0):
        tumble.attitude(up).rest(60)
    warm = start(2.0).rest(60).heat(NOMINAL.reference_temperature + 35, 600).rest(300)
    ring = start().rest(20).command(drive_on=0.0).rest(180)
    turning = start().rest(20).command(virtual_rotation=1 * DEG).rest(100)
    sweep = start(0.5).command(amplitude_setpoint=0.8).spin(5 * DEG, 40)
    return [
        PowerOn("still", "static", start().rest(600)),
        PowerOn("pos", "rate", quick.rest(10).spin(5 * DEG, 60)),
        PowerOn("neg", "rate", start(0.5).rest(10).spin(-20 * DEG, 60)),
        PowerOn("ring", "ring_down", ring),
        PowerOn("virtual", "virtual_rotation", turning),
        PowerOn("warm", "thermal", warm),
        PowerOn("sweep", "amplitude", sweep),
        PowerOn("tumble", "tumble", tumble),
        PowerOn("ride", "manoeuvre", start(0.5).rest(5).turn(90 * DEG, 10 * DEG).rest(60)),
    ]


@pytest.fixture(scope="session")
def error_free(slow_fmu: GyroFmu) -> Campaign:
    return record_campaign(slow_fmu, NOMINAL)
