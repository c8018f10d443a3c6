"""Where in the gyro a candidate term acts, and the unit of its parameters."""

import re
from dataclasses import dataclass, replace
from typing import NamedTuple

from pyhrg.common.units import ARCSEC, DEG_PER_H, HZ
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.electrode_terms import LINEAR_HARMONICS
from pyhrg.gap.findings.term import Location


class Response(NamedTuple):
    """What a term adds to a variable of the written class.

    factor: expression by which the term is multiplied; empty for 1.
    is_turned: whether the term counts a quarter of its harmonic's period ahead.
    """

    variable: str
    factor: str = ""
    is_turned: bool = False


@dataclass(frozen=True)
class Acting:
    """How a term acts in the written class.

    place: of the campaign format.
    stem: begin of the parameters' names.
    type: Modelica type of the parameters.
    unit: suffix of the parameters' names, empty for a ratio; factor: SI per unit.
    responses: what the term adds to each variable of the class.
    """

    place: Location
    stem: str
    type: str
    unit: str
    factor: float
    responses: tuple[Response, ...]


GROWTH = "driveOn*gyro.amplitudeForce"
"""Growth rate that the drive gives, in the written class."""
GAIN = "gyro.controller.readout.bryanFactor"
"""Angular gain, in the written class."""
LEAK = f"-gyro.quadratureForce/(2*{GAIN})"
"""Rate that an error of the phase makes of the quadrature force, per radian, in it."""
MISDIRECTED = (
    Response("addedRate", GROWTH),
    Response("addedAmplitudeForce", f"-4*{GAIN}^2*virtualRotation"),
    Response("addedFrequency", f"-2*{GAIN}*gyro.quadratureForce"),
)
"""What forces that point beside the pattern do."""
BIAS = Acting("bias", "bias", "AngularVelocity", "deg_h", DEG_PER_H, (Response("addedRate"),))
READOUT = Acting("readout", "readout", "Angle", "arcsec", ARCSEC, (Response("addedAngle"),))
BY_PREFIX = {
    "bias": BIAS,
    "angle": READOUT,
    "output alone": READOUT,
    "pick-off": Acting(
        "pickoff", "pickoff", "Angle", "arcsec", ARCSEC,
        (Response("addedAngle"), *MISDIRECTED),
    ),
    "drive": Acting("drive", "drive", "Angle", "arcsec", ARCSEC, MISDIRECTED),
    "phase": Acting(
        "electronics", "phase", "Angle", "rad", 1.0,
        (
            Response("addedRate", LEAK),
            Response("addedQuadratureForce", f"2*{GAIN}*virtualRotation"),
            Response("addedFrequency", GROWTH),
        ),
    ),
    "drive gain": Acting(
        "drive", "drive_gain", "DimensionlessRatio", "", 1.0,
        (
            Response("addedRate", "-virtualRotation"),
            Response("addedAmplitudeForce", "-gyro.amplitudeForce"),
            Response("addedQuadratureForce", "-gyro.quadratureForce"),
        ),
    ),
}  # fmt: skip
"""How a term with this prefix acts."""
DAMPING = Acting(
    "damping", "damping", "DampingCoefficient", "per_s", 1.0, (Response("addedAmplitudeForce"),)
)
BY_CHANNEL = {
    "amplitude": Acting(
        "electronics",
        "electronics",
        "RelativeDisplacement",
        "amplitude",
        1.0,
        (Response("addedAmplitude"),),
    ),
    "amplitude_force": DAMPING,
    "quadrature_force": Acting(
        "stiffness", "stiffness", "RelativeForce", "per_s", 1.0, (Response("addedQuadratureForce"),)
    ),
    "frequency_offset": Acting(
        "stiffness", "frequency", "AngularFrequency", "Hz", HZ, (Response("addedFrequency"),)
    ),
}
"""How a term without a prefix acts, by its channel."""


MISREAD_AMPLITUDE = (
    Response("addedMisreading", f"2*{GAIN}", is_turned=True),
    Response("addedRate", f"-2*{GAIN}*virtualRotation", is_turned=True),
)
"""What a linear error of the pick-offs does beside its error of the angle."""


def find_acting(term: CandidateTerm) -> Acting:
    """How a term acts: by its prefix, or by its channel. An error of the angle
    that follows the turntable or its load belongs to the bench; damping that follows the amplitude
    also acts while the drive is off, and an anisotropy of damping turns the pattern
    (docs/methods/effects.md, Eqs. 5d and 5e)."""
    acting = BY_PREFIX[term.prefix] if term.prefix else BY_CHANNEL[term.channel]
    more: list[Response] = []
    product = re.search(r"harmonic (\d+) .*, times", term.function)
    if term.prefix == "pick-off" and product and int(product[1]) in LINEAR_HARMONICS:
        more += MISREAD_AMPLITUDE
    if acting is DAMPING and product and term.coordinate != "wave_angle":
        more.append(Response("addedRate", f"1/(2*{GAIN})", is_turned=True))
    if acting is DAMPING and term.coordinate == "amplitude":
        more.append(Response("freeDamping"))
    if term.is_encoder_error:
        acting = replace(acting, place="bench")
    return replace(acting, responses=(*acting.responses, *more)) if more else acting
