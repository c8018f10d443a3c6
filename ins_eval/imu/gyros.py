"""Three gyros that are simulated by their FMU."""

from collections.abc import Callable, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from fmu_build.bundle import build_fmu
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.imu.map_sizes import MapSizes, size_maps
from ins_eval.imu.mounting import Mounting
from ins_eval.imu.stated_gyros import GyroReading
from pyhrg.bench.bench import Bench
from pyhrg.bench.bias.position import full_circumference
from pyhrg.bench.dynamic.start_up import START
from pyhrg.common.arrays import Array, Mask
from pyhrg.common.errors import HrgError
from pyhrg.device import device_file
from pyhrg.device.keys import KEYS
from pyhrg.device.ready_devices import TYPICAL, Device
from pyhrg.fmu import GyroFmu, record_together
from pyhrg.records.imu.log import Increments

FLIGHT = "flight"
"""Identity of the power-on of a flight (`Bench.power_on`)."""
AMPLITUDE_TOLERANCE = 1e-3
"""Largest relative difference of the amplitude from its set point for a gyro to be ready. Chosen:
while the amplitude grows, the output is valid, but the misaligned driving force turns the pattern
by degrees an hour."""


@dataclass(frozen=True)
class FmuGyros:
    """Gyros simulated by their FMU.

    Attributes:
        device: parameters that the three have in common.
        own_axes: whether the axes of imperfection and the power-on angle of each gyro are drawn at
            random (`Device.another`).
        differences: fields of `Device` that are set for each gyro.
        calibrated: whether the maker has measured each gyro's mean bias and subtracts it.
        start_up: whether the record begins at power-on with the gyros' start-up; otherwise the
            gyros vibrate at full amplitude from the beginning.
        fmu: the model; None builds the one of the present sources, or takes it from the cache.
    """

    device: Device = TYPICAL
    own_axes: bool = True
    differences: tuple[Mapping[str, Any], ...] = field(default=({}, {}, {}), hash=False)
    calibrated: bool = True
    start_up: bool = False
    fmu: GyroFmu | None = None

    def devices(self, generator: np.random.Generator) -> list[Device]:
        drawn = [self.device.another(generator) if self.own_axes else self.device for _ in "xyz"]
        return [replace(d, **own) for d, own in zip(drawn, self.differences, strict=True)]

    def check_interval(self, interval: float) -> None:
        """Refuse an interval, s, that is not a multiple of the electronics' control period."""
        periods = interval / self.device.control_period
        if round(periods) < 1 or abs(periods - round(periods)) > 1e-6:
            raise HrgError(
                f"found increments over {interval:g} s; expected a multiple of the gyros' control "
                f"period, {self.device.control_period:g} s"
            )

    def measure(
        self, truth: Increments, mounting: Mounting, generator: np.random.Generator
    ) -> GyroReading:
        """Simulate the gyros on the true motion."""
        self.check_interval(truth.interval)
        return self.record(self.draw(generator), truth, mounting)

    def record(
        self, benches: Sequence[Bench], truth: Increments, mounting: Mounting
    ) -> GyroReading:
        """Simulate drawn gyros on the true motion."""
        forces = [resolve_force_in_case(truth, axis) for axis in mounting.axes]
        components = mounting.project(truth.rotation)
        outputs = simulate_together(benches, components, forces, truth.interval)
        rotation = np.stack([output.rotation for output in outputs], axis=1)
        if self.calibrated:
            rotation -= [calibrate_mean_bias(bench) * truth.interval for bench in benches]
        pattern = np.stack([output.pattern_angle for output in outputs], axis=1)
        ready = np.logical_and.reduce([output.ready for output in outputs])
        return GyroReading(rotation, pattern, ready)

    def draw(self, generator: np.random.Generator) -> list[Bench]:
        """Draw three gyros, each on a bench of its own; they are switched on as `FLIGHT`."""
        if self.calibrated and self.is_swept:
            raise HrgError(
                "found gyros that sweep their pattern (sweep_angle_deg): a calibration of their "
                "mean bias at rest is not possible; expected calibrated = false in [gyros] of the "
                "IMU file"
            )
        fmu = self.fmu or GyroFmu(build_fmu())
        devices = self.devices(generator)
        if self.start_up:
            devices = [with_start_up(each) for each in devices]
        return [Bench(fmu, device, seed=int(generator.integers(2**63))) for device in devices]

    def change(self, change: Callable[[Device], Device]) -> "FmuGyros":
        """The gyros of changed parameters; what is drawn of them stays."""
        differences = tuple(
            {name: getattr(changed, name) for name in own}
            for own, changed in zip(self.differences, map(change, self.stated_devices), strict=True)
        )
        return replace(self, device=change(self.device), differences=differences)

    @property
    def stated_devices(self) -> list[Device]:
        """The three gyros before anything of them is drawn."""
        return [replace(self.device, **own) for own in self.differences]

    @property
    def is_swept(self) -> bool:
        """Whether the electronics of a gyro sweep its pattern."""
        return any(device.sweep_angle for device in self.stated_devices)

    @property
    def map_sizes(self) -> tuple[MapSizes, ...]:
        """Sizes of the three gyros' errors over the pattern angle."""
        return tuple(
            size_maps(each, self.own_axes, self.calibrated) for each in self.stated_devices
        )

    @property
    def errors(self) -> SensorErrors:
        """Sensor errors of one gyro that a linear model should assume; the bias is that at rest,
        at any pattern angle."""
        devices = self.stated_devices
        return SensorErrors(
            gyro_bias=_rms([sizes.rest_bias for sizes in self.map_sizes]),
            angle_random_walk=_rms([device.angle_random_walk for device in devices]),
            gyro_bias_instability=_rms([device.bias_instability for device in devices]),
            angle_quantization_step=_rms([_quantization_step(device) for device in devices]),
            gyro_rate_random_walk=_rms([device.rate_random_walk for device in devices]),
        )


def read_differences(document: Mapping[str, Any], source: str) -> dict[str, Any]:
    """Read the fields of `Device` that a table with keys of a device file states."""
    stated = device_file.from_table(document, source)
    fields_by_key = {key.name: key.field for key in KEYS}
    return {
        name: getattr(stated, name) for name in (fields_by_key.get(key, key) for key in document)
    }


def calibrate_mean_bias(bench: Bench) -> float:
    """Measure a gyro's mean bias, rad/s, as its maker does: the mean of the map fitted to eight
    positions of the circumference, 100 s each, in a power-on of its own."""
    power_ons = full_circumference.make_power_ons(bench, full_circumference.SHORTEST, 1, segments=1)
    calibration = bench.campaign(bench.log_all(power_ons))
    return full_circumference.measure_mean_bias(calibration)


def with_start_up(device: Device) -> Device:
    """Return a device that starts up from power-on.

    Its initial vibration is that of the bench's start-up test, unless the device states it.
    """
    return replace(device, model={**START, **device.model})


@dataclass(frozen=True)
class GyroOutput:
    """Output of one gyro from power-on.

    Attributes:
        rotation: (n,) increments, rad.
        pattern_angle: (n,) at the end of each interval, rad.
        valid: (n,) the gyro's own validity flag at that time.
        ready: (n,) whether the output is valid and the amplitude within `AMPLITUDE_TOLERANCE`.
    """

    rotation: Array
    pattern_angle: Array
    valid: Mask
    ready: Mask


def simulate_gyro(bench: Bench, rotation: Array, force: Array, interval: float) -> GyroOutput:
    """Switch a gyro on and simulate it on a motion; the same bench gives the same noise.

    The error of the detected angle when it is switched on is no rotation, and is left out.

    rotation: (n,) true rotation about the input axis in each interval, rad; force: (n, 3) mean
    specific force along the axes of the case, m/s^2; the third axis is the input axis; interval: s.
    """
    (output,) = simulate_together([bench], rotation[:, None], [force], interval)
    return output


def simulate_together(
    benches: Sequence[Bench],
    rotation: Array,
    forces: Sequence[Array],
    interval: float,
    commands: Sequence[Mapping[str, Array]] | None = None,
) -> list[GyroOutput]:
    """Switch several gyros on at the same time and simulate each on its motion: `simulate_gyro` of
    each, sooner.

    rotation: (n, gyros), rad; forces: (n, 3) of each gyro, m/s^2; commands: inputs of each gyro
    that are constant over an interval, (n,) by the FMU's names, SI.
    """
    held = commands or [{}] * len(benches)
    moving = []
    for rate, force in zip(rotation.T / interval, forces, strict=True):
        inputs = {"angularRate": rate}
        inputs |= {f"acceleration{axis}": force[:, i] for i, axis in enumerate("XYZ")}
        moving.append({name: values[:, None] for name, values in inputs.items()})
    names = ["gyroAngle", "patternAngle", "valid", "amplitude"]
    with ExitStack() as stack:
        gyros = [stack.enter_context(bench.power_on(FLIGHT)) for bench in benches]
        starts = [gyro.read("gyroAngle") for gyro in gyros]
        recorded = record_together(gyros, moving, held, interval, names)
    return [
        _read_output(bench, start, ends)
        for bench, start, (ends, _) in zip(benches, starts, recorded, strict=True)
    ]


def _read_output(bench: Bench, start: float, ends: Array) -> GyroOutput:
    angle, pattern, valid, amplitude = ends.T
    grown = np.abs(amplitude / bench.device.amplitude - 1) <= AMPLITUDE_TOLERANCE
    is_valid = valid == 1
    return GyroOutput(np.diff(angle, prepend=start), pattern.copy(), is_valid, is_valid & grown)


def resolve_force_in_case(truth: Increments, input_axis: Array) -> Array:
    """Return the mean specific force (n, 3), m/s^2, along the axes of a gyro's case
    (`case_axes`)."""
    return np.asarray(truth.velocity @ case_axes(input_axis).T / truth.interval)


def case_axes(input_axis: Array) -> Array:
    """Return the axes (3, 3) of a gyro's case in body axes, one a row; z is the input axis.

    The pattern angle is 0 at x. It is the projection of forward, right or down, whichever is
    farthest from the input axis (the first of them if several are).
    """
    nearest = np.eye(3)[np.argmin(np.abs(input_axis))]
    across = nearest - (nearest @ input_axis) * input_axis
    x = across / np.linalg.norm(across)
    return np.stack([x, np.cross(input_axis, x), input_axis])


def _quantization_step(device: Device) -> float:
    """Return the quantization step with the variance of angle white noise and quantization."""
    return float(np.hypot(device.quantization_step, np.sqrt(12) * device.angle_white_noise))


def _rms(values: Sequence[float]) -> float:
    return float(np.sqrt(np.mean(np.square(values))))
