"""Short campaigns of the gyro with sampled loops, noise of its own and of a thermometer."""

from collections.abc import Sequence
from dataclasses import replace
from functools import cache

import numpy as np

from pyhrg.bench.bench import Bench, PowerOn
from pyhrg.bench.programme import Programme
from pyhrg.common.units import DEG
from pyhrg.device import device_file
from pyhrg.device.device import Device
from pyhrg.device.keys import KEYS
from pyhrg.fmu import GyroFmu
from pyhrg.gap.replay.simulation import Simulation
from pyhrg.records.campaign import Campaign, Test
from tests.pyhrg.gap.soundness.conftest import NOMINAL

THERMOMETER = 5e-3
"""Noise of a reading, K."""


def recorded(
    fmu: GyroFmu,
    device: Device,
    believed: Device = NOMINAL,
    seed: int = 1,
    power_ons: Sequence[PowerOn] | None = None,
) -> Campaign:
    """What the bench brings home of one gyro, where another is believed in."""
    if power_ons is None:
        return _recorded_short(fmu, device, believed, seed)
    bench = Bench(fmu, device, seed=seed)
    campaign = bench.campaign(bench.run(power_ons))
    generator = np.random.default_rng(seed)
    tests = [_read(test, generator) for test in campaign.tests]
    return replace(campaign, nominal=stated(believed), tests=tuple(tests))


@cache
def _recorded_short(fmu: GyroFmu, device: Device, believed: Device, seed: int) -> Campaign:
    return recorded(fmu, device, believed, seed, short(Bench(fmu, device, seed=seed)))


@cache
def tiny(simulation: Simulation, device: Device = NOMINAL, seed: int = 1) -> Campaign:
    """A campaign of three short tests; kept, as many tests ask for the same."""
    bench = Bench(simulation.sampled, device)
    begun = bench.programme
    power_ons = [
        PowerOn("still", "static", begun().rest(200)),
        PowerOn("pos", "rate", begun(0.1).rest(5).spin(5 * DEG, 66)),
        PowerOn("ride", "manoeuvre", begun(0.5).rest(5).turn(90 * DEG, 10 * DEG).rest(220)),
    ]
    return recorded(simulation.sampled, device, seed=seed, power_ons=power_ons)


def short(bench: Bench) -> list[PowerOn]:
    """Rest, eight positions, both ways at 5 deg/s, without drive, commanded rotation, a ride."""
    begun = bench.programme
    positions = begun().rest(40)
    for _ in range(7):
        positions.turn(81.2 * DEG, 20 * DEG).rest(40)
    return [
        PowerOn("still", "static", begun().rest(600)),
        PowerOn("positions", "positions", positions),
        PowerOn("pos", "rate", begun(0.1).rest(5).spin(5 * DEG, 66)),
        PowerOn("neg", "rate", begun(0.1).rest(5).spin(-5 * DEG, 66)),
        PowerOn("ring", "ring_down", begun().rest(20).command(drive_on=0.0).rest(100)),
        PowerOn("virtual", "virtual_rotation", _virtual(bench)),
        PowerOn("ride", "manoeuvre", begun(0.5).rest(5).turn(90 * DEG, 10 * DEG).rest(220)),
    ]


def _virtual(bench: Bench) -> Programme:
    return bench.programme().rest(20).command(virtual_rotation=1 * DEG).rest(100)


def stated(device: Device) -> dict[str, float]:
    """All that differs from an ideal gyro, as a campaign's nominal values have it."""
    values = device_file.nominal(device)
    fields = {key.field for key in KEYS if key.name in values}
    for key in KEYS:
        if key.field not in fields and getattr(device, key.field) != getattr(Device(), key.field):
            values[key.name] = key.from_si(getattr(device, key.field))
            fields.add(key.field)
    return values


def _read(test: Test, generator: np.random.Generator) -> Test:
    log = test.log
    read = log.temperature + THERMOMETER * generator.normal(size=len(log.time))
    role = "holdout" if test.kind == "manoeuvre" else "fit"
    return replace(test, role=role, recording=replace(log, temperature=read))
