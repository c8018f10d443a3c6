"""Variables of the written class: what terms add to, their coordinates, and the outputs."""

import math

from pyhrg.common.units import ARCSEC
from pyhrg.gap.closing.equation.places import GAIN, GROWTH
from pyhrg.gap.effects.coordinates import BACKLASH_WIDTH, HYSTERESIS_WIDTHS, THERMAL_LAGS

OUTPUTS = {
    "gyroAngle": {"addedAngle": " + addedAngle"},
    "gyroRate": {},
    "patternAngle": {"addedAngle": f" - {GAIN}*addedAngle"},
    "amplitude": {
        "addedAmplitude": " + addedAmplitude",
        "freeDamping": " + gyro.amplitude*(exp(-freeDecay) - 1)",
        "addedMisreading": " + gyro.amplitude*freeMisreading",
    },
    "quadrature": {},
    "amplitudeForce": {
        "addedAmplitudeForce": " + addedAmplitudeForce",
        "addedMisreading": f" - addedMisreading*{GROWTH} - driveOn*misreadingSlope",
    },
    "quadratureForce": {
        "addedQuadratureForce": " + addedQuadratureForce",
        "addedMisreading": " - addedMisreading*gyro.quadratureForce",
    },
    "frequencyOffset": {"addedFrequency": " + addedFrequency"},
    "valid": {},
}
"""Outputs, with what each variable adds."""
ADDED = {
    "addedRate": ("AngularVelocity", "Bias, as an input rate"),
    "addedAngle": ("Angle", "Error of the measured angle"),
    "addedAmplitude": ("RelativeDisplacement", "Error of the detected amplitude"),
    "addedAmplitudeForce": ("DampingCoefficient", "Damping that the amplitude loop balances"),
    "addedQuadratureForce": ("RelativeForce", "Stiffness that the quadrature loop balances"),
    "addedFrequency": ("AngularFrequency", "Stiffness that the phase loop follows"),
    "freeDamping": ("DampingCoefficient", "Damping that also acts while the drive is off"),
    "addedMisreading": ("DimensionlessRatio", "Error of the amplitude that the pick-offs read"),
}
"""Type and meaning of what the terms add to."""
RATIO = "Units.DimensionlessRatio"
"""Type of most variables."""
_TEMPERATURE = "gyro.resonator.environment"
COORDINATES = {
    "pattern": ("Units.Angle", "Pattern angle theta", "gyro.patternAngle"),
    "warmth": (RATIO, "Resonator above the reference temperature, over 1 K",
               f"{_TEMPERATURE}.temperature/1.0"),
    "caseWarmth": (RATIO, "Case above the reference temperature, over 1 K",
                   f"caseTemperature - {_TEMPERATURE}.referenceTemperature"),
    "turnRate": (RATIO, "Input rate, over 1 deg/s", "angularRate*57.29577951308232"),
    "commandedRate": (RATIO, "Commanded rotation, over 1 deg/s",
                      "virtualRotation*57.29577951308232"),
    "hours": (RATIO, "Time since power-on, over 1 h", f"{_TEMPERATURE}.age/3600"),
    **{f"force{a}": (RATIO, f"Specific force {a.lower()}, over 1 m/s2",
                     f"acceleration{a}/1.0") for a in "XYZ"},
}  # fmt: skip
"""Type, meaning and equation of a coordinate's variable."""
_HALF = BACKLASH_WIDTH / 2
SAMPLED = {
    "slowWarmth": ("Temperature of the case behind a lag of 30 s, over 1 K",
                   "pre(slowWarmth) + (caseWarmth - pre(slowWarmth))"
                   "*(1 - 0.9996666666666667*pre(started))"),
    "warming": ("Rate of the case's temperature behind that lag, over 1 K/min",
                "2*pre(started)*(caseWarmth - slowWarmth)"),
    **{f"play{width}": (f"Temperature of the case with a play of {width} K, over 1 K",
                        f"caseWarmth + pre(started)*(abs(pre(play{width}) - caseWarmth + {width}/2)"
                        f" - abs(pre(play{width}) - caseWarmth - {width}/2))/2")
       for width in HYSTERESIS_WIDTHS},
    **{f"lagging{lag}": (f"Temperature of the case behind a lag of {lag} s, over 1 K",
                         f"pre(lagging{lag}) + (caseWarmth - pre(lagging{lag}))"
                         f"*(1 - {math.exp(-0.01 / lag)!r}*pre(started))")
       for lag in THERMAL_LAGS},
    **{f"firstForce{a}": (f"Specific force {a.lower()} at power-on, over 1 m/s2",
                          f"pre(firstForce{a})"
                          f" + (force{a} - pre(firstForce{a}))*(1 - pre(started))")
       for a in "XYZ"},
    "tablePlay": (f"Table angle behind a play of {BACKLASH_WIDTH / ARCSEC:g} arcsec, over 1 rad",
                  f"tableAngle + pre(started)*(abs(pre(tablePlay) - tableAngle + {_HALF!r})"
                  f" - abs(pre(tablePlay) - tableAngle - {_HALF!r}))/2"),
    "tableDirection": ("Direction of the table's last motion, -1 to 1",
                       f"(tableAngle - tablePlay)/{_HALF!r}"),
    "freeDecay": ("Logarithm of what such damping takes of the amplitude",
                  "pre(freeDecay) + 0.01*pre(started)*(1 - driveOn)*freeDamping"),
    "misreadingSlope": ("Rate of the amplitude's error, over 1/s",
                        "pre(started)*(addedMisreading - pre(misreading))/0.01"),
    "misreading": ("Error of the amplitude that the pick-offs read, at the last sample",
                   "addedMisreading"),
    "freeMisreading": ("Change of that error since the drive was switched off",
                       "(1 - driveOn)*(pre(freeMisreading) + 0.01*misreadingSlope)"),
    "started": ("1 from the first sample on", "1"),
}  # fmt: skip
"""Meaning and equation, every 10 ms, of variables with a memory; they are steady at power-on."""
NEEDED = {
    "warming": ("caseWarmth", "slowWarmth"),
    "tableDirection": ("tableAngle", "tablePlay"),
    "freeDamping": ("freeDecay",),
    "addedMisreading": ("misreading", "misreadingSlope", "freeMisreading"),
}
"""Other variables that a variable needs."""
