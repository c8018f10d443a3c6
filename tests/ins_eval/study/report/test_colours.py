"""Colours of the pages: as many as are promised, each unlike every other."""

import re
from importlib.resources import files
from itertools import combinations

import pytest

from ins_eval.study.report.figures.parts import COLOURS
from ins_eval.study.study_file import load_study
from ins_eval.study.tables.columns import PARTS
from pyhrg.common.pages.markup import read_asset
from tests.ins_eval.study.report.colours import SMALLEST_DIFFERENCE, measure_difference

STYLE = read_asset(files("pyhrg.common.pages"), "base.css")
LIGHT, DARK = STYLE.split("@media screen and (prefers-color-scheme:dark)")


@pytest.mark.parametrize("scheme", [LIGHT, DARK], ids=["light", "dark"])
def test_every_colour_is_unlike_the_others_and_the_page(scheme: str) -> None:
    found = dict(re.findall(r"--(c\d+|back|text):(#[0-9a-f]+)", scheme))
    assert set(found) == {*(f"c{number}" for number in range(COLOURS)), "back", "text"}
    for (one, a), (other, b) in combinations(found.items(), 2):
        assert measure_difference(a, b) > SMALLEST_DIFFERENCE, (one, other)
    for number in range(COLOURS):
        assert f".c{number}{{color:var(--c{number})}}" in STYLE


def test_there_are_enough() -> None:
    classes = {mission.mission_class for mission in load_study("standard").missions}
    assert max(len(classes), len(PARTS)) <= COLOURS
