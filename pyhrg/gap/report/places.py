"""Where the gap lives: test by channel as a heat map, and by coordinate as bars."""

import html
from collections.abc import Sequence

from pyhrg.common.pages.markup import paragraph
from pyhrg.gap.diagnose import Diagnosed
from pyhrg.gap.findings.diagnosis import Where
from pyhrg.gap.report.words import CHANNELS, COORDINATES, bar, markup_table, percent

MOST = 14
"""Bars; what is less is summed up."""


def places(found: Diagnosed) -> str:
    """Both."""
    where = found.diagnosis.where
    if not where:
        return paragraph("Nowhere: no channel of any test has more power than its noise.")
    tests = [t.test.id for t in found.tests if not t.test.is_holdout]
    return _map(where, tests) + _bars(where)


def _map(where: Sequence[Where], tests: Sequence[str]) -> str:
    def share(test: str | None, channel: str | None) -> float:
        return sum(
            w.share for w in where if test in (None, w.test) and channel in (None, w.channel)
        )

    header = ("Test", *(CHANNELS[c].capitalize() for c in CHANNELS), "together")
    rows = [
        (html.escape(test), *(_cell(share(test, c)) for c in CHANNELS), _total(share(test, None)))
        for test in tests
    ]
    rows.append(
        ("together", *(_total(share(None, c)) for c in CHANNELS), _total(share(None, None)))
    )
    title = "Shares of the residual's power beyond the noise, before; tests that were fitted to"
    return f'<div class="heat">{markup_table(title, header, rows)}</div>'


def _cell(share: float) -> str:
    if not share:
        return '<span class="none">–</span>'
    # the eye takes areas for less than they are
    return f'<span class="cell" style="--part:{share**0.5:.3f}">{percent(share)}</span>'


def _total(share: float) -> str:
    told = percent(share) if share < 0.9995 else "100\u00a0%"
    return f"<b>{told}</b>" if share else "–"


def _bars(where: Sequence[Where]) -> str:
    shares: dict[tuple[str, str, int | None], float] = {}
    for w in where:
        key = (w.channel, w.coordinate, w.harmonic)
        shares[key] = shares.get(key, 0.0) + w.share
    order = sorted(shares.items(), key=lambda pair: -pair[1])
    rows = [(_words(*key), percent(share), bar(share)) for key, share in order[:MOST]]
    rest = sum(share for _, share in order[MOST:])
    if rest:
        rows.append((f"{len(order) - MOST} others", percent(rest), bar(rest)))
    title = "The same by what it follows; a pattern that stands still can't tell harmonics apart"
    return markup_table(title, ("Channel and what it follows", "Share", ""), rows)


def _words(channel: str, coordinate: str, harmonic: int | None) -> str:
    of = "" if harmonic is None else f", harmonic {harmonic}"
    return f"{CHANNELS[channel]}: {COORDINATES[coordinate]}{of}"
