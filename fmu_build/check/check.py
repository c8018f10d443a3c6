"""One check: what was asked, and what was found."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

from pyhrg.common.errors import HrgError


@dataclass(frozen=True)
class Check:
    """What was asked, what was found, and a remark.

    Attributes:
        skipped: why nothing could be asked here, empty where something was.
        asked: whether there was anything to ask.
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
