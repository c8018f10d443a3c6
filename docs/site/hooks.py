"""Hooks of the documentation site: what is not written by hand, and formulas as MathML.

MathML is shown by browsers themselves, without a script.
"""

import argparse
import ast
import html
import os
import re
from collections.abc import Iterator
from importlib.metadata import entry_points
from pathlib import Path
from typing import Any

from latex2mathml.converter import convert

ROOT = Path(__file__).parents[2]
PACKAGES = ("pyhrg", "ins_eval", "fmu_build")
HANDED_OUT = {
    "ins_eval": (
        "ins_eval.imu.imu.Imu",
        "ins_eval.imu.imu.ImuReading",
        "ins_eval.trajectories.trajectory.Trajectory",
        "ins_eval.common.state.State",
        "pyhrg.records.imu.log.Increments",
        "pyhrg.records.imu.log.RecordedImu",
    ),
    "pyhrg": (
        "pyhrg.bench.reporting.result.TestResult",
        "pyhrg.bench.reporting.result.BenchResults",
        "pyhrg.bench.outcome.Finding",
        "pyhrg.gap.static_record.allan.RecordNoise",
        "pyhrg.gap.static_record.allan.ChannelNoise",
        "pyhrg.noise.coefficients.NoiseCoefficients",
        "pyhrg.noise.coefficients.Coefficient",
        "pyhrg.gap.static_record.result.RecordDiagnosis",
        "pyhrg.gap.findings.diagnosis.Diagnosis",
        "pyhrg.records.campaign.Test",
        "pyhrg.common.site.Site",
        "pyhrg.witness.prior.Prior",
        "pyhrg.challenge.scoring.report.Score",
    ),
    "fmu_build": (
        "fmu_build.check.check.Check",
        "fmu_build.roots.Root",
        "fmu_build.binaries.platforms.Platform",
    ),
}
"""Classes that a front door hands out and doesn't name."""
CATALOGUE = ROOT / "modelica" / "HRG" / "UsersGuide" / "Mechanisms.mo"

PAGE_LINK = re.compile(r"\[`?[\w/.-]+\.md`?\]\(([\w/.-]+\.md)(#[\w-]+)?\)")
"""A link whose words are the name of the page's file."""
FORMULA = re.compile(r'<(span|div) class="arithmatex">\\[(\[](.*?)\\[)\]]</\1>', re.DOTALL)
NUMBER = re.compile(r"\\tag\{(.*?)\}")
BRACKETS = {r"\langle": "⟨", r"\rangle": "⟩"}
"""Brackets that the converter knows beside no `\\Big`, as LaTeX and as a character."""


def on_page_markdown(markdown: str, page: Any, **_: object) -> str:
    """Name linked pages by their titles, and add to the reference what the code says."""
    markdown = name_links(markdown, Path(page.file.abs_src_path).parent)
    for package in PACKAGES:
        if page.file.src_uri == f"reference/{package}.md":
            return "\n\n".join([markdown, *list_public_names(package)])
    if page.file.src_uri == "reference/commands.md":
        return "\n\n".join([markdown, *describe_commands()])
    if page.file.src_uri == "reference/mechanisms.md":
        return "\n\n".join([markdown, read_catalogue()])
    return markdown


def name_links(markdown: str, folder: Path) -> str:
    """Give a page of a folder with the titles of pages, up to a colon or comma, as the words of
    links that name the pages' files."""

    def name(link: re.Match[str]) -> str:
        title = re.search("^# ([^:,\n]+)", (folder / link[1]).read_text(encoding="utf-8"), re.M)
        return f"[{title[1]}]({link[1]}{link[2] or ''})" if title else link[0]

    return PAGE_LINK.sub(name, markdown)


def list_public_names(package: str) -> Iterator[str]:
    """Give a block of mkdocstrings for each name of a package's front door, and for each class
    that it hands out."""
    stub = ast.parse((ROOT / package / "__init__.pyi").read_text(encoding="utf-8"))
    imports = [node for node in stub.body if isinstance(node, ast.ImportFrom)]
    places = {alias.name: node.module for node in imports for alias in node.names}
    for name, module in sorted(places.items(), key=lambda item: item[0].lower()):
        yield f'::: {package}.{module}.{name}\n    options: {{heading: "{package}.{name}"}}'
    for path in HANDED_OUT.get(package, ()):
        yield f'::: {path}\n    options: {{heading: "{path.rpartition(".")[2]}"}}'


def describe_commands() -> Iterator[str]:
    """Give the help of every subcommand of `hrg`."""
    os.environ["COLUMNS"] = "100"
    for parser in make_parsers():
        yield f"## {parser.prog}"
        yield from (f"```text\n{p.format_help()}```" for p in list_parsers(parser))


def make_parsers() -> Iterator[argparse.ArgumentParser]:
    """Give the parser of every subcommand of `hrg`."""
    for entry in sorted(entry_points(group="hrg.commands"), key=lambda entry: entry.name):
        command = entry.load()
        parser = argparse.ArgumentParser(f"hrg {entry.name}", description=command.HELP)
        command.add_options(parser)
        yield parser


def list_parsers(parser: argparse.ArgumentParser) -> Iterator[argparse.ArgumentParser]:
    """Give a parser and, after it, those of its own subcommands."""
    yield parser
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for part in action.choices.values():
                yield from list_parsers(part)


def read_catalogue() -> str:
    """Give the catalogue of mechanisms, HTML that stands in the Modelica library."""
    text = CATALOGUE.read_text(encoding="utf-8").replace('\\"', '"')
    return text.partition("<html>")[2].partition("</html>")[0]


def on_page_content(content: str, **_: object) -> str:
    """Write each formula of a page as MathML."""
    return FORMULA.sub(lambda match: write_formula(match[1], html.unescape(match[2])), content)


def write_formula(element: str, latex: str) -> str:
    """Give one formula as MathML; a displayed one has its number beside it."""
    for name, character in BRACKETS.items():
        latex = latex.replace(name, character)
    if element == "span":
        return convert(latex)
    numbers = "".join(f"<span>({number})</span>" for number in NUMBER.findall(latex))
    formula = convert(NUMBER.sub("", latex).strip(), display="block")
    return f'<div class="equation"><div>{formula}</div>{numbers}</div>'
