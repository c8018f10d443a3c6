"""The files `closed.mo` and `closed.fmu` of a diagnosis."""

from pathlib import Path

from pyhrg.device.device import Device
from pyhrg.gap.closing.equation.closed_class import write_class
from pyhrg.gap.closing.equation.closed_fmu import FMU_FILE, MODEL_FILE, build_closed_fmu
from pyhrg.gap.findings.diagnosis import Cause, Diagnosis

CLOSED_FILES = (MODEL_FILE, FMU_FILE)
"""Names of the files that are written."""
NO_CHANGE = "No cause and no term was found: this is the gyro as the campaign states it."
BENCH = (
    "Causes of the families bench and record lie outside the gyro and are not part of this class."
)


def write_closed_files(device: Device, diagnosis: Diagnosis, folder: Path) -> None:
    """Write the identified device with the diagnosis's terms as a Modelica class and as an FMU into
    a folder that exists."""
    title = f"Identified gyro {diagnosis.device}"
    text = write_class(device, diagnosis.terms, title, describe_changes(diagnosis))
    (folder / MODEL_FILE).write_text(text, encoding="utf-8")
    (folder / FMU_FILE).write_bytes(build_closed_fmu(text).read_bytes())


def describe_changes(diagnosis: Diagnosis) -> list[str]:
    """A sentence on each cause that the class holds, and one on what it leaves out."""
    notes = [_describe_cause(cause) for cause in diagnosis.causes]
    if any(cause.family in ("bench", "record") for cause in diagnosis.causes):
        notes.append(BENCH)
    return notes or ([] if diagnosis.terms else [NO_CHANGE])


def _describe_cause(cause: Cause) -> str:
    values = ", ".join(
        f"{name} = {value:.6g} (95 %: {cause.interval_95[name][0]:.6g} to "
        f"{cause.interval_95[name][1]:.6g})"
        for name, value in cause.parameters.items()
    )
    return f"Cause {cause.effect}: {values}; posterior probability {cause.probability:.3f}."
