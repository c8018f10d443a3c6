"""The part of a diagnosis's folder that the position error depends on."""

import math
from dataclasses import dataclass
from pathlib import Path

from pyhrg.common.units import DEG_PER_H
from pyhrg.device import device_file
from pyhrg.device.device import Device
from pyhrg.gap.findings.diagnosis import GapFigure
from pyhrg.gap.findings.diagnosis_reader import read_diagnosis


@dataclass(frozen=True)
class HeldOutResidual:
    """Residual rate over 100 s on held-out tests, after closing, rad/s.

    Attributes:
        rms: rms of the residual rate.
        floor_low, floor_high: 95 % interval of the rms that noise alone would leave.
    """

    rms: float
    floor_low: float
    floor_high: float

    @property
    def excess(self) -> float:
        """Largest rms of the part that is not noise, rad/s: the rms less the lowest noise floor,
        in quadrature."""
        return math.sqrt(max(self.rms**2 - self.floor_low**2, 0.0))


@dataclass(frozen=True)
class DiagnosedGyro:
    """A gyro before and after the diagnosis.

    Attributes:
        device: name of the gyro.
        verdict: the diagnosis's verdict.
        equivalents: effects that are confounded with the causes in the campaign's tests.
        nominal, identified: the device without and with the causes.
        residual: residual rate of held-out tests; None without such tests.
    """

    device: str
    verdict: str
    equivalents: tuple[str, ...]
    nominal: Device
    identified: Device
    residual: HeldOutResidual | None

    @property
    def is_changed(self) -> bool:
        """Whether the two devices differ in more than their noise."""
        return self.nominal.without_noise() != self.identified.without_noise()


def read_diagnosed_gyro(folder: Path) -> DiagnosedGyro:
    """Read a folder that `hrg gap diagnose` wrote."""
    diagnosis = read_diagnosis(folder / "diagnosis.json")
    return DiagnosedGyro(
        diagnosis.device,
        diagnosis.verdict,
        tuple(name for cause in diagnosis.causes for name in cause.equivalents),
        device_file.read(folder / "before.toml"),
        device_file.read(folder / "after.toml"),
        _convert_residual(diagnosis.gap.holdout_rate_deg_h),
    )


def _convert_residual(rate: GapFigure | None) -> HeldOutResidual | None:
    if rate is None:
        return None
    return HeldOutResidual(*(value * DEG_PER_H for value in (rate.after, *rate.floor_95)))
