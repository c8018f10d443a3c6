"""documentation/index.html: one page, made from the Modelica texts and the model's variables."""

from collections.abc import Sequence
from html import escape
from importlib import resources

import numpy as np

from fmu_build.archive.documentation.info_pages import read_guide_pages, read_model_pages
from fmu_build.archive.documentation.plot import draw_lines
from fmu_build.archive.documentation.signal_flow import draw_signal_flow
from fmu_build.archive.documentation.variable_tables import (
    format_parameter_tables,
    format_variable_table,
)
from fmu_build.archive.reference import Reference
from fmu_build.equations.dae import Dae
from fmu_build.equations.scalars import Scalar, list_variables
from fmu_build.roots import METHODS, Root

TEMPLATE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8"/>
<meta name="viewport" content="width=device-width, initial-scale=1"/>
<title>{name}: {title}</title>
<style>
{style}</style>
</head>
<body>
<header><h1>{name}</h1><p>{title}</p><p class="small">Version {version}, \
from the Modelica model {model} · <a href="licenses/license.txt">Licences</a></p>
<nav>{links}</nav></header>
<main>
{body}
</main>
</body>
</html>
"""

FLOW = """<figure>
{}
<figcaption>What each part reads from which, by the equations: arrows above lead forward, \
arrows below back. Point at an arrow for its signals.</figcaption></figure>"""


def write_documentation(
    dae: Dae, root: Root, version: str, run: Reference | None = None, fmi: int = 2
) -> str:
    """The page, with a figure of the run; it needs no other file."""
    listed = list_variables(dae, fmi)
    present = {heading: body for heading, body in _sections(dae, root, run, listed).items() if body}
    return TEMPLATE.format(
        name=escape(root.identifier),
        title=escape(root.description),
        style=resources.files("fmu_build.archive.documentation")
        .joinpath("documentation.css")
        .read_text(),
        version=escape(version),
        model=escape(dae.model),
        links="".join(f'<a href="#{_anchor(h)}">{h}</a>' for h in present),
        body="\n".join(
            f'<section id="{_anchor(heading)}"><h2>{heading}</h2>\n{content}\n</section>'
            for heading, content in present.items()
        ),
    )


def _sections(
    dae: Dae, root: Root, run: Reference | None, listed: Sequence[Scalar]
) -> dict[str, str]:
    """Contents by heading, in their order; some may be empty."""
    return {
        "Signal flow": FLOW.format(draw_signal_flow(dae)),
        "What it does": _run(run, listed) if run else "",
        "Inputs": format_variable_table(s for s in listed if s.causality == "input"),
        "Outputs": format_variable_table(s for s in listed if s.causality == "output"),
        "Equations": read_model_pages(dae),
        "Parameters": format_parameter_tables(listed),
        "How it runs": _stepping(dae, root),
        "Guide": read_guide_pages(dae),
    }


def _anchor(heading: str) -> str:
    return heading.lower().replace(" ", "-")


def _stepping(dae: Dae, root: Root) -> str:
    return (
        f"<p>Continuous states are integrated by {escape(METHODS[root.integrator])} from sample to "
        f"sample, in steps of {_periods(dae)[0]} at most. Sampled equations are evaluated every "
        f"{', '.join(_periods(dae))}. A sample that falls on a communication point belongs to the "
        "step that ends there. Inputs hold over a step. A value outside its range is refused with "
        "a message that names the variable.</p>"
    )


def _periods(dae: Dae) -> list[str]:
    """Names the sample clocks' periods, the shortest first."""
    multiples = sorted({sample.every for sample in dae.sampled} | {1})
    lengths = [f"{1e3 * float(dae.sample_period * multiple):g} ms" for multiple in multiples]
    if dae.settable_period is None:
        return lengths
    name = f"<code>{escape(dae.settable_period.name)}</code>"
    return [
        f"{name if m == 1 else f'{m} {name}'} (default {length})"
        for m, length in zip(multiples, lengths, strict=True)
    ]


def _run(run: Reference, listed: Sequence[Scalar]) -> str:
    """The angles among the outputs of the reference run."""
    angles = [s for s in listed if s.causality == "output" and s.attributes.get("unit") == "rad"]
    lines = {s.name: np.degrees(run.outputs[s.name]) for s in angles}
    names = ", ".join(f"<code>{escape(s.name)}</code>" for s in angles)
    driven = ", ".join(f"<code>{escape(name)}</code>" for name in run.driven)
    return (
        f"<figure>\n{draw_lines(run.inputs['time'], lines, 'deg')}\n<figcaption>{names} in the "
        f"reference run of this archive ({driven} driven, all else at its default), computed by "
        "this FMU when it was built.</figcaption></figure>"
    )
