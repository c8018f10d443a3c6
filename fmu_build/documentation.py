"""documentation/index.html: one page, made from the Modelica texts and the model's variables."""

import xml.etree.ElementTree as ET
from collections.abc import Iterable, Sequence
from html import escape
from importlib import resources
from pathlib import Path

import numpy as np

from fmu_build.dae import Dae
from fmu_build.modelica import Page, page
from fmu_build.plot import line_plot
from fmu_build.reference import Reference
from fmu_build.scalars import Scalar, scalars
from fmu_build.signal_flow import figure
from fmu_build.units import displayed


def documentation(dae: Dae, title: str, version: str, run: Reference | None = None) -> str:
    """The page; it needs no other file.

    Args:
        dae: the model.
        title: one line on what it is.
        version: of the model.
        run: to show in a figure.

    Raises:
        ValueError: an info text that is no well-formed HTML.
    """
    listed = list(scalars(dae))
    name = dae.model.split(".")[-1]
    style = resources.files("fmu_build").joinpath("documentation.css").read_text()
    period = float(dae.sample_period)
    sections = (
        ("Signal flow", _flow(dae)),
        ("What it does", _run(run, listed) if run else ""),
        ("Inputs", _table(s for s in listed if s.causality == "input")),
        ("Outputs", _table(s for s in listed if s.causality == "output")),
        ("Equations", _equations(dae)),
        ("Parameters", _parameters(listed)),
        (
            "How it runs",
            "<p>Continuous states are integrated by the classical Runge-Kutta method from tick to "
            f"tick of a sample clock of {period:g} s, at which the sampled equations are "
            "evaluated. A tick that falls on a communication point belongs to the step that ends "
            "there. Inputs hold over a step. A value outside its range is refused with a message "
            "that names the variable.</p>",
        ),
    )
    present = [(heading, body) for heading, body in sections if body]
    links = "".join(f'<a href="#{_anchor(h)}">{h}</a>' for h, _ in present)
    body = "\n".join(
        f'<section id="{_anchor(heading)}"><h2>{heading}</h2>\n{content}\n</section>'
        for heading, content in present
    )
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8"/>
<meta name="viewport" content="width=device-width, initial-scale=1"/>
<title>{escape(name)}: {escape(title)}</title>
<style>
{style}</style>
</head>
<body>
<header><h1>{escape(name)}</h1><p>{escape(title)}</p><p class="small">Version {escape(version)}, \
from the Modelica model {escape(dae.model)} · <a href="licenses/license.txt">Licences</a></p>
<nav>{links}</nav></header>
<main>
{body}
</main>
</body>
</html>
"""


def _anchor(heading: str) -> str:
    return heading.lower().replace(" ", "-")


def _flow(dae: Dae) -> str:
    return (
        f"<figure>\n{figure(dae)}\n<figcaption>What each part reads from which, by the equations: "
        "arrows above lead forward, arrows below back. Point at an arrow for its signals."
        "</figcaption></figure>"
    )


def _run(run: Reference, listed: Sequence[Scalar]) -> str:
    """The angles among the outputs of the reference run."""
    angles = [s for s in listed if s.causality == "output" and s.attributes.get("unit") == "rad"]
    lines = {s.name: np.degrees(run.outputs[s.name]) for s in angles}
    told = ", ".join(f"<code>{escape(s.name)}</code>" for s in angles)
    driven = ", ".join(f"<code>{escape(name)}</code>" for name in run.driven)
    return (
        f"<figure>\n{line_plot(run.inputs['time'], lines, 'deg')}\n<figcaption>{told} in the "
        f"reference run of this archive ({driven} driven, all else at its default), computed by "
        "this FMU when it was built.</figcaption></figure>"
    )


def _parameters(listed: Sequence[Scalar]) -> str:
    """One table a component, in the order of declaration; the model's own parameters first."""
    components: dict[str, list[Scalar]] = {"": []}
    for scalar in listed:
        if scalar.causality == "parameter":
            components.setdefault(scalar.name.rpartition(".")[0], []).append(scalar)
    return "\n".join(
        (f"<h3><code>{escape(name)}</code></h3>\n" if name else "") + _table(members)
        for name, members in components.items()
        if members
    )


def _table(listed: Iterable[Scalar]) -> str:
    """Columns that stay empty are left out."""
    rows = [_cells(scalar) for scalar in listed]
    heads = ("Name", "Meaning", "Unit", "Default", "Range")
    used = [column for column in range(len(heads)) if any(row[column] for row in rows)]
    lines = ["".join(f"<td>{row[c]}</td>" for c in used) for row in rows]
    head = "".join(f"<th>{heads[c]}</th>" for c in used)
    body = "\n".join(f"<tr>{line}</tr>" for line in (head, *lines))
    return f'<div class="wide"><table>\n{body}\n</table></div>' if rows else ""


def _cells(scalar: Scalar) -> tuple[str, ...]:
    given = scalar.attributes
    unit, shown = given.get("unit", ""), given.get("displayUnit", "")
    limits = [_number(given[key]) if key in given else "" for key in ("min", "max")]
    default = _number(given["start"]) if "start" in given else ""
    if default and shown and float(given["start"]):
        value = displayed(float(given["start"]), unit, shown)
        default += f' <span class="small">({value:.6g} {escape(shown)})</span>'
    return (
        f"<code>{escape(scalar.name.rpartition('.')[2])}</code>",
        escape(given.get("description", "")),
        escape(unit) + (f' <span class="small">({escape(shown)})</span>' if shown else ""),
        default,
        " to ".join(limits) if all(limits) else _one_sided(*limits),
    )


def _one_sided(low: str, high: str) -> str:
    if low:
        return f"from {low}"
    return f"up to {high}" if high else ""


def _number(text: str) -> str:
    value = float(text)
    digits = f"{value:.0e}" if abs(value) >= 1e4 and value % 1e4 == 0 else f"{value:.10g}"
    return digits.replace("e+0", "e").replace("e-0", "e-").replace("-", "−")


def _equations(dae: Dae) -> str:
    """The info pages of all classes that declare a variable, the model's own first."""
    files = dict.fromkeys(Path(variable.file) for variable in dae.variables)
    pages = (page(file) for file in files)
    return "\n".join(_article(p) for p in pages if p.info)


def _article(described: Page) -> str:
    try:
        ET.fromstring(f"<div>{described.info}</div>")
    except ET.ParseError as error:
        raise ValueError(f"the info text of {described.name} is no HTML: {error}") from error
    return (
        f"<article><h3>{escape(described.description)}</h3>\n"
        f'<p class="small"><code>{escape(described.name)}</code></p>\n{described.info}</article>'
    )
