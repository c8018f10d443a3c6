"""Known mechanisms next to a proposed term, with literature and the test that separates them."""

from typing import NamedTuple

from pyhrg.gap.findings.term import Term


class Mechanism(NamedTuple):
    """A mechanism of `HRG.UsersGuide.Mechanisms`, by its number there.

    name, source: in words; test: what shows this mechanism and not the others.
    """

    name: str
    number: int
    source: str
    test: str


XU = "Xu et al. (2024), doi:10.19306/j.cnki.2095-8110.2024.02.001"
LYNCH = "Lynch, 2nd St. Petersburg Int. Conf. on Gyroscopic Technology (1995)"
SENKAL = "Senkal and Shkel, Whole-Angle MEMS Gyroscopes (2020)"
PICKOFF_GAIN = "Actuators 14 (2025) 275"
DRIVE_CHAIN = "Sensors 24 (2024) 4328"
THERMAL = "Micromachines 16 (2025) 357"
PHASE = "Sci. Rep. (2025) s41598-025-86288-1"
_DAMPING = Mechanism("damping anisotropy", 1, LYNCH, "a ring-down: it acts with the drive off too")
_MOUNTING = Mechanism(
    "anchor loss of the mounting",
    26,
    SENKAL,
    "ring-downs before and after the gyro is mounted again",
)
_DRIVE_GAIN = Mechanism(
    "drive gain mismatch",
    3,
    DRIVE_CHAIN,
    "a commanded rotation: its error is in proportion to the command",
)
_DRIVE_AXES = Mechanism("drive non-orthogonality", 5, DRIVE_CHAIN, "a ring-down: it ends there")
_AUTHORITY = Mechanism(
    "authority of the drive", 30, DRIVE_CHAIN, "an amplitude sweep: it begins at a threshold"
)
_PICKOFF_GAIN = Mechanism(
    "pick-off gain mismatch",
    2,
    PICKOFF_GAIN,
    "a rate test both ways: the 4th harmonic of the angle",
)
_PICKOFF_AXES = Mechanism(
    "pick-off non-orthogonality",
    4,
    PICKOFF_GAIN,
    "a rate test both ways: the 4th harmonic, a quarter period later",
)
_OFFSET = Mechanism(
    "demodulation offset", 12, SENKAL, "an amplitude sweep: its angle falls with the amplitude"
)
_CUBIC = Mechanism(
    "pick-off cubic", 13, SENKAL, "an amplitude sweep: it grows with the square of the amplitude"
)
_OVER_TEMPERATURE = Mechanism(
    "gain, phase or anisotropy over temperature",
    24,
    THERMAL,
    "thermal ramps up and down, at two pattern angles",
)
_GRADIENT = Mechanism(
    "drive frame that turns with the temperature rate",
    24,
    THERMAL,
    "ramps up and down through one temperature: the sign changes",
)
_FORCE = Mechanism(
    "gap or axes under specific force",
    28,
    SENKAL,
    "a tumble, then a centrifuge: linear or quadratic",
)
_CHARGE = Mechanism(
    "charge of the electrodes", 25, SENKAL, "a step of the bias voltage at constant temperature"
)
_DUFFING = Mechanism("Duffing stiffness", 14, SENKAL, "a step of the quadrature at two amplitudes")
_AGEING = Mechanism("ageing or loss of the vacuum", 31, SENKAL, "ring-downs weeks apart")
_DELAY = Mechanism(
    "loop delay and hold",
    15,
    SENKAL,
    "rates both ways with another delay: in proportion to the rate alone",
)
_RANGE = Mechanism(
    "full scale, slew rate or authority",
    30,
    SENKAL,
    "rates up to the full range: it begins at a threshold",
)
_BRYAN = Mechanism("Bryan factor", 16, LYNCH, "rates both ways: in proportion to the rate alone")
_SPLIT = Mechanism(
    "frequency split", 7, PHASE, "positions: the 4th harmonic in force and frequency"
)
_FREQUENCY = Mechanism("frequency over temperature", 23, THERMAL, "slow ramps up and down")
_MISALIGNMENT = Mechanism("input-axis misalignment", 29, XU, "more than ten turns of the table")
NEAREST = {
    ("bias", "wave_angle"): (_DAMPING, _DRIVE_GAIN, _OFFSET),
    ("bias", "rate"): (_RANGE, _DELAY, _BRYAN),
    ("bias", "temperature"): (_OVER_TEMPERATURE, _GRADIENT),
    ("bias", "temperature_rate"): (_GRADIENT, _OVER_TEMPERATURE),
    ("bias", "acceleration"): (_FORCE,),
    ("bias", "amplitude"): (_DUFFING,),
    ("bias", "time"): (_CHARGE, _OVER_TEMPERATURE),
    ("readout", "wave_angle"): (_CUBIC, _PICKOFF_GAIN, _PICKOFF_AXES),
    ("readout", "acceleration"): (_FORCE,),
    ("pickoff", "wave_angle"): (_PICKOFF_GAIN, _PICKOFF_AXES, _OFFSET, _CUBIC),
    ("pickoff", "temperature"): (_OVER_TEMPERATURE,),
    ("pickoff", "acceleration"): (_FORCE,),
    ("pickoff", "amplitude"): (_CUBIC, _OFFSET),
    ("drive", "wave_angle"): (_DRIVE_GAIN, _DRIVE_AXES, _AUTHORITY),
    ("damping", "wave_angle"): (_DAMPING, _MOUNTING, _DRIVE_GAIN),
    ("damping", "temperature"): (_OVER_TEMPERATURE,),
    ("damping", "time"): (_AGEING,),
    ("damping", "amplitude"): (_CUBIC, _AUTHORITY),
    ("stiffness", "wave_angle"): (_SPLIT,),
    ("stiffness", "amplitude"): (_DUFFING,),
    ("stiffness", "temperature"): (_FREQUENCY, _CHARGE),
    ("stiffness", "time"): (_CHARGE,),
    ("stiffness", "acceleration"): (_FORCE,),
    ("bench", "table_angle"): (_MISALIGNMENT,),
}
"""Nearest mechanisms by place and coordinate, the nearest first."""


def find_nearest(term: Term) -> tuple[Mechanism, ...]:
    """Nearest known mechanisms of a term, the nearest first; none where the catalogue has none."""
    return next(
        (NEAREST[term.place, c] for c in term.coordinates if (term.place, c) in NEAREST), ()
    )
