"""Sections that a caller adds, and what is stated where one fails."""

import json
from collections.abc import Callable

import pytest

from pyhrg.gap.report.sections import Section, make_section


def make_position() -> Section:
    return Section("position", "Position", "<p>1.5 m</p>", {"metres": 1.5})


def fail() -> Section:
    raise ValueError("no <mission>")


def make_infinite() -> Section:
    return Section("position", "Position", "", {"metres": float("inf")})


def test_a_section_is_what_its_function_returns() -> None:
    section = make_section("position", make_position)
    assert (section.file, section.html) == ("position.json", "<p>1.5 m</p>")
    assert json.loads(section.to_json()) == {"metres": 1.5}


@pytest.mark.parametrize(
    ("make", "reason"),
    [(fail, "ValueError: no <mission>"), (make_infinite, "not JSON compliant")],
)
def test_a_section_that_fails_states_it_and_raises_nothing(
    make: Callable[[], Section], reason: str
) -> None:
    section = make_section("position", make)
    assert (section.title, section.file) == ("Position", "position.json")
    assert reason in section.document["failed"]
    assert "<mission>" not in section.html


def test_a_user_can_still_interrupt() -> None:
    def interrupt() -> Section:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        make_section("position", interrupt)
