"""A gyro: its parameters, the maps that its electronics take out, its site and its limits."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING

from pyhrg.common.errors import describe_briefly
from pyhrg.common.site import Site
from pyhrg.device.fmu_parameters import compute_fmu_values
from pyhrg.device.parameters.loops_and_bench import LoopAndBenchParameters

if TYPE_CHECKING:
    import numpy as np


@dataclass(frozen=True)
class AngleMap:
    """Fourier coefficients over the pattern angle th: mean + cos2 cos 2th + sin2 sin 2th + ..."""

    mean: float = 0.0
    cos2: float = 0.0
    sin2: float = 0.0
    cos4: float = 0.0
    sin4: float = 0.0
    cos8: float = 0.0
    sin8: float = 0.0


@dataclass(frozen=True)
class Device(LoopAndBenchParameters):
    """One gyro; by default an ideal one. SI; angles are physical pattern angles, ratios are
    electrical (modal axes), temperatures count from `reference_temperature`.

    `pyhrg.device.parameters` declares the parameters that are one number each. Symbols in brackets
    are those of `pyhrg.theory`. `pyhrg.device.device_file` reads and writes a device.
    """

    name: str = ""
    """Name in reports."""

    bias_map: AngleMap = field(default_factory=AngleMap)
    """Calibrated output bias that the electronics take out, rad/s."""
    scale_factor_map: AngleMap = field(default_factory=AngleMap)
    """Calibrated error of the detected pattern angle that the electronics take out, rad. Its mean
    has no effect."""

    turn_on_scatter: Mapping[str, float] = field(default_factory=dict, hash=False)
    """Standard deviations of the FMU's parameters from one power-on to the next (turn-on to turn-on
    repeatability), by the FMU's names, SI; normal, independent."""

    model: Mapping[str, float] = field(default_factory=dict, hash=False)
    """Values of other parameters of the FMU, by the FMU's names, SI."""
    site: Site = field(default_factory=Site)
    """Laboratory where the gyro is tested."""
    specification: Mapping[str, float] = field(default_factory=dict, hash=False)
    """Limits of a bench's findings, by name with unit, in that unit."""

    __repr__ = describe_briefly

    def fmu_values(self) -> dict[str, float]:
        """Values of all FMU parameters that a device has fields for, by the FMU's names, SI."""
        return {
            **compute_fmu_values(self),
            **{f"controller.biasMap.{name}": v for name, v in vars(self.bias_map).items()},
            **{
                f"controller.scaleFactorMap.{name}": v
                for name, v in vars(self.scale_factor_map).items()
                if name != "mean"
            },
        }

    def fmu_parameters(self) -> dict[str, float]:
        """Values of the FMU's parameters that differ from its defaults, by the FMU's names, SI.
        Values of `model` come last. The start angle is not among them: it is set at power-on.
        """
        ideal = Device().fmu_values()
        values = {name: v for name, v in self.fmu_values().items() if v != ideal[name]}
        return {**values, **self.model}

    def draw_turn_on(self, generator: "np.random.Generator") -> dict[str, float]:
        """Draw the FMU's parameters at one power-on: `fmu_parameters` with independent normal
        scatter."""
        stated = {**self.fmu_values(), **self.model}
        drawn = {
            name: stated[name] + generator.normal(0.0, deviation)
            for name, deviation in self.turn_on_scatter.items()
        }
        return {**self.fmu_parameters(), **drawn}

    def without_anisotropy(self) -> "Device":
        """This gyro without any anisotropy of resonator and electrodes; its noise stays."""
        return replace(
            self,
            damping_anisotropy=0.0,
            frequency_split=0.0,
            pickoff_gain_mismatch=0.0,
            pickoff_nonorthogonality=0.0,
            drive_gain_mismatch=0.0,
            drive_nonorthogonality=0.0,
            pump_anisotropy=0.0,
        )

    def without_noise(self) -> "Device":
        """This gyro without noise. Its quantization step and its scatter from power-on to power-on
        stay.
        """
        return replace(
            self,
            angle_random_walk=0.0,
            rate_random_walk=0.0,
            bias_instability=0.0,
            damping_anisotropy_flicker=0.0,
            pickoff_gain_flicker=0.0,
            phase_flicker=0.0,
            angle_white_noise=0.0,
            model={name: v for name, v in self.model.items() if not name.startswith("noise.")},
        )

    def another(self, generator: "np.random.Generator") -> "Device":
        """A gyro of the same kind: the same magnitudes, axes and power-on angle of its own.

        A gain mismatch turned by 22.5 deg of pattern is a non-orthogonality: each pair (gain
        mismatch, non-orthogonality) is turned as a vector.
        """
        turn = generator.uniform(0.0, 2 * math.pi, size=4)
        pickoff = _rotate(self.pickoff_gain_mismatch, self.pickoff_nonorthogonality, turn[0])
        drive = _rotate(self.drive_gain_mismatch, self.drive_nonorthogonality, turn[1])
        return replace(
            self,
            damping_axis=turn[2] / 4,
            stiffness_axis=turn[3] / 4,
            pickoff_gain_mismatch=pickoff[0],
            pickoff_nonorthogonality=pickoff[1],
            drive_gain_mismatch=drive[0],
            drive_nonorthogonality=drive[1],
            power_on_angle=generator.uniform(0.0, math.pi / 2),
        )


FMU_NAMES = frozenset({*Device().fmu_values(), "seed", "startAngle"})
"""Parameters of the FMU that a field of a device or a power-on sets: not for `Device.model`."""


def _rotate(gain: float, nonorthogonality: float, angle: float) -> tuple[float, float]:
    c, s = math.cos(angle), math.sin(angle)
    return c * gain - s * nonorthogonality, s * gain + c * nonorthogonality
