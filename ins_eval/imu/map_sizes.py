"""Typical sizes of a gyro's errors over its pattern angle, for users who know the kind of gyro but
not its axes."""

import math
from collections.abc import Iterable
from dataclasses import dataclass, replace

from pyhrg.bench.bias.position import full_circumference
from pyhrg.bench.readings.segments import SEGMENT
from pyhrg.device.device import Device
from pyhrg.theory import closed_forms as theory

CALIBRATION_TIME = full_circumference.SHORTEST.positions * SEGMENT
"""Time over which the maker averages the mean bias (`gyros.calibrate_mean_bias`), s."""
CUBIC_SHARE = 0.75
"""Relative gain error of a cubic pick-off, per b a^2."""


@dataclass(frozen=True)
class MapSizes:
    """Standard deviations of a gyro's constants from unit to unit, the same for cosine and sine.

    Attributes:
        mean: mean of the bias, rad/s.
        bias: each coefficient of the bias's harmonics that resonator and drives make, rad/s.
        pick_off: each coefficient of the harmonics of the pick-offs' relative gain. They shift the
            detected angle; the amplitude force then acts at a wrong angle, which adds a bias.
        scale_factor: relative scale-factor error.
        decay_time: decay time over the share of the amplitude force that electrodes give, s;
            infinite where parametric drive gives all.
    """

    mean: float
    bias: dict[int, float]
    pick_off: dict[int, float]
    scale_factor: float
    decay_time: float
    bryan_factor: float

    @property
    def rest_bias(self) -> float:
        """Standard deviation of the bias at rest, at any pattern angle, rad/s."""
        time = self.bryan_factor * self.decay_time
        by_pick_off = [size / (harmonic * time) for harmonic, size in self.pick_off.items()]
        return math.hypot(self.mean, *self.bias.values(), *by_pick_off)


def size_maps(device: Device, own_axes: bool, calibrated: bool) -> MapSizes:
    """Sizes of a device's maps less the maps that its electronics take out, to first order.

    own_axes: whether the device states the magnitudes of its imperfections alone, and each unit has
    its own axes (`Device.another`); calibrated: whether the mean bias is measured and subtracted.
    """
    scatter = _read_scatter(device)
    force = 1 / (4 * device.bryan_factor * _find_driven_decay_time(device))
    taken, detected = device.bias_map, device.scale_factor_map
    fourth = [*_list_bias_phasors(device), -complex(taken.cos4, taken.sin4)]
    gain = [
        complex(device.pickoff_gain_mismatch, device.pickoff_nonorthogonality),
        4 * complex(detected.sin4, -detected.cos4),
    ]
    offset = complex(device.demodulation_offset, device.demodulation_offset_y)
    cubic = CUBIC_SHARE * device.pickoff_cubic * device.amplitude**2
    bias = {
        2: abs(complex(taken.cos2, taken.sin2)),
        4: math.hypot(_add(fourth, own_axes), force * abs(scatter["drive"])),
        8: abs(complex(taken.cos8, taken.sin8)),
    }
    pick_off = {
        2: abs(offset + 2 * complex(detected.sin2, -detected.cos2)),
        4: math.hypot(_add(gain, own_axes), abs(scatter["pickOff"])),
        8: abs(cubic + 8 * complex(detected.sin8, -detected.cos8)),
    }
    return MapSizes(
        mean=_size_mean(device, own_axes, calibrated),
        bias={harmonic: size / math.sqrt(2) for harmonic, size in bias.items()},
        pick_off={harmonic: size / math.sqrt(2) for harmonic, size in pick_off.items()},
        scale_factor=abs(
            theory.hold_scale_factor_error(
                device.control_period,
                device.loop_delay + device.filter_delay,
                _find_driven_decay_time(device),
            )
        ),
        decay_time=_find_driven_decay_time(device),
        bryan_factor=device.bryan_factor,
    )


def _find_driven_decay_time(device: Device) -> float:
    driven = 1 - device.parametric_share
    return device.decay_time / driven if driven else math.inf


def _list_bias_phasors(device: Device) -> list[complex]:
    """Fourth harmonics of the bias by damping, split, drives and pump, as of
    `static_bias_phasor`."""
    alike = device.without_anisotropy()
    names = (
        ("damping_anisotropy",),
        ("frequency_split",),
        ("drive_gain_mismatch", "drive_nonorthogonality"),
        ("pump_anisotropy",),
    )
    return [
        theory.static_bias_phasor(replace(alike, **{name: getattr(device, name) for name in each}))
        for each in names
    ]


def _add(phasors: Iterable[complex], own_axes: bool) -> float:
    """Size of a sum, or its rms where each part has a direction of its own."""
    return math.hypot(*map(abs, phasors)) if own_axes else abs(sum(phasors))


def _size_mean(device: Device, own_axes: bool, calibrated: bool) -> float:
    """Standard deviation of the mean bias, rad/s; calibration leaves its noise and the scatter."""
    force = 1 / (4 * device.bryan_factor * _find_driven_decay_time(device))
    scattered = force * math.hypot(*(part.imag for part in _read_scatter(device).values()))
    if calibrated:
        noise = device.angle_random_walk / math.sqrt(CALIBRATION_TIME)
        return math.hypot(noise, math.sqrt(2) * scattered)
    mean = theory.mean_bias(device)
    if own_axes:
        pickoff = (device.pickoff_gain_mismatch, device.pickoff_nonorthogonality)
        drive = (device.drive_gain_mismatch, device.drive_nonorthogonality)
        mean = force * math.hypot(*pickoff, *drive) / math.sqrt(2)
    return math.hypot(mean, scattered, 2 * force * device.drive_frame_rotation)


def _read_scatter(device: Device) -> dict[str, complex]:
    """Turn-on to turn-on scatter of gain mismatch and non-orthogonality, by pick-offs and
    drives."""
    scatter = device.turn_on_scatter
    return {
        part: complex(
            scatter.get(f"{part}.gainMismatch", 0.0), scatter.get(f"{part}.nonOrthogonality", 0.0)
        )
        for part in ("pickOff", "drive")
    }
