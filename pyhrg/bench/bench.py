"""The virtual bench: simulates power-ons of a gyro on its FMU and logs them as a bench does."""

import math
import zlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field, replace
from itertools import groupby
from typing import Any

import numpy as np

from pyhrg.bench.outcome import BenchError
from pyhrg.bench.programme import COMMANDS, HELD_INPUTS, LOGGED_COMMANDS, Programme, make_course
from pyhrg.bench.store import Store, compute_key
from pyhrg.common.arrays import Array
from pyhrg.device.device import Device
from pyhrg.device.device_file import nominal
from pyhrg.device.fmu_parameters import LOOP_FREQUENCIES
from pyhrg.fmu import CONTROL_PERIOD, Gyro, GyroFmu, can_record_together, record_together
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign, Test

OUTPUTS_AT_END = {"gyro_angle": "gyroAngle", "wave_angle": "patternAngle", "amplitude": "amplitude"}
"""The FMU's names of its outputs that a log has at the end of each row, by their field of a log."""
OUTPUTS_AVERAGED = {
    "amplitude_force": "amplitudeForce",
    "quadrature_force": "quadratureForce",
    "frequency_offset": "frequencyOffset",
    "valid": "valid",
}
"""The FMU's names of its outputs that a log has averaged over each row, by their field of a log."""
LOOP_OUTPUTS = tuple(name for name in OUTPUTS_AVERAGED if name != "valid")
"""Fields of a log that the control loops put out."""
MAX_TEST_ROWS = 2_000_000
"""Largest number of rows of a test's power-ons. Chosen: ten times those of the largest test; their
logs take 0.3 GB."""
TOGETHER = 4
"""Largest number of power-ons that are simulated side by side. Chosen: they take a core about as
long as one of them (`benchmarks/speed.py`), and an interruption loses no more."""
NAMELESS = "gyro without a name"
"""Name of a device that has none, in campaigns and reports."""


@dataclass(frozen=True)
class PowerOn:
    """A power-on to be simulated.

    Attributes:
        id: name of the test in the campaign. The power-on's seed follows from it and the bench's
            seed, so that a procedure gives the same numbers alone and among others.
        kind: kind of the test in the campaign.
        programme: what the bench does to the gyro, row by row.
        start_angle: pattern angle at power-on, rad; drawn from the device's scatter if None.
        device: the gyro if it is another than the bench's, such as that gyro when it is older.
    """

    id: str
    kind: str
    programme: Programme
    start_angle: float | None = None
    device: Device | None = None


@dataclass(frozen=True)
class Bench:
    """A simulated gyro on a turntable.

    Attributes:
        seed: seed of all noise and of turn-on to turn-on scatter.
        step: communication step, s; rows of a programme are multiples of it.
        workers: power-ons that are simulated at the same time.
        store: keeps logs to resume from; None keeps none.
        on_power_on: called with the gyro time, s, of each power-on when it is over.
    """

    fmu: GyroFmu
    device: Device
    seed: int = 1
    step: float = 0.01
    workers: int = 1
    store: Store | None = None
    on_power_on: Callable[[float], None] = field(default=lambda seconds: None, compare=False)

    def programme(self, interval: float = 1.0) -> Programme:
        """An empty programme for this gyro and site, in rows of `interval` seconds."""
        device = self.device
        course = Programme(interval, device.site.gravity, device.reference_temperature)
        return course.command(amplitude_setpoint=device.amplitude)

    def run(self, power_ons: Sequence[PowerOn]) -> list[Test]:
        """Tests of the power-ons, in their order; the same numbers on any number of workers."""
        rows = sum(len(power_on.programme) for power_on in power_ons)
        if rows > MAX_TEST_ROWS:
            raise BenchError(
                f"a plan of {len(power_ons)} power-ons with {rows} rows: expected at most "
                f"{MAX_TEST_ROWS} rows"
            )
        groups = list(_group_alike(power_ons))
        if len(groups) < len(power_ons) and not can_record_together(self.fmu):
            groups = [[power_on] for power_on in power_ons]
        logged = self.fmu.map(self._log_alike, groups, self.workers)
        return [test for tests in logged for test in tests]

    def log_all(self, power_ons: Sequence[PowerOn]) -> list[Test]:
        """Tests of the power-ons, in their order, on this thread."""
        return [test for group in _group_alike(power_ons) for test in self._log_alike(group)]

    def power_on(self, identity: str, start_angle: float | None = None) -> Gyro:
        """The gyro, switched on, with noise, start angle and parameters drawn for this power-on.

        The same identity draws the same noise, angle and parameters. `start_angle`, rad, is drawn
        from the device's scatter if None.
        """
        parameters, seed, angle = self.draw_power_on(identity, start_angle)
        return self.fmu.power_on(parameters, seed, angle)

    def draw_power_on(
        self, identity: str, start_angle: float | None = None
    ) -> tuple[dict[str, float], int, float]:
        """Parameters of the FMU by name, seed and start angle, rad, of `power_on`."""
        key = zlib.crc32(identity.encode())
        generator = np.random.default_rng(np.random.SeedSequence(self.seed, spawn_key=(key,)))
        seed = int(generator.integers(2**31))
        drawn = generator.normal(self.device.power_on_angle, self.device.power_on_scatter)
        angle = drawn if start_angle is None else start_angle
        missing = LOOP_FREQUENCIES - self.fmu.references.keys()
        values = self.device.draw_turn_on(generator).items()
        return {name: value for name, value in values if name not in missing}, seed, angle

    def log(self, power_on: PowerOn) -> Test:
        """Test of one power-on: simulated, or from the store where an interrupted run kept it."""
        return self._log_alike([power_on])[0]

    def _log_alike(self, power_ons: Sequence[PowerOn]) -> list[Test]:
        """Tests of power-ons of one number and length of rows, which are simulated together."""
        store = self.store
        keys = [self._compute_key(e) if store else str(n) for n, e in enumerate(power_ons)]
        logs = {k: log for k in keys if store and (log := store.load(k)) is not None}
        missing = [(k, each) for k, each in zip(keys, power_ons, strict=True) if k not in logs]
        simulated = self._simulate([each for _, each in missing])
        for (key, _), log in zip(missing, simulated, strict=True):
            logs[key] = log
            if store:
                store.keep(key, log)
        tests = []
        for key, each in zip(keys, power_ons, strict=True):
            self.on_power_on(each.programme.time)
            recording = replace(logs[key], source=each.id)
            tests.append(Test(id=each.id, kind=each.kind, role="fit", recording=recording))
        return tests

    def _compute_key(self, power_on: PowerOn) -> str:
        """What the store keeps the log by."""
        return compute_key(
            power_on.programme,
            **{"id": power_on.id, "seed": self.seed, "step": self.step},
            **{"fmu": self.fmu.folder.name, "device": power_on.device or self.device},
            **{"start_angle": power_on.start_angle},
        )

    def _simulate(self, power_ons: Sequence[PowerOn]) -> list[Log]:
        commands = [{n: each.programme.values(n) for n in COMMANDS} for each in power_ons]
        held = [{name: each[name] for name in HELD_INPUTS} for each in commands]
        benches = [replace(self, device=each.device or self.device) for each in power_ons]
        pairs = list(zip(benches, power_ons, strict=True))
        moving = [bench._moving_inputs(each.programme) for bench, each in pairs]
        with ExitStack() as stack:
            gyros = [
                stack.enter_context(bench.power_on(each.id, each.start_angle))
                for bench, each in pairs
            ]
            recorded = record_rows_together(gyros, moving, held, self.step) if gyros else []
        logs = []
        for each, own, outputs in zip(power_ons, commands, recorded, strict=True):
            programme = each.programme
            columns: dict[str, Any] = {
                "time": np.arange(1, len(programme) + 1) * programme.interval,
                "table_angle": programme.table_angle,
                "temperature": programme.temperature[1:],
                **{name: own[name] for name in LOGGED_COMMANDS},
                **outputs,
            }
            logs.append(Log(source=each.id, interval=programme.interval, exclusions=(), **columns))
        return logs

    def campaign(self, tests: Sequence[Test]) -> Campaign:
        """A campaign of the tests, with the device's design values as nominal values."""
        return Campaign(
            self.device.name or NAMELESS, self.device.site, nominal(self.device), tuple(tests)
        )

    def _moving_inputs(self, programme: Programme) -> dict[str, Array]:
        """(n, m) inputs that change within a row, in each communication step, SI."""
        course = make_course(programme, self.step)
        earth = compute_earth_rate(self.device, course.each("axis_up"), course.table_angle)
        return {"angularRate": course.rate + earth, "caseTemperature": course.temperature}


def _group_alike(power_ons: Sequence[PowerOn]) -> Iterator[list[PowerOn]]:
    """Neighbours of one number and length of rows, `TOGETHER` at most."""
    for _, alike in groupby(power_ons, lambda p: (p.programme.interval, len(p.programme))):
        group = list(alike)
        yield from (group[i : i + TOGETHER] for i in range(0, len(group), TOGETHER))


def record_rows(
    gyro: Gyro,
    moving: Mapping[str, Array],
    held: Mapping[str, Array],
    step: float,
    means: Sequence[str] = tuple(OUTPUTS_AVERAGED),
    at_end: Mapping[str, str] = OUTPUTS_AT_END,
) -> dict[str, Array]:
    """Outputs of a gyro as a log has them: (n,) each, by field, SI.

    The amplitude is that of one control period before the end of each row, as the electronics know
    it. `moving` are (n, m) inputs in each of a row's m communication steps of `step` seconds, by
    the FMU's names, SI; `held` are (n,) inputs by their names in a programme, SI; `means` are
    fields that are averaged over each row, `at_end` the FMU's names of others.
    """
    return record_rows_together([gyro], [moving], [held], step, means, at_end)[0]


def record_rows_together(
    gyros: Sequence[Gyro],
    moving: Sequence[Mapping[str, Array]],
    held: Sequence[Mapping[str, Array]],
    step: float,
    means: Sequence[str] = tuple(OUTPUTS_AVERAGED),
    at_end: Mapping[str, str] = OUTPUTS_AT_END,
) -> list[dict[str, Array]]:
    """`record_rows` of gyros of one FMU that were switched on at the same time: the same bits as
    one by one, faster."""
    commands = [{HELD_INPUTS[name]: values for name, values in each.items()} for each in held]
    averaged = [OUTPUTS_AVERAGED[name] for name in means]
    names, interval = (*at_end, *means), step * next(iter(moving[0].values())).shape[1]
    outputs = record_together(gyros, moving, commands, step, list(at_end.values()), averaged)
    recorded = []
    for ends, rows in outputs:
        fields = dict(zip(names, [*ends.T, *rows.T], strict=True))
        change = np.diff(fields["amplitude"], prepend=fields["amplitude"][0])
        fields["amplitude"] = np.asarray(fields["amplitude"] - change * CONTROL_PERIOD / interval)
        recorded.append(fields)
    return recorded


def compute_earth_rate(device: Device, axis_up: Array, table_angle: Array) -> Array:
    """Earth's rate on the input axis, rad/s; a misaligned axis leans north once in a table turn.

    `axis_up` is the projection of the table's axis on local up, the rest of which points east: a
    table that tilts to the east turns that below the horizon. `table_angle`, rad, broadcasts with
    it.
    """
    azimuth = table_angle + device.misalignment_direction
    site = replace(device.site, latitude=device.site.latitude + device.latitude_error)
    east = np.sqrt(np.maximum(1 - np.asarray(axis_up) ** 2, 0.0))
    below = site.vertical_rate * math.sin(device.table_tilt_east) * east
    return site.compute_earth_rate(axis_up, device.misalignment, azimuth) - below
