"""The identified gyro and its proposed terms as a Modelica class, `closed.mo`."""

import html
import math
import re
from collections.abc import Mapping, Sequence
from importlib.metadata import version
from typing import Any

from pyhrg.device.device import Device
from pyhrg.device.parameter_set import convert_value
from pyhrg.gap.closing.equation.places import GAIN, Acting, Response, find_acting
from pyhrg.gap.closing.equation.proposal import as_candidate, list_written
from pyhrg.gap.closing.equation.variables import (
    ADDED,
    COORDINATES,
    NEEDED,
    OUTPUTS,
    RATIO,
    SAMPLED,
)
from pyhrg.gap.findings.term import Term

CLASS = "closed"
"""Name of the class and of the FMU."""
INPUTS = (
    "virtualRotation", "accelerationX", "accelerationY", "accelerationZ", "caseTemperature",
    "biasVoltage", "vibration", "amplitudeSetpoint", "phaseOffset", "driveOn",
)  # fmt: skip
"""Inputs that the inner gyro takes as they are; the angular rate gets the bias terms."""
TURNING = {
    "pickOff.turning": "gyro.controller.commandedTurn - (1 - gyro.controller.forceToRebalance)"
    f"*2*{GAIN}*angularRate"
}
"""Modifier of the inner gyro with a bias, which may follow the angle that the pick-offs read: how
these are skewed by a turning pattern then follows the rate of the case alone."""
TEXT = """model {name} "{title}"
  extends HRG.Interfaces.PartialGyro{starts};
{parameters}{variables}  HRG.Gyroscopes.HRGEnvelope gyro(
    seed = seed,
    startAngle = startAngle,
    startAmplitude = startAmplitude,
    angularRate = angularRate{bias},
{held}{modifiers}) "The identified gyro, its causes put in";
equation
{equations}
  annotation (uses(HRG(version = "{version}")), Documentation(info="<html>
{documentation}
</html>"));
end {name};
"""


def write_class(device: Device, terms: Sequence[Term], title: str, notes: Sequence[str]) -> str:
    """Text of the class: the device with its terms; notes are sentences for its documentation."""
    own = _split_values(device)
    seen = {response.variable for t in terms for response in _find_acting(t).responses}
    added = [variable for variable in ADDED if variable in seen]
    used = _list_uses(terms, added)
    started = ", ".join(f"{n}(start = {v!r})" for n, v in own["inputs"].items())
    fixed = ", ".join(f"{n} = {v!r}" for n, v in own["start"].items())
    starts = ", ".join(part for part in (fixed, started) if part)
    has_bias = "addedRate" in added
    modifiers = _format_modifiers({**own["gyro"], **(TURNING if has_bias else {})})
    return TEXT.format(
        name=CLASS,
        version=version("hrg"),
        title=_clean_text(title),
        starts=f"({starts})" if starts else "",
        parameters="".join(_declare_parameters(t) for t in terms),
        variables=_declare_variables(used, added),
        bias=" + addedRate" if has_bias else "",
        held=",\n".join(f"    {name} = {name}" for name in INPUTS),
        modifiers=f",\n    {modifiers}" if modifiers else "",
        equations=_write_equations(device, terms, used, added),
        documentation=_document(terms, notes),
    )


def _split_values(device: Device) -> dict[str, dict[str, float]]:
    """The FMU's values that differ from its defaults: of inputs, of power-on, of the gyro."""
    split: dict[str, dict[str, float]] = {"inputs": {}, "start": {}, "gyro": {}}
    for name, value in device.fmu_parameters().items():
        kind = "gyro" if "." in name else "start" if name.startswith("start") else "inputs"
        split[kind][name] = convert_value(name, value)
    return split


def _format_modifiers(values: Mapping[str, float | str]) -> str:
    """Nested modifiers of dotted names, texts being expressions; elements of a vector make a whole
    vector of three."""
    tree: dict[str, Any] = {}
    for name, value in values.items():
        *path, last = name.split(".")
        node = tree
        for part in path:
            node = node.setdefault(part, {})
        if match := re.fullmatch(r"(\w+)\[(\d)\]", last):
            node.setdefault(match[1], [0.0, 0.0, 0.0])[int(match[2]) - 1] = value
        else:
            node[last] = value

    def write(node: Mapping[str, Any]) -> str:
        parts = []
        for key, value in node.items():
            if isinstance(value, dict):
                parts.append(f"{key}({write(value)})")
            elif isinstance(value, list):
                parts.append(f"{key} = {{{', '.join(map(repr, value))}}}")
            else:
                parts.append(f"{key} = {value}")
        return ", ".join(parts)

    return ",\n    ".join(write({key: value}) for key, value in tree.items())


def _find_acting(term: Term) -> Acting:
    return find_acting(as_candidate(term))


def _list_uses(terms: Sequence[Term], added: Sequence[str]) -> list[str]:
    """Names of all coordinates' variables that the terms need, in the order of the equations."""
    coefficients = [c for t in terms for c in list_written(t)]
    used = {name for c in coefficients for name in c.basis.uses}
    used |= {other for name in {*used, *added} & NEEDED.keys() for other in NEEDED[name]}
    if used & SAMPLED.keys():
        used.add("started")
    return [name for name in (*COORDINATES, "tableAngle", "amplitudeExcess", *SAMPLED)
            if name in used]  # fmt: skip


def _declare_parameters(term: Term) -> str:
    """Parameters of a term, SI, with their meaning and value in the unit of the diagnosis."""
    lines = []
    for c in list_written(term):
        value = term.parameters[c.name]
        si = 0.0 if c.basis.test else value * c.factor
        where = " there, 0 else" if c.basis.test else ""
        meaning = _clean_text(f"Coefficient of {c.basis.text}: {c.name} = {value:.6g}{where}")
        lines.append(
            f'  parameter HRG.Units.{_find_acting(term).type} {c.variable} = {si!r} "{meaning}";\n'
        )
    return "".join(lines)


def _declare_variables(used: Sequence[str], added: Sequence[str]) -> str:
    lines = []
    if "tableAngle" in used:
        lines.append(
            '  input HRG.Units.Angle tableAngle(start = 0) "Reading of the table encoder";'
        )
    for name in used:
        if name in COORDINATES:
            kind, meaning, _ = COORDINATES[name]
            lines.append(f'  HRG.{kind} {name} "{meaning}";')
    if "amplitudeExcess" in used:
        lines.append(f'  HRG.{RATIO} amplitudeExcess "Amplitude over the nominal one, less 1";')
    lines += [
        f'  discrete HRG.{RATIO} {name}(start = 0, fixed = true) "{meaning}";'
        for name, (meaning, _) in SAMPLED.items()
        if name in used
    ]
    lines += [f'  HRG.Units.{ADDED[name][0]} {name} "{ADDED[name][1]}";' for name in added]
    return "".join(f"{line}\n" for line in lines)


def _write_equations(
    device: Device, terms: Sequence[Term], used: Sequence[str], added: Sequence[str]
) -> str:
    lines = [f"  {name} = {COORDINATES[name][2]};" for name in used if name in COORDINATES]
    if "amplitudeExcess" in used:
        lines.append(
            "  amplitudeExcess = sqrt(gyro.amplitude^2 + gyro.quadrature^2)"
            f"/{device.amplitude!r} - 1;"
        )
    if "started" in used:
        lines.append("  when sample(0, 1e-2) then")
        lines += [f"    {n} = {text};" for n, (_, text) in SAMPLED.items() if n in used]
        lines.append("  end when;")
    for name in added:
        lines.append(f"  {name} = {' + '.join(_list_summands(terms, name))};")
    for name, more in OUTPUTS.items():
        sums = "".join(text for variable, text in more.items() if variable in added)
        lines.append(f"  {name} = gyro.{name}{sums};")
    return "\n".join(lines)


def _list_summands(terms: Sequence[Term], variable: str) -> list[str]:
    """What the terms add to a variable of the class."""
    return [
        write_response(term.formula.modelica, response)
        for term in terms
        for response in _find_acting(term).responses
        if response.variable == variable
    ]


def write_response(expression: str, response: Response) -> str:
    """What a term of this expression adds to a variable."""
    if response.is_turned:
        expression = re.sub(r"\b(\d+\*pattern)\b", rf"(\1 + {math.pi / 2!r})", expression)
    return f"({expression})*({response.factor})" if response.factor else expression


def _document(terms: Sequence[Term], notes: Sequence[str]) -> str:
    parts = [f"<p>{_clean_text(html.escape(note, quote=False))}</p>" for note in notes]
    for term in terms:
        low_high = "; ".join(
            f"{n} = {v:.6g} (95 %: {term.interval_95[n][0]:.6g} to {term.interval_95[n][1]:.6g})"
            for n, v in term.parameters.items()
        )
        parts += [
            f"<pre>{variable} = {html.escape(summand, quote=False)}</pre>"
            for variable in dict.fromkeys(r.variable for r in _find_acting(term).responses)
            for summand in _list_summands([term], variable)
        ]
        parts.append(
            f"<p>Acts at: {term.place}. {html.escape(low_high, quote=False)}. Posterior "
            f"probability of this form {term.probability:.3f}.</p>"
        )
    return "\n".join(parts)


def _clean_text(text: str) -> str:
    """Text for a Modelica string."""
    return text.replace("\\", "/").replace('"', "'")
