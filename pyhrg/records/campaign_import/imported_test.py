"""One test of an import."""

from dataclasses import dataclass

from pyhrg.records.campaign_import.mapping import TestMapping
from pyhrg.records.log import Log


@dataclass(frozen=True)
class ImportedTest:
    """A test as it was logged, and as a reader of the campaign will get it.

    Attributes:
        mapping: what the mapping says of the test.
        logged: every row, or longer rows where the mapping asks for them; this is what is written.
        read: what a reader keeps; its exclusions name rows by the lines of the laboratory's file.
    """

    mapping: TestMapping
    logged: Log
    read: Log
