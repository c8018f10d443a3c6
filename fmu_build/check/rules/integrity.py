"""The rule that reads every entry: what a damaged archive would else be found by, many times."""

import zipfile
import zlib

from fmu_build.check.archive import Fmu
from fmu_build.check.rules.rule import Findings, rule

INTACT = "every entry of the archive can be read"


@rule(INTACT)
def intact(fmu: Fmu) -> Findings:
    """ZIP, 4.4.7 (CRC-32); encrypted entries and other methods are another rule's matter."""
    with zipfile.ZipFile(fmu.path) as archive:
        for entry in archive.infolist():
            if entry.flag_bits & 1 or entry.compress_type not in (0, 8):
                continue
            try:
                archive.read(entry)
            except (zipfile.BadZipFile, zlib.error, EOFError) as error:
                yield f"{entry.filename} is damaged: {error}"
