"""The report as one HTML page that needs no network and no script, and uses one if it may."""

import html
from collections.abc import Mapping
from importlib.resources import files

from pyhrg.common.pages.markup import paragraph
from pyhrg.common.pages.shell import Anchored, asset, contents, document
from pyhrg.gap.diagnose import Diagnosed
from pyhrg.gap.report.causes import causes, ranking
from pyhrg.gap.report.closing import closing
from pyhrg.gap.report.figures.scales import scales
from pyhrg.gap.report.held_out import held_out
from pyhrg.gap.report.places import places
from pyhrg.gap.report.residuals import residuals
from pyhrg.gap.report.sections import Section
from pyhrg.gap.report.verdict import headline, sentences
from pyhrg.gap.report.words import markup_table, plain

PAGE = "report.html"
TITLE = "Where simulation and gyro part"


def page(found: Diagnosed, sections: Mapping[str, Section] | None = None) -> str:
    """The report; the same diagnosis gives the same bytes.

    Args:
        found: diagnosis, and what it rests on.
        sections: of packages above, by name.
    """
    brought = [Anchored(name, s.title, s.html) for name, s in (sections or {}).items()]
    shown = [*_found(found), *brought, *_rest(found)]
    told = "".join(f"<li>{html.escape(sentence)}</li>" for sentence in sentences(found))
    header = (
        f"<header><h1>{TITLE}: {html.escape(found.diagnosis.device)}</h1>"
        f'<p class="headline">{html.escape(headline(found.diagnosis))}</p><ul>{told}</ul></header>'
    )
    main = "".join(section.markup for section in shown)
    return document(
        f"{TITLE}: {found.diagnosis.device}",
        asset(files("pyhrg.gap.report"), "page.css"),
        f"{header}{contents(shown)}<main>{main}</main>",
        asset(files("pyhrg.gap.report"), "page.js"),
    )


def _found(found: Diagnosed) -> list[Anchored]:
    return [
        Anchored("causes", "What makes the gap", causes(found)),
        Anchored("ranking", "Which sets of effects explain it", ranking(found)),
        Anchored("where", "Where the gap lives", places(found)),
        Anchored("residuals", "Residuals by coordinate", residuals(found)),
        Anchored("held-out", "On held-out tests", held_out(found)),
        Anchored("closing", "How far it closed", closing(found) + scales(found)),
    ]


def _rest(found: Diagnosed) -> list[Anchored]:
    return [
        Anchored("next", "The next test", _next(found)),
        Anchored("data", "What it rests on, and what was left out", _data(found)),
    ]


def _next(found: Diagnosed) -> str:
    test = found.diagnosis.next_test
    if test is None:
        return paragraph("None is proposed.")
    return f"<p><b>{html.escape(plain(test.kind))}</b>: {html.escape(test.why)}</p>"


def _data(found: Diagnosed) -> str:
    rows = [
        (
            html.escape(t.test.id),
            html.escape(plain(t.test.kind)),
            "held out" if t.test.is_holdout else "fitted to",
            f"{len(t.log.time):,}",
            f"{t.log.interval:g}",
        )
        for t in found.tests
    ]
    tests = markup_table("Tests", ("Test", "Kind", "Role", "Rows", "Interval, s"), rows)
    left = found.diagnosis.excluded
    if not left:
        return tests + paragraph("Nothing was left out.")
    listed = "".join(f"<li>{html.escape(sentence)}</li>" for sentence in left)
    return f"{tests}<h3>Left out, missing or taken for granted</h3><ul>{listed}</ul>"
