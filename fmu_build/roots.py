"""The models that become FMUs."""

from dataclasses import dataclass
from pathlib import Path

METHODS = {
    "runge_kutta_4": "the classical Runge-Kutta method of fourth order",
    "dormand_prince_8": "the method of Dormand and Prince of eighth order, at fixed steps",
    "midpoint": "the explicit midpoint method of second order",
}
"""Integrators: the header `c/NAME.h` and the function in it that makes a step; in words."""


@dataclass(frozen=True)
class Root:
    """A Modelica model to be exported.

    Attributes:
        identifier: name of the FMU and of its libraries.
        integrator: one of `METHODS`.
        step: default communication step, s.
        class_file: a user's file that holds the model, where no library does.
    """

    identifier: str
    model: str
    description: str
    integrator: str
    step: str
    class_file: Path | None = None

    @property
    def library(self) -> str:
        """Name of the library that holds the model."""
        return self.model.partition(".")[0]


ROOTS = {
    root.identifier: root
    for root in (
        Root(
            "HRG",
            "HRG.Gyroscopes.HRGEnvelope",
            "Whole-angle hemispherical resonator gyro: envelope, electronics at 1 kHz",
            "runge_kutta_4",
            "0.01",
        ),
        Root(
            "HRGCarrier",
            "HRG.Gyroscopes.HRGCarrier",
            "Whole-angle hemispherical resonator gyro at its carrier: converters, demodulation",
            "dormand_prince_8",
            "0.01",
        ),
        Root(
            "HRGSlow",
            "HRG.Gyroscopes.HRGSlow",
            "Whole-angle hemispherical resonator gyro, loops quasi-steady: for hours and thousands",
            "midpoint",
            "0.1",
        ),
    )
}

PARTS = {
    root.identifier: root
    for root in (
        Root(
            "HRGSelfCorrecting",
            "HRG.Gyroscopes.HRGSelfCorrecting",
            "Whole-angle hemispherical resonator gyro that corrects the change of its bias map",
            "runge_kutta_4",
            "0.01",
        ),
        Root(
            "HRGPlant",
            "HRG.Gyroscopes.HRGPlant",
            "Resonator, pick-offs and drives of a hemispherical resonator gyro",
            "runge_kutta_4",
            "0.001",
        ),
        Root(
            "HRGElectronics",
            "HRG.Gyroscopes.HRGElectronics",
            "Control electronics of a hemispherical resonator gyro at 1 kHz",
            "runge_kutta_4",
            "0.001",
        ),
        Root(
            "Navigator",
            "Strapdown.Navigator",
            "Strapdown navigator on WGS-84",
            "runge_kutta_4",
            "0.01",
        ),
        Root(
            "Accelerometers",
            "Strapdown.Accelerometers",
            "Three accelerometers with stated errors",
            "runge_kutta_4",
            "0.01",
        ),
    )
}
"""The gyro with electronics that correct its map, its parts, and those of a system that are no
gyro."""
