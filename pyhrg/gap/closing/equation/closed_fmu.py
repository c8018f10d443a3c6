"""The FMU of the identified gyro with its terms: built from `closed.mo`."""

import tempfile
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from fmu_build.bundle import build_fmu
from pyhrg.device.device import Device
from pyhrg.fmu import GyroFmu
from pyhrg.gap.closing.equation.closed_class import CLASS, write_class
from pyhrg.gap.closing.equation.proposal import list_written
from pyhrg.gap.findings.term import Term

MODEL_FILE, FMU_FILE = f"{CLASS}.mo", f"{CLASS}.fmu"


def build_closed_fmu(text: str) -> Path:
    """Path of the FMU of a class's text: from the user's cache, built if it isn't there."""
    with tempfile.TemporaryDirectory(prefix="hrg-closed-") as folder:
        file = Path(folder) / MODEL_FILE
        file.write_text(text, encoding="utf-8")
        return build_fmu(class_file=file)


def load_closed_fmu(device: Device, terms: Iterable[Term]) -> GyroFmu:
    """The FMU of a device with terms, which are off but for a device of `put_terms`. It is built
    without numbers, so that one build serves all sizes of the same terms."""
    plain = Device(amplitude=device.amplitude)
    shapes = sorted((_remove_numbers(term) for term in terms), key=lambda t: t.formula.modelica)
    return GyroFmu(build_closed_fmu(write_class(plain, shapes, "Terms without sizes", ())))


def put_terms(device: Device, terms: Iterable[Term], test: str = "") -> Device:
    """The device with the coefficients of terms, for an FMU that has these. Jumps act in the test
    in which they were found, and in no other one."""
    sizes = {
        c.variable: term.parameters[c.name] * c.factor * (c.basis.test in ("", test))
        for term in terms
        for c in list_written(term)
    }
    return replace(device, model={**device.model, **sizes})


def _remove_numbers(term: Term) -> Term:
    nothing, ends = dict.fromkeys(term.parameters, 0.0), dict.fromkeys(term.parameters, (0.0, 0.0))
    return replace(
        term,
        parameters=nothing,
        interval_95=ends,
        probability=0.0,
        discovery_probability=0.0,
        rivals={},
        shrink_percent=None,
    )
