"""A proposed term: an equation for what has no name, as `diagnosis.json` holds it."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal, cast, get_args

from pyhrg.common.toml_table import TomlTable
from pyhrg.gap.findings.values import (
    parse_interval,
    parse_numbers,
)

Location = Literal[
    "bias", "readout", "damping", "stiffness", "pickoff", "drive", "electronics", "bench"
]
"""Where in the physics a term acts."""


@dataclass(frozen=True)
class Formula:
    """A term as plain text, and as an expression in the variables of the written class."""

    text: str
    modelica: str


@dataclass(frozen=True)
class Term:
    """An equation for a part of the gap that has no name.

    channel, function: of the candidate term.
    beside: other functions of the same coordinate that the cause has beside this one.
    parameters: value of each coefficient; its name ends with its unit.
    interval_95: 95 % interval of each parameter, in the same unit.
    probability: posterior probability of this form.
    discovery_probability: posterior probability that this form or a rival takes part.
    rivals: other forms that these tests can't tell from it, in words, with their posterior
        probabilities; together with that of this form they add up to that of the discovery.
    shrink_percent: share of the excess that causes alone leave on held-out tests in the term's
        channel, which the term removes; None without such tests or without an excess.
    """

    place: Location
    coordinates: tuple[str, ...]
    formula: Formula
    parameters: Mapping[str, float]
    interval_95: Mapping[str, tuple[float, float]]
    probability: float
    discovery_probability: float
    channel: str
    function: str
    rivals: Mapping[str, float] = field(default_factory=dict)
    shrink_percent: float | None = None
    beside: tuple[str, ...] = ()


def parse_term(table: TomlTable) -> Term:
    """A term of `diagnosis.json`."""
    formula = table.table("formula")
    intervals = table.table("interval_95")
    return Term(
        cast(Location, table.text("place", None, get_args(Location))),
        table.texts("coordinates"),
        Formula(formula.text("text", None), formula.text("modelica", None)),
        parse_numbers(table.table("parameters")),
        {name: parse_interval(intervals, name) for name in intervals.values},
        table.number("probability", None, 0.0, 1.0),
        table.number("discovery_probability", None, 0.0, 1.0),
        table.text("channel", None),
        table.text("function", None),
        parse_numbers(table.table("rivals")),
        table.optional_number("shrink_percent"),
        table.texts("beside") if "beside" in table.values else (),
    )
