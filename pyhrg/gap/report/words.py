"""Names and numbers as people read them."""

import html
import math
from collections.abc import Sequence

from pyhrg.common.pages.svg import number
from pyhrg.gap.effects.catalogue import Effect
from pyhrg.gap.effects.design import Group

SUFFIXES = {
    "_deg_h_per_K_min": "deg/h per K/min",
    "_deg_h_sqrt_h": "deg/h/√h",
    "_deg_sqrt_h": "deg/√h",
    "_deg_h_per_g": "deg/h/g",
    "_rad_per_K": "rad/K",
    "_deg_h": "deg/h",
    "_arcsec": "arcsec",
    "_per_K": "1/K",
    "_per_g": "1/g",
    "_per_s": "1/s",
    "_ppm": "ppm",
    "_rad": "rad",
    "_deg": "deg",
    "_Hz": "Hz",
    "_s": "s",
}
"""Units by the ends of parameters' names, longer ones first; a name without one is a ratio."""
CHANNELS = {
    "gyro_angle": "output angle",
    "amplitude": "amplitude",
    "amplitude_force": "amplitude force",
    "quadrature_force": "quadrature force",
    "frequency_offset": "loop frequency",
}
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


def plain(name: str) -> str:
    """A name of the format, in words."""
    return name.replace("_", " ")


def effect_words(name: str) -> str:
    """An effect's name as words; those known by an abbreviation or a letter keep it."""
    return plain(name).replace("g sensitive", "g-sensitive").replace("coriolis", "Coriolis")


def group_words(group: Group) -> str:
    """An effect, or what has no name."""
    if isinstance(group, Effect):
        return effect_words(group.name)
    return f"unnamed: {CHANNELS[group.channel]}, {group.of}"


def listed(words: Sequence[str]) -> str:
    """a, b and c."""
    return " and ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)


def unit_of(parameter: str) -> tuple[str, str, float]:
    """Words for a parameter, its unit, and by what a value is multiplied to be in it."""
    for suffix, unit in SUFFIXES.items():
        if parameter.endswith(suffix):
            return plain(parameter.removesuffix(suffix)), unit, 1.0
    return plain(parameter), "ppm", 1e6


def value_words(value: float, low: float, high: float) -> str:
    """A value and its interval, with two digits of the interval's width."""
    width = high - low
    if not (math.isfinite(width) and width > 0):
        return f"{number(value)} ({number(low)} to {number(high)})"
    largest = max(abs(low), abs(high), abs(value))
    digits = min(max(math.ceil(math.log10(largest / width)) + 2, 3), 9)
    told = [f"{v:.{digits}g}".replace("-", "−") for v in (value, low, high)]
    return f"{told[0]} ({told[1]} to {told[2]})"


def percent(share: float) -> str:
    """A share or probability; none is told as certain."""
    if share > 0.9995:
        return ">\u00a099.9\u00a0%"
    if 0 < share < 0.0005:
        return "<\u00a00.1\u00a0%"
    return f"{100 * share:.1f}\u00a0%"


def bar(share: float, width: int = 160) -> str:
    """A share as a bar, decoration to a number beside it."""
    length = max(0.0, min(1.0, share)) * width
    return (
        f'<svg class="share" viewBox="0 0 {width} 12" width="{width}" aria-hidden="true">'
        f'<rect class="whole" width="{width}" height="12"/>'
        f'<rect width="{length:.1f}" height="12"/></svg>'
    )


def markup_table(title: str, header: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> str:
    """A table whose cells are markup already; it may be scrolled where it is too wide."""
    head = "".join(f'<th scope="col">{cell}</th>' for cell in header)
    body = "".join(
        "<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>" for cells in rows
    )
    return (
        f'<div class="wide"><table><caption>{html.escape(title)}</caption>'
        f"<thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>"
    )
