"""Candidate terms as expressions: one basis function a parameter, in text and in Modelica.

Coordinates are pure numbers: a quantity over a unit. A parameter then has the unit of its channel
(docs/methods/equation.md, Eqs. 1 to 3).
"""

import math
import re
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

from pyhrg.common.units import DEG
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.coordinates import HYSTERESIS_WIDTHS, LAST_MOTION, THERMAL_LAGS
from pyhrg.gap.effects.jump import parse_times

SECOND_FUNCTIONS = {
    "temperature": "temperature^1",
    "temperature squared": "temperature^2",
    "time": "time since power-on",
}
"""Functions by their names as the second of a product, where these differ."""
TERM_SCALE = 10.0
"""Temperature, K, and specific force, m/s^2, over which candidate terms are taken."""


class Coordinate(NamedTuple):
    """A coordinate as the written class computes it.

    name: of its variable in Modelica, and in the text.
    units: suffixes of parameters that are per unit of its powers 1, 2 and 3.
    """

    name: str
    units: tuple[str, ...]


PATTERN = Coordinate("pattern", ())
TABLE = Coordinate("tableAngle", ())
DIRECTION = Coordinate("tableDirection", ())
WARMTH = Coordinate("warmth", ("K", "K2", "K3"))
CASE = Coordinate("caseWarmth", ("K",))
WARMING = Coordinate("warming", ("K_min", "K2_min2"))
TURN = Coordinate("turnRate", ("deg_s", "deg2_s2", "deg3_s3"))
COMMANDED = Coordinate("commandedRate", ("deg_s",))
STRETCH = Coordinate("amplitudeExcess", ("",))
HOURS = Coordinate("hours", ("h",))
_FORCE_UNITS = ("m_s2", "m2_s4")
FORCES = {axis: Coordinate(f"force{axis.upper()}", _FORCE_UNITS) for axis in "xyz"}
COORDINATE_OF = {
    "pattern": "wave_angle",
    "tableAngle": "table_angle",
    "tableDirection": "table_angle",
    "warmth": "temperature",
    "caseWarmth": "temperature",
    "warming": "temperature_rate",
    "turnRate": "rate",
    "commandedRate": "rate",
    "amplitudeExcess": "amplitude",
    "hours": "time",
    **{coordinate.name: "acceleration" for coordinate in FORCES.values()},
    **{f"firstForce{axis}": "acceleration" for axis in "XYZ"},
    **{f"play{width}": "temperature" for width in HYSTERESIS_WIDTHS},
    **{f"lagging{lag}": "temperature" for lag in THERMAL_LAGS},
}
"""Coordinate of the campaign format that a variable of the written class belongs to."""


@dataclass(frozen=True)
class Basis:
    """One basis function of a term.

    stem: end of its parameter's name before the unit, such as `cos6`.
    text: plain text; modelica: expression in the variables of the written class.
    scale: the term's column over this function.
    per: suffix of the unit that the function has as a power of a coordinate; empty if none.
    uses: names of the coordinates' variables.
    test: the only test in which it acts; empty where it acts in all.
    """

    stem: str
    text: str
    modelica: str
    scale: float
    per: str
    uses: tuple[str, ...]
    test: str = ""


def express_term(term: CandidateTerm) -> tuple[Basis, ...]:
    """Basis functions of a term in the order of its columns; none if it can't be written: a value
    for each power-on, a step of the pattern."""
    if term.prefix == "pattern":
        return ()
    bases = _express(term.bare_function)
    if not term.is_encoder_error:
        return bases
    if term.coordinate == "acceleration":
        return tuple(_count_from_start(basis) for basis in bases)
    return _count_table_from_start(*bases) if len(bases) > 1 else bases


def _express(function: str) -> tuple[Basis, ...]:
    """Basis functions of a function in words; none if it can't be written."""
    for pattern, make in _EXPRESSIONS:
        if match := re.fullmatch(pattern, function):
            return make(match)
    return ()


def express_second(term: CandidateTerm) -> Basis:
    """Basis function of the second function of a product."""
    words = term.second.removeprefix("the ")
    (basis,) = _express(SECOND_FUNCTIONS.get(words, words))
    return basis


def _count_from_start(basis: Basis) -> Basis:
    """A function of one specific force less its value at power-on."""
    (force,) = basis.uses
    first = f"first{force[0].upper()}{force[1:]}"
    return replace(
        basis,
        text=f"({basis.text} - {basis.text.replace(force, first)})",
        modelica=f"({basis.modelica} - {basis.modelica.replace(force, first)})",
        uses=(force, first),
    )


def _count_table_from_start(cosine: Basis, sine: Basis) -> tuple[Basis, ...]:
    """Cosine and sine of the table angle less their values at its start, which is 0."""
    text, modelica = f"({cosine.text} - 1)", f"({cosine.modelica} - 1)"
    return replace(cosine, text=text, modelica=modelica), sine


def _angle(coordinate: Coordinate, harmonic: int) -> tuple[Basis, ...]:
    """Cosine and sine of a harmonic of an angle."""
    name = coordinate.name
    shown = {"pattern": "theta", "tableAngle": "psi"}[name]
    argument = f"{harmonic}*{name}" if harmonic != 1 else name
    text = f"{harmonic} {shown}" if harmonic != 1 else shown
    ending = "_table" if coordinate is TABLE else ""
    return tuple(
        Basis(f"{f}{harmonic}{ending}", f"{f}({text})", f"{f}({argument})", 1.0, "", (name,))
        for f in ("cos", "sin")
    )


def _cycle(harmonic: int, period: str) -> tuple[Basis, ...]:
    """Cosine and sine of a harmonic of a period, s."""
    text, phase = f"2 pi {harmonic} t/{period} s", f"{2 * math.pi * harmonic!r}*hours*3600/{period}"
    stem = f"{harmonic}_{period.replace('.', '_')}s"
    return tuple(
        Basis(f"{f}{stem}", f"{f}({text})", f"{f}({phase})", 1.0, "", ("hours",))
        for f in ("cos", "sin")
    )


def _change(words: str) -> tuple[Basis, ...]:
    """Unit steps at the times of a jump, each in its test alone; no relations, which would be
    events."""

    def step(number: int, test: str, time: float) -> Basis:
        late = f"(hours*3600 - {time!r})"
        modelica = f"(1 + {late}/(abs({late}) + 1e-9))/2"
        return Basis(
            f"jump{number}", f"[t >= {time:g} s in {test}]", modelica, 1.0, "", ("hours",), test
        )

    return tuple(step(number, *change) for number, change in enumerate(parse_times(words), 1))


def _power(coordinate: Coordinate, stem: str, power: int, unit_scale: float) -> Basis:
    """A power of a coordinate; `unit_scale` is the column's value at one unit of it, power 1."""
    raised = f"^{power}" if power != 1 else ""
    suffix = coordinate.units[power - 1]
    number = str(power) if power != 1 else ""
    name = coordinate.name
    product = "*".join([name] * power)  # of powers, the C generator takes squares alone
    return Basis(f"{stem}{number}", f"{name}{raised}", product, unit_scale**power, suffix, (name,))


def _single(coordinate: Coordinate, stem: str, expression: str, scale: float, per: str) -> Basis:
    return Basis(stem, expression, expression, scale, per, (coordinate.name,))


Match = re.Match[str]
_TENTH = 1 / TERM_SCALE


def _read_power(words: str) -> int:
    return {"": 1, " squared": 2, " cubed": 3}[words]


def _multiply(match: Match) -> tuple[Basis, ...]:
    """Basis functions times that of a second function."""
    words = SECOND_FUNCTIONS.get(match[3], match[3])
    (second,) = _express((match[2] or "") + words + (match[4] or ""))
    return tuple(
        Basis(
            f"{first.stem}_{second.stem}",
            f"{first.text} {second.text}",
            f"{first.modelica}*{second.modelica}",
            first.scale * second.scale,
            "_".join(per for per in (first.per, second.per) if per),
            (*first.uses, *second.uses),
        )
        for first in _express(match[1])
    )


def _product(match: Match) -> tuple[Basis, ...]:
    first, second = FORCES[match[1]], FORCES[match[2]]
    expression = f"{first.name}*{second.name}"
    stem = f"acceleration_{match[1]}{match[2]}"
    uses = (first.name, second.name)
    return (Basis(stem, expression, expression, _TENTH**2, "m2_s4", uses),)


def _raise(basis: Basis, power: int, bound: str) -> Basis:
    """A power of a basis function up to a bound of its magnitude, beyond which it grows in
    proportion."""
    f = f"({basis.modelica})"
    limited = f"((abs({f} + {bound}) - abs({f} - {bound}))/2)"
    product = "*".join([f, *[limited] * (power - 1)])
    per = re.sub(r"([A-Za-z]+)(\d*)", lambda m: f"{m[1]}{int(m[2] or 1) * power}", basis.per)
    stem, text = f"{basis.stem}_power{power}", f"({basis.text})^{power} [to {bound}]"
    return Basis(stem, text, product, basis.scale**power, per, basis.uses)


def _raise_function(match: Match) -> tuple[Basis, ...]:
    return tuple(_raise(basis, int(match[1]), match[3]) for basis in _express(match[2]))


_EXPRESSIONS: tuple[tuple[str, Callable[[Match], tuple[Basis, ...]]], ...] = (
    (r"(.*), times (power \d of )?(?:the )?(.*?)( to \S*)?", _multiply),
    (r"power (\d) of (.*) to (\S*)", _raise_function),
    ("mean over the pattern angle", lambda m: (Basis("mean", "1", "1", 1.0, "", ()),)),
    (r"harmonic (\d+) of the pattern angle", lambda m: _angle(PATTERN, int(m[1]))),
    (r"harmonic (\d+) of a period of (.*) s", lambda m: _cycle(int(m[1]), m[2])),
    (r"harmonic (\d+) of the table angle", lambda m: _angle(TABLE, int(m[1]))),
    ("a (?:jump|step) (at .*)", lambda m: _change(m[1])),
    (LAST_MOTION, lambda m: (_single(DIRECTION, "last_motion", DIRECTION.name, 1.0, ""),)),
    (r"temperature\^(\d)", lambda m: (_power(WARMTH, "temperature", int(m[1]), _TENTH),)),
    ("temperature of the case", lambda m: (_power(CASE, "case_temperature", 1, _TENTH),)),
    (r"temperature with a hysteresis of (\d+) K",
     lambda m: (Basis(f"hysteresis{m[1]}K", f"play{m[1]}", f"play{m[1]}", _TENTH, "K",
                      ("caseWarmth", f"play{m[1]}")),)),
    (r"temperature behind a lag of (\d+) s",
     lambda m: (Basis(f"temperature_lag{m[1]}s", f"lagging{m[1]}", f"lagging{m[1]}", _TENTH, "K",
                      ("caseWarmth", f"lagging{m[1]}")),)),
    ("temperature rate", lambda m: (_power(WARMING, "temperature_rate", 1, 1.0),)),
    ("magnitude of the temperature rate",
     lambda m: (_single(WARMING, "temperature_rate_magnitude", "abs(warming)", 1.0, "K_min"),)),
    ("square of the temperature rate", lambda m: (_power(WARMING, "temperature_rate", 2, 1.0),)),
    ("direction of the temperature rate",
     lambda m: (_single(WARMING, "temperature_rate_direction",
                        "warming/sqrt(warming^2 + 0.05^2)", 1.0, ""),)),
    (r"rate( squared| cubed|)", lambda m: (_power(TURN, "rate", _read_power(m[1]), DEG),)),
    ("magnitude of the rate",
     lambda m: (_single(TURN, "rate_magnitude", "abs(turnRate)", DEG, "deg_s"),)),
    ("rate times its magnitude",
     lambda m: (_single(TURN, "rate_signed_square", "turnRate*abs(turnRate)", DEG**2,
                        "deg2_s2"),)),
    ("commanded rotation", lambda m: (_power(COMMANDED, "commanded_rotation", 1, DEG),)),
    ("magnitude of the commanded rotation",
     lambda m: (_single(COMMANDED, "commanded_rotation_magnitude", "abs(commandedRate)", DEG,
                        "deg_s"),)),
    (r"acceleration ([xyz])( squared|)",
     lambda m: (_power(FORCES[m[1]], f"acceleration_{m[1]}", _read_power(m[2]), _TENTH),)),
    (r"acceleration ([xyz]) times ([xyz])", _product),
    ("amplitude", lambda m: (_power(STRETCH, "amplitude", 1, 1.0),)),
    ("amplitude squared",
     lambda m: (Basis("amplitude2", "((1 + amplitudeExcess)^2 - 1)",
                      "amplitudeExcess*(2 + amplitudeExcess)", 1.0, "", (STRETCH.name,)),)),
    ("time since power-on", lambda m: (_power(HOURS, "time", 1, 1.0),)),
    (r"settling in (\d+) s",
     lambda m: (Basis(f"settling_{m[1]}s", f"exp(-t/{m[1]} s)", f"exp(-hours*3600/{m[1]})", 1.0,
                      "", ("hours",)),)),
)  # fmt: skip
"""What the words of a term's function mean: basis functions by the words."""
