"""The report as one HTML page, and the folder of a diagnosis with it. The page reads without
network and without script; its script adds pickers."""

import html
from collections.abc import Sequence
from importlib.resources import files
from pathlib import Path

from pyhrg.common.files import stage_files
from pyhrg.common.pages.markup import (
    PageSection,
    make_contents,
    make_document,
    make_paragraph,
    read_asset,
)
from pyhrg.gap.campaign_diagnosis import FILES, CampaignDiagnosis
from pyhrg.gap.report.causes import build_causes, build_ranking
from pyhrg.gap.report.closing import build_closing
from pyhrg.gap.report.places import build_places, build_scales
from pyhrg.gap.report.residuals import build_held_out, build_residuals, draw_largest
from pyhrg.gap.report.sections import Section
from pyhrg.gap.report.terms import build_terms
from pyhrg.gap.report.verdict import answer_questions, write_headline
from pyhrg.gap.report.words import build_table, format_name
from pyhrg.records.table import merge_sources

PAGE = "report.html"
TITLE = "Gap between simulation and gyro"


def write_report(
    diagnosis: CampaignDiagnosis, out: Path | str, sections: Sequence[Section] = ()
) -> None:
    """Write a diagnosis with its page: `diagnosis.json`, `before.toml`, `after.toml`,
    `closed.mo`, `closed.fmu`, `report.html`, and the document of each added section.

    Args:
        diagnosis: of a campaign.
        out: folder; made if it is missing.
        sections: added to the page before the next test.

    Raises:
        OSError: the folder can't be written.
        ValueError: a section's document has a number that is not finite.
    """
    documents = {section.file: section.to_json() for section in sections}
    with stage_files(Path(out), (*FILES, *documents, PAGE)) as aside:
        diagnosis.write_files(aside)
        for file, content in documents.items():
            (aside / file).write_bytes(content)
        (aside / PAGE).write_text(build_page(diagnosis, sections), encoding="utf-8")


def build_page(result: CampaignDiagnosis, sections: Sequence[Section] = ()) -> str:
    """The whole page as HTML; the same diagnosis gives the same bytes. Added sections stand before
    the next test."""
    closing = build_closing(result) + build_scales(result)
    shown = [
        PageSection("causes", "Causes of the gap", build_causes(result)),
        PageSection("terms", "Proposed terms", build_terms(result)),
        PageSection("ranking", "Hypotheses by posterior probability", build_ranking(result)),
        PageSection("where", "Where the gap is", build_places(result)),
        PageSection("residuals", "Residuals by coordinate", build_residuals(result)),
        PageSection("held-out", "Residuals on held-out tests", build_held_out(result)),
        PageSection("closing", "Residuals and noise floor", closing),
        *(PageSection(section.name, section.title, section.html) for section in sections),
        PageSection("next", "The next test", _build_next_test(result)),
        PageSection("data", "Tests used, and what was left out", _build_data(result)),
    ]
    answers = "".join(
        f"<dt>{question}</dt><dd>{''.join(map(make_paragraph, sentences))}</dd>"
        for question, sentences in answer_questions(result).items()
    )
    device = result.diagnosis.device
    header = (
        f"<header><h1>{TITLE}: {html.escape(device)}</h1>"
        f'<p class="headline">{html.escape(write_headline(result.diagnosis))}</p>'
        f"<dl>{answers}</dl>{draw_largest(result)}</header>"
    )
    main = "".join(section.markup for section in shown)
    return make_document(
        f"{TITLE}: {device}",
        read_asset(files("pyhrg.gap.report"), "page.css"),
        f"{header}{make_contents(shown)}<main>{main}</main>",
        read_asset(files("pyhrg.gap.report"), "page.js"),
    )


def _build_next_test(result: CampaignDiagnosis) -> str:
    test = result.diagnosis.next_test
    if test is None:
        return make_paragraph("No test is proposed.")
    return f"<p><b>{html.escape(format_name(test.kind))}</b>: {html.escape(test.why)}</p>"


def _build_data(result: CampaignDiagnosis) -> str:
    rows = [
        (
            html.escape(t.test.id),
            html.escape(format_name(t.test.kind)),
            "held out" if t.test.is_holdout else "fitted",
            f"{len(t.log.time):,}",
            f"{t.log.interval:g}",
        )
        for t in result.tests
    ]
    tests = build_table("Tests", ("Test", "Kind", "Role", "Rows", "Interval, s"), rows)
    excluded = result.diagnosis.excluded
    if not excluded:
        return tests + make_paragraph("Nothing was left out.")
    listed = "".join(f"<li>{html.escape(text)}</li>" for text in merge_sources(excluded))
    return f"{tests}<h3>Left out, missing or assumed</h3><ul>{listed}</ul>"
