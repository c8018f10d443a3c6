"""One check: its question, and its findings."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

from pyhrg.common.errors import HrgError


@dataclass(frozen=True)
class Check:
    """One check: its question, its findings, and a remark.

    Attributes:
        skipped: why the check could not run here; empty if it ran.
        asked: whether the file has anything that the check applies to.
    """

    name: str
    findings: list[str] = field(default_factory=list)
    remark: str = ""
    skipped: str = ""
    asked: bool = True


def collect_findings(rule: Callable[[], Iterable[str]]) -> list[str]:
    """Findings of a rule; a number or a document that can't be read is one."""
    try:
        return list(rule())
    except (HrgError, ValueError, KeyError) as error:
        return [f"can't be read: {error}"]
