"""Counts of all seeds, and the tables of the results' page that are made of them."""

from dataclasses import replace
from pathlib import Path

from pyhrg.challenge.roster import Settings
from pyhrg.challenge.scoring.named import RefusedCase, ScoredCase
from pyhrg.challenge.scoring.report import Finished
from pyhrg.challenge.truths.truth import Truth
from tests.modules import load_file
from tests.pyhrg.challenge.test_run import NO_GAP

ROOT = Path(__file__).parents[4]
seeds = load_file(ROOT / "benchmarks" / "seeds.py")


def test_the_page_has_the_tables() -> None:
    page = (ROOT / "docs" / "gap-results.md").read_text(encoding="utf-8")
    rows = seeds.read_rows()
    figures = seeds.pool(rows)
    for lines in (seeds.format_pooled(figures), seeds.format_by_seed(rows, figures)):
        assert "\n".join(lines) in page


def test_a_finished_challenge_is_counted() -> None:
    none, single = Truth("none"), Truth("single", ("damping_anisotropy",), strengths=(10.0,))
    cases = [
        ScoredCase("a", none, NO_GAP),
        ScoredCase("b", none, replace(NO_GAP, verdict="unexplained")),
        RefusedCase("c", single, "no test can be used"),
    ]
    row = seeds.count(Finished(Settings({}, 7, 60.0, "good-lab", "full"), cases), "abc")
    assert row["seed"] == "7"
    assert row["commit"] == "abc"
    found = {name: (row[f"{name}: yes"], row[f"{name}: of"]) for name in seeds.TITLES}
    assert found["false alarm without a gap"] == ("1", "2")
    assert found["single: right effect or its class"] == ("0", "1")
    assert found["outside: recognised"] == ("0", "0")
    (alarm, *_) = seeds.pool([row, row])
    assert (alarm.value, alarm.n) == (0.5, 4)
