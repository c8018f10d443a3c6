"""Campaigns as a lab might have logged them: other names, units, signs, separators, order."""

from pathlib import Path

import numpy as np

from pyhrg.common.units import ARCSEC, DEG, HOUR, STANDARD_GRAVITY
from pyhrg.records import Log
from pyhrg.records.campaign import Campaign

HEAD = """
device = "made up"
[site]
latitude_deg = 40.0
gravity_m_s2 = 9.8015
[nominal]
coriolis_factor = 0.277
decay_time_s = 450.0
frequency_Hz = 7000.0
"""

FOREIGN = (
    HEAD
    + """
[layout]
separator = "semicolon"
decimal = "comma"
encoding = "latin-1"
comment = "%"
lines_before_header = 1
lines_after_header = 1
missing = ["---"]

[columns]
time = { column = "Zeit", unit = "ms", offset = -5000 }
table_angle = { column = "Drehtisch", unit = "turn", scale = -1, offset = 0.3, wraps_every = 1 }
axis_up = 1
accel_x = { constant = 0, unit = "m/s2" }
accel_y = { constant = 0, unit = "m/s2" }
accel_z = { column = "Beschl", unit = "mg" }
temperature = { column = "Temp", unit = "degF" }
virtual_rotation = { column = "VR", unit = "deg/h" }
amplitude_setpoint = 1
phase_offset = { constant = 0, unit = "rad" }
drive_on = 1
gyro_angle = { column = "Ausgang", unit = "arcsec" }
wave_angle = { column = "Welle", unit = "mrad" }
amplitude = { column = "Ampl", scale = 0.5 }
amplitude_force = { column = "AGC", unit = "1/h" }
quadrature_force = { column = 11, unit = "1/ms" }
frequency_offset = { column = "f", unit = "kHz", offset = -7 }
"""
)
NAMES = "Zeit;Drehtisch;Beschl;Temp;VR;Ausgang;Welle;Ampl;AGC;f;Quad"


def entry_of(name: str, kind: str, role: str, file: str) -> str:
    """A test's entry in a mapping."""
    keys = {"id": name, "kind": kind, "role": role, "file": file}
    return "\n[[tests]]\n" + "".join(f'{key} = "{value}"\n' for key, value in keys.items())


def foreign(campaign: Campaign, folder: Path) -> Path:
    """Write logs and mapping."""
    text = FOREIGN
    for test in campaign.tests:
        text += entry_of(test.id, test.kind, test.role, f"{test.id}.txt")
        (folder / f"{test.id}.txt").write_bytes(_file(test.log).encode("latin-1"))
    (folder / "mapping.toml").write_text(text)
    return folder / "mapping.toml"


def _file(log: Log) -> str:
    columns = [
        1e3 * log.time + 5000,
        np.mod(0.3 - log.table_angle / (360 * DEG), 1.0),
        1e3 * log.acceleration_z / STANDARD_GRAVITY,
        (log.temperature - 273.15) * 9 / 5 + 32,
        log.virtual_rotation / DEG * HOUR,
        log.gyro_angle / ARCSEC,
        1e3 * log.wave_angle,
        2 * log.amplitude,
        HOUR * log.amplitude_force,
        7 + 1e-3 * log.frequency_offset / (2 * np.pi),
        1e-3 * log.quadrature_force,
    ]
    rows = zip(*(c.tolist() for c in columns), strict=True)
    lines = [";".join(_cell(value) for value in row) for row in rows]
    return "\n".join(
        ["Prüfstand 2", NAMES, 'ms;U;mg;°F;°/h;";mrad;V;1/h;kHz;1/ms', "% los", *lines]
    )


def _cell(value: float) -> str:
    return "---" if np.isnan(value) else f"{value:.17g}".replace(".", ",")
