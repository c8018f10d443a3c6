"""A rule: its statement, and a function that yields what violates it."""

from collections.abc import Callable, Iterator

from fmu_build.check.archive import Fmu

Findings = Iterator[str]
Rule = Callable[[Fmu], Findings]

RULES: dict[str, Rule] = {}
"""All rules by what they ask; modules of rules fill it when they are imported."""


def rule(asks: str) -> Callable[[Rule], Rule]:
    """Register a function as a rule."""

    def register(function: Rule) -> Rule:
        RULES[asks] = function
        return function

    return register
