"""Names, numbers and tables as the page shows them."""

import html
from collections.abc import Sequence

from pyhrg.device.declarations import format_effect
from pyhrg.device.device import Device
from pyhrg.device.keys import KEYS
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.linear_test import Group
from pyhrg.gap.replay.observations import CHANNEL_WORDS
from pyhrg.gap.soundness.fault import SOUND_VALUES

SUFFIXES = {
    "_deg_h_per_K_min": "deg/h per K/min",
    "_deg_h_sqrt_h": "deg/h/√h",
    "_deg_sqrt_h": "deg/√h",
    "_deg_h_per_g": "deg/h/g",
    "_rad_per_K": "rad/K",
    "_deg_h": "deg/h",
    "_arcsec": "arcsec",
    "_percent": "%",
    "_per_K": "1/K",
    "_per_g": "1/g",
    "_per_s": "1/s",
    "_ppm": "ppm",
    "_rad_s": "rad/s",
    "_rad": "rad",
    "_deg": "deg",
    "_Hz": "Hz",
    "_K": "K",
    "_s": "s",
}
"""Unit of a parameter by the end of its name, longer endings first. A name without one
is a ratio."""
NOTHING_BEYOND = "No channel of any test has more power than tolerances and noise explain."
COORDINATES = {
    "wave_angle": "pattern angle",
    "table_angle": "table angle",
    "temperature": "temperature",
    "temperature_rate": "temperature rate",
    "rate": "input rate",
    "acceleration": "acceleration",
    "amplitude": "amplitude",
    "time": "time",
    "noise": "noise, or no coordinate",
}
PLACES = {
    "bias": "Bias",
    "readout": "Read-out",
    "pickoff": "Pick-off",
    "drive": "Drive",
    "damping": "Damping",
    "stiffness": "Stiffness",
    "electronics": "Electronics",
    "bench": "Bench",
}
"""Place of a proposed term."""
PARTS = {"phase": "Electronics, phase", "drive gain": "Drive, gain"}
"""Part of the place at which a term acts, by the term's prefix."""
TERM_UNITS = {
    "deg_h": "deg/h",
    "K2": "K²",
    "K3": "K³",
    "K_min": "(K/min)",
    "K2_min2": "(K/min)²",
    "deg_s": "(deg/s)",
    "deg2_s2": "(deg/s)²",
    "deg3_s3": "(deg/s)³",
    "deg_s_K": "(deg/s K)",
    "m_s2": "(m/s²)",
    "m2_s4": "(m/s²)²",
    "m_s2_K": "(m/s² K)",
}
"""Units in the names of a term's coefficients."""


def format_term_unit(unit: str) -> str:
    """The unit at the end of a coefficient's name, as it is read."""
    head, _, per = unit.replace("per_s", "1/s", 1).partition("_per_")
    if unit.startswith("per_") and not unit.startswith("per_s"):
        head, per = "1", unit.removeprefix("per_")
    words = TERM_UNITS.get(head, head)
    return f"{words} per {TERM_UNITS.get(per, per)}" if per else words


def format_name(name: str) -> str:
    """A name of the record format with spaces in place of underscores."""
    return name.replace("_", " ")


def format_group(group: Group) -> str:
    """An effect's name, or channel and function of a candidate term."""
    if isinstance(group, Effect):
        return format_effect(group.name)
    return f"unnamed: {CHANNEL_WORDS[group.channel]}, {group.function}"


def join_words(words: Sequence[str]) -> str:
    """Words as a list in a sentence: "a, b and c"."""
    return " and ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)


def parse_parameter(parameter: str) -> tuple[str, str, float]:
    """Words for a parameter, the unit it is shown in, and the factor from its own unit to that."""
    if parameter.endswith("_sign"):
        return format_name(parameter), "", 1.0
    for suffix, unit in SUFFIXES.items():
        if parameter.endswith(suffix):
            return format_name(parameter.removesuffix(suffix)), unit, 1.0
    return format_name(parameter), "ppm", 1e6


def read_nominal_value(nominal: Device, parameter: str) -> float:
    """Nominal value of a parameter of a cause, in the unit of its name."""
    if parameter in SOUND_VALUES:
        return SOUND_VALUES[parameter]
    key = next(key for key in KEYS if key.name == parameter)
    return key.from_si(getattr(nominal, key.field))


def format_percent(share: float) -> str:
    """A share or probability; above 99.95 % and below 0.05 % only the bound is stated."""
    if share > 0.9995:
        return ">\u00a099.9\u00a0%"
    if 0 < share < 0.0005:
        return "<\u00a00.1\u00a0%"
    return f"{100 * share:.1f}\u00a0%"


def show_share(share: float) -> tuple[str, str]:
    """A share as two cells of a table: a number and an SVG bar, which is hidden from screen readers
    because the number stands beside it."""
    length = max(0.0, min(1.0, share)) * 160
    bar = (
        '<svg class="share" viewBox="0 0 160 12" width="160" aria-hidden="true">'
        '<rect class="whole" width="160" height="12"/>'
        f'<rect width="{length:.1f}" height="12"/></svg>'
    )
    return format_percent(share), bar


def build_table(title: str, header: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> str:
    """A table whose cells are markup already; it scrolls sideways where it is too wide."""
    head = "".join(f'<th scope="col">{cell}</th>' for cell in header)
    body = "".join(
        "<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>" for cells in rows
    )
    return (
        f'<div class="wide"><table><caption>{html.escape(title)}</caption>'
        f"<thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>"
    )
