"""The report as one HTML page that needs no network and no script, and uses one if it may."""

import html
from collections.abc import Sequence
from importlib.resources import files
from pathlib import Path

from ins_eval.study.report.apart import sentence
from ins_eval.study.report.embedded import embedded
from ins_eval.study.report.figures.marks import calibration_title
from ins_eval.study.report.requirements import UNSEEN
from ins_eval.study.report.result import StudyResult
from ins_eval.study.report.sections import SECTIONS, markup
from ins_eval.study.report.verdict import headline, verdict
from ins_eval.study.tables import columns as c
from ins_eval.study.tables.score import ALL
from pyhrg.common.files import staging
from pyhrg.common.pages.markup import paragraph
from pyhrg.common.pages.shell import POLICY, base_style

PAGE = "report.html"
TITLE = "Does the full circumference predict the navigator's error?"


def page(result: StudyResult) -> str:
    """The report; the same result gives the same bytes."""
    contents = "".join(f'<li><a href="#{s.name}">{s.title}</a></li>' for s in SECTIONS)
    return (
        '<!doctype html><html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width,initial-scale=1">'
        f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">'
        f"<title>{TITLE}</title><style>{base_style()}{_asset('page.css')}</style></head><body>"
        f"<header><h1>{TITLE}</h1>{_verdict(result)}</header>"
        f'<nav aria-label="Sections"><ul>{contents}</ul></nav>{_filters(result)}'
        f"<main>{''.join(markup(section, result) for section in SECTIONS)}</main>"
        '<div id="tip" role="status" aria-live="polite" hidden></div>'
        f'<script type="application/json" id="study">{embedded(result)}</script>'
        f"<script>{_asset('page.js')}</script></body></html>\n"
    )


def write(result: StudyResult, folder: Path) -> None:
    """Write report.html into a folder, or nothing.

    Raises:
        OSError: the folder can't be written.
    """
    with staging(folder, (PAGE,)) as aside:
        (aside / PAGE).write_text(page(result), encoding="utf-8")


def _verdict(result: StudyResult) -> str:
    told = "".join(
        f"<div><h3>{html.escape(title.capitalize())}</h3><ul>{_items(sentences)}</ul></div>"
        for title, sentences in verdict(result)
        if sentences
    )
    scope = "All figures: gyros and mission classes that no predictor was made on."
    return (
        f'<p class="headline">{html.escape(headline(result))} '
        '<a href="#breaks">Which, and where not.</a></p>'
        f"{_elsewhere(result)}"
        f'<div class="verdicts">{told}</div>{paragraph(scope, "weak")}'
    )


def _elsewhere(result: StudyResult) -> str:
    told = sentence(result)
    return paragraph(told) if told else ""


def _items(sentences: Sequence[str]) -> str:
    return "".join(f"<li>{html.escape(sentence)}</li>" for sentence in sentences)


def _filters(result: StudyResult) -> str:
    """Hidden until the script runs."""
    calibrations = {key: calibration_title(key) for key in result.values(c.CALIBRATION)}
    halves = {key: f"{key} half" for key in result.values(c.HALF)}
    classes = {key: key for key in result.values(c.CLASS)}
    predictors = {p.key: p.title for p in c.PREDICTORS}
    return (
        '<form id="filters" hidden aria-label="What the figures show">'
        + _choice("calibration", "Calibration", "all", calibrations, next(iter(calibrations)))
        + _choice("half", "Half", "both", halves, UNSEEN)
        + _choice("class", "Class", "all", classes, ALL)
        + _choice("predictor", "Predictor", "all", predictors, ALL)
        + "</form>"
    )


def _choice(key: str, title: str, every: str, options: dict[str, str], first: str) -> str:
    listed = "".join(
        f'<option value="{html.escape(value)}"{" selected" if value == first else ""}>'
        f"{html.escape(text)}</option>"
        for value, text in {ALL: every, **options}.items()
    )
    return f'<label>{title} <select name="{key}" autocomplete="off">{listed}</select></label>'


def _asset(name: str) -> str:
    return files("ins_eval.study.report").joinpath(name).read_text(encoding="utf-8")
