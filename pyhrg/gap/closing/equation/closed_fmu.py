"""The FMU of the identified gyro with its terms: built from `closed.mo`."""

import tempfile
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from fmu_build.bundle import build_fmu
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.fmu.gyro import Gyro
from pyhrg.gap.closing.equation.class_text import CLASS, write_class
from pyhrg.gap.closing.equation.proposal import as_candidate, list_coefficients
from pyhrg.gap.findings.term import Term

MODEL_FILE, FMU_FILE = f"{CLASS}.mo", f"{CLASS}.fmu"


class ClosedFmu(GyroFmu):
    """The built FMU as a replay takes it: parameters of the device by the names of `HRG`, noise and
    quantization off, and some terms off.

    off: terms whose coefficients are set to zero.
    """

    def __init__(self, path: Path, device: Device, off: Iterable[Term] = ()) -> None:
        super().__init__(path)
        silent = ("noise.", "controller.readout.quantum")
        self._overrides = {
            f"gyro.{n}": 0.0 for n in device.fmu_parameters() if n.startswith(silent)
        }
        for term in off:
            names = (c.variable for c in list_coefficients(as_candidate(term)))
            self._overrides |= dict.fromkeys(names, 0.0)

    @property
    def is_sampled(self) -> bool:
        """The inner gyro is `HRG`."""
        return True

    def power_on(self, parameters: Mapping[str, float], seed: int, start_angle: float) -> Gyro:
        """Start the gyro within the class, with parameters by the names of `HRG`, SI."""
        own = {f"gyro.{n}" if "." in n else n: v for n, v in parameters.items()}
        return super().power_on({**self._overrides, **own}, seed, start_angle)


def build_closed_fmu(text: str) -> Path:
    """Path of the FMU of a class's text: from the user's cache, built if it isn't there."""
    with tempfile.TemporaryDirectory(prefix="hrg-closed-") as folder:
        file = Path(folder) / MODEL_FILE
        file.write_text(text, encoding="utf-8")
        return build_fmu(class_file=file)


def load_closed_fmu(device: Device, terms: Sequence[Term], off: Sequence[Term] = ()) -> ClosedFmu:
    """The FMU of a device with terms, ready for `replay_sampled`, some of the terms off."""
    return ClosedFmu(build_closed_fmu(write_class(device, terms, "Verified gyro", ())), device, off)
