"""Where in the gyro a candidate term acts, and the unit of its parameters."""

from dataclasses import dataclass, replace

from pyhrg.common.units import ARCSEC, DEG_PER_H, HZ
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.findings.term import Location


@dataclass(frozen=True)
class Acting:
    """How a term acts in the written class.

    place: of the campaign format.
    stem: begin of the parameters' names.
    type: Modelica type of the parameters.
    unit: suffix of the parameters' names, empty for a ratio; factor: SI per unit.
    responses: variables of the class to which the term adds, each with the expression that it is
        multiplied by there.
    """

    place: Location
    stem: str
    type: str
    unit: str
    factor: float
    responses: tuple[tuple[str, str], ...]


GROWTH = "driveOn*gyro.amplitudeForce"
"""Growth rate that the drive gives, in the written class."""
BIAS = Acting("bias", "bias", "AngularVelocity", "deg_h", DEG_PER_H, (("addedRate", ""),))
READOUT = Acting("readout", "readout", "Angle", "arcsec", ARCSEC, (("addedAngle", ""),))
BY_PREFIX = {
    "bias": BIAS,
    "angle": READOUT,
    "output alone": READOUT,
    "pick-off": Acting(
        "pickoff", "pickoff", "Angle", "arcsec", ARCSEC,
        (("addedAngle", ""), ("addedRate", GROWTH)),
    ),
    "drive": Acting("drive", "drive", "Angle", "arcsec", ARCSEC, (("addedRate", GROWTH),)),
    "drive gain": Acting(
        "drive", "drive_gain", "DimensionlessRatio", "", 1.0,
        (
            ("addedRate", "-virtualRotation"),
            ("addedAmplitudeForce", "-gyro.amplitudeForce"),
            ("addedQuadratureForce", "-gyro.quadratureForce"),
        ),
    ),
}  # fmt: skip
"""How a term acts whose function begins with this word and a colon."""
DAMPING = Acting(
    "damping", "damping", "DampingCoefficient", "per_s", 1.0, (("addedAmplitudeForce", ""),)
)
BY_CHANNEL = {
    "amplitude": Acting(
        "electronics",
        "electronics",
        "RelativeDisplacement",
        "amplitude",
        1.0,
        (("addedAmplitude", ""),),
    ),
    "amplitude_force": DAMPING,
    "quadrature_force": Acting(
        "stiffness", "stiffness", "RelativeForce", "per_s", 1.0, (("addedQuadratureForce", ""),)
    ),
    "frequency_offset": Acting(
        "stiffness", "frequency", "AngularFrequency", "Hz", HZ, (("addedFrequency", ""),)
    ),
}
"""How another term of a channel other than the output angle acts."""


def find_acting(term: CandidateTerm) -> Acting:
    """How a term acts: by the word before its function, or by its channel. An error of the angle
    that follows the turntable belongs to the bench; damping that follows the amplitude also acts
    while the drive is off."""
    prefix, colon, _ = term.function.partition(": ")
    acting = BY_PREFIX[prefix] if colon else BY_CHANNEL[term.channel]
    if acting is DAMPING and term.coordinate == "amplitude":
        return replace(acting, responses=(*acting.responses, ("freeDamping", "")))
    if acting is READOUT and term.coordinate == "table_angle":
        return replace(acting, place="bench")
    return acting
