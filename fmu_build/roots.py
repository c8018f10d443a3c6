"""The models that become FMUs."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Root:
    """A Modelica model to be exported.

    identifier: name of the FMU and of its libraries.
    integrator: header `c/INTEGRATOR.h` and the function in it that makes a step.
    step: default communication step, s.
    """

    identifier: str
    model: str
    description: str
    integrator: str
    step: str


ROOTS = {
    root.identifier: root
    for root in (
        Root(
            "HRG",
            "HRG.Gyroscopes.HRG",
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
