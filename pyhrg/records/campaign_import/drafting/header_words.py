"""Words of headers and file names that tell what a column, a unit or a test is."""

from pyhrg.records.campaign_import.units import BY_COLUMN_UNIT, RATE

PATTERNS = {
    "time": r"^t$|time|zeit|stamp",
    "table_angle": r"table|^enc|tisch|stage",
    "axis_up": r"axis_up",
    "accel_x": r"^acc.*x$|^a_?x$|^f_?x$",
    "accel_y": r"^acc.*y$|^a_?y$|^f_?y$",
    "accel_z": r"^acc.*z$|^a_?z$|^f_?z$",
    "temperature": r"^temp|^t$|^t[ _]?(case|gyro)|^case|gehäuse",
    "virtual_rotation": r"virtual|^vr|^v_?cmd|rot.*cmd|cmd.*rot",
    "amplitude_setpoint": r"set_?point|^a_?set|^ampl.*set",
    "phase_offset": r"phase_?off",
    "drive_on": r"drive|^drv",
    "wave_angle": r"wave|pattern|muster|welle|theta|precession",
    "quadrature_force": r"quad|^f_?q$",
    "amplitude_force": r"ampl.*(force|kraft)|damping|^f_?a(mpl?)?$",
    "frequency_offset": r"freq|^f$",
    "amplitude": r"^amp",
    "valid": r"valid",
    "gyro_angle": r"gyro|^out|ausgang",
}
"""What a column's name without its unit matches, in lower case, by stem; the first one counts."""
UNSURE_PATTERNS = {
    "temperature": r"temp",
    "amplitude": r"^a$",
    "gyro_angle": r"omega|angle|winkel|rate",
}
"""Words of many quantities, matched likewise where no other column fits; such a guess is marked."""
KINDS = {
    **{
        "positions": "position|circ",
        "ring_down": "ring|^rd",
        "virtual_rotation": "virtual|(^|[_ -])vr",
    },
    **{"thermal": "therm", "amplitude": "ampl", "phase_step": "phase", "tumble": "tumbl"},
    **{"manoeuvre": "man|drive.?cycle|heading", "rate": "rate", "static": ""},
}
"""Kinds of tests, each with what the name of its log may match, in lower case."""
USUAL_UNITS = {"s": "s", "deg": "deg", "rad": "rad", "deg_s": "deg/s", "m_s2": "m/s2"} | {
    **{"degC": "degC", "per_s": "1/s", "Hz": "Hz", "": "1"}
}
"""Unit that is taken where a header names none, by the column's own unit."""
UNIT_NAMES = {
    **{"C": "degC", "°C": "degC", "°": "deg", "Grad": "deg", "Grad/s": "deg/s", "°/s": "deg/s"},
    **{"°/h": "deg/h", "dps": "deg/s", "m/s^2": "m/s2", "m/s²": "m/s2", "V": "1", "mV": "1"},
    **{"V/s": "1/s", "mV/s": "1/s"},
}
"""Units as a laboratory may write them, by their names in a mapping; an amplitude in volts is a
number of its scale."""
STATES = {"on": 1, "off": 0, "true": 1, "false": 0, "yes": 1, "no": 0}
"""Words for 1 and 0, in lower case."""
KNOWN_UNITS = {*UNIT_NAMES, *RATE}.union(*BY_COLUMN_UNIT.values())
"""Units that tell what a column is not."""
