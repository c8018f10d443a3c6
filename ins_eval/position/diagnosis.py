"""The folder of a diagnosis, as far as metres need it."""

import json
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pyhrg.common.errors import HrgError
from pyhrg.common.units import DEG_PER_H
from pyhrg.device import device_file
from pyhrg.device.device import Device

FILES = ("diagnosis.json", "before.toml", "after.toml")


class DiagnosisError(HrgError):
    """The folder holds no diagnosis; the message names file, key, found and expected."""


@dataclass(frozen=True)
class Rest:
    """rms: that is left; least, most: that noise alone leaves (95 %); rad/s."""

    rms: float
    least: float
    most: float

    @property
    def beyond_noise(self) -> float:
        """Rms of what may be left beyond noise at most, rad/s."""
        return math.sqrt(max(self.rms**2 - self.least**2, 0.0))


@dataclass(frozen=True)
class Diagnosis:
    """equivalents: effects that the campaign could not tell from what was found;
    before, after: the gyro as it was believed and with what was found;
    rest: of the rate over 100 s on held-out tests; None without such tests."""

    device: str
    verdict: str
    equivalents: tuple[str, ...]
    before: Device
    after: Device
    rest: Rest | None

    @property
    def moved(self) -> bool:
        """Whether anything was found that moves a gyro without noise."""
        return self.before.without_noise() != self.after.without_noise()


def read(folder: Path) -> Diagnosis:
    """Read a folder that `hrg gap diagnose` wrote.

    Raises:
        DiagnosisError: a file is missing, or none of its kind.
        DeviceError: a device file is wrong.
    """
    path = folder / FILES[0]
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError) as error:
        raise DiagnosisError(f"{path}: can't be read: {error}") from error
    try:
        return Diagnosis(
            str(document["device"]),
            str(document["verdict"]),
            tuple(str(name) for cause in document["causes"] for name in cause["equivalents"]),
            device_file.read(folder / FILES[1]),
            device_file.read(folder / FILES[2]),
            _rest(document["gap"]),
        )
    except (KeyError, TypeError, ValueError) as error:
        raise DiagnosisError(f"{path}: {error!r}; expected a diagnosis") from error


def _rest(gap: dict[str, Any]) -> Rest | None:
    if "rate_deg_h" not in gap["after"]["holdout"]:
        return None
    least, most = gap["floor_95"]["holdout"]["rate_deg_h"]
    rms = gap["after"]["holdout"]["rate_deg_h"]
    return Rest(*(float(value) * DEG_PER_H for value in (rms, least, most)))
