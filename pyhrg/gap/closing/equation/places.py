"""Where in the gyro a candidate term acts, and the unit of its parameters."""

from dataclasses import dataclass

from pyhrg.common.units import ARCSEC, DEG_PER_H, HZ
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.findings.term import Location


@dataclass(frozen=True)
class Acting:
    """How a term acts in the written class.

    place: of the campaign format.
    variable: of the class, to which the term adds.
    type: Modelica type of the parameters.
    unit: suffix of the parameters' names; factor: SI per unit.
    """

    place: Location
    variable: str
    type: str
    unit: str
    factor: float


BIAS = Acting("bias", "addedRate", "AngularRate", "deg_h", DEG_PER_H)
READOUT = Acting("readout", "addedAngle", "Angle", "arcsec", ARCSEC)
BY_CHANNEL = {
    "amplitude": Acting("electronics", "addedAmplitude", "Displacement", "amplitude", 1.0),
    "amplitude_force": Acting("damping", "addedAmplitudeForce", "Rate", "per_s", 1.0),
    "quadrature_force": Acting("stiffness", "addedQuadratureForce", "Force", "per_s", 1.0),
    "frequency_offset": Acting("stiffness", "addedFrequency", "AngularFrequency", "Hz", HZ),
}
"""How a term of a channel other than the output angle acts."""


def find_acting(term: CandidateTerm) -> Acting:
    """How a term acts: by its channel, and in the output angle by whether it is a bias. What
    follows the turntable belongs to the bench."""
    if term.channel != "gyro_angle":
        return BY_CHANNEL[term.channel]
    usual = BIAS if term.function.startswith("bias: ") else READOUT
    if term.coordinate != "table_angle":
        return usual
    return Acting("bench", usual.variable, usual.type, usual.unit, usual.factor)
